//! The tags of `SYS`: globals that a small program in ST sets before the others run. Each says in its remark what it is.

use super::unit::Unit;
use crate::model::{Body as Does, Project, Role, Type, Unit as Made, UnitKind, Variable};
use crate::own;
use ladder_analysis::context::Body;
use ladder_analysis::names::system_tag::SystemTag;
use ladder_notation::LineColumn;
use std::fmt::Write as _;

/// The name of the program that sets the globals.
pub(super) const NAME: &str = "LADDER_SYS";

/// The key of a system tag among the names of a unit.
pub(super) fn key(tag: SystemTag) -> String {
    format!("SYS.{}", tag.name())
}

/// Whether there is a global for it: ON and OFF are literals, and nothing there counts faults.
pub(super) fn is_written(tag: SystemTag) -> bool {
    !matches!(tag, SystemTag::On | SystemTag::Off | SystemTag::Fault)
}

/// The system tags that the networks of a unit name: of the program of the file, or of one of its blocks.
pub(super) fn used(unit: &Unit<'_>, block: Option<usize>) -> Vec<SystemTag> {
    let context = unit.context();
    let own = context
        .networks
        .iter()
        .filter(|network| match (context.bodies[network.index], block) {
            (Body::Block(own), Some(block)) => own == block,
            (Body::Block(_), None) | (_, Some(_)) => false,
            (_, None) => true,
        });
    let text: String = own
        .map(|network| unit.text[network.range].to_ascii_uppercase())
        .collect();
    let is_named = |tag: &SystemTag| {
        let key = key(*tag);
        text.match_indices(&key).any(|(at, _)| {
            let next = text[at + key.len()..].chars().next();
            !next.is_some_and(|c| c.is_alphanumeric() || c == '_')
        })
    };
    let all = SystemTag::ALL.into_iter();
    all.filter(|tag| is_written(*tag)).filter(is_named).collect()
}

/// A system tag as a global, or in a unit that uses it.
pub(super) fn variable(tag: SystemTag, name: &str, role: Role) -> Variable {
    let ty = Type::Named(tag.ty().name().to_owned());
    Variable {
        role,
        comment: (role == Role::Global).then(|| own::system_remark(tag)),
        ..Variable::local(LineColumn::START, name.to_owned(), ty)
    }
}

/// The program that sets these globals. It runs before all others.
pub(super) fn add(project: &mut Project, tags: &[(SystemTag, String)], program: String) {
    if tags.is_empty() {
        return;
    }
    let local = |name: &str, ty: &str| {
        Variable::local(LineColumn::START, name.to_owned(), Type::Named(ty.to_owned()))
    };
    let mut variables: Vec<Variable> = tags
        .iter()
        .map(|(tag, name)| variable(*tag, name, Role::External))
        .collect();
    let locals = [
        ("clock", "TON"),
        ("before", "TIME"),
        ("passed", "TIME"),
        ("runs", "BOOL"),
    ];
    variables.extend(locals.map(|(name, ty)| local(name, ty)));
    // The clock starts again after half an hour: a TIME of 32 bits ends after weeks.
    let mut text = "clock(IN := TRUE, PT := T#1h);
passed := clock.ET - before;
before := clock.ET;
IF before >= T#30m THEN
    clock(IN := FALSE, PT := T#1h);
    clock(IN := TRUE, PT := T#1h);
    before := T#0s;
END_IF;
"
    .to_owned();
    for (tag, name) in tags {
        let said = match tag {
            SystemTag::FirstScan => writeln!(text, "{name} := NOT runs;"),
            SystemTag::Scan => writeln!(text, "IF runs THEN\n    {name} := {name} + 1;\nEND_IF;"),
            SystemTag::Time => writeln!(text, "{name} := {name} + passed;"),
            SystemTag::ScanTime => writeln!(text, "{name} := passed;"),
            SystemTag::Clock(clock) => {
                let phase = format!("in_{}", tag.name());
                let (whole, half) = (clock.period(), clock.period() / 2);
                let (whole, half) = (super::text::time(whole), super::text::time(half));
                variables.push(local(&phase, "TIME"));
                writeln!(
                    text,
                    "{phase} := {phase} + passed;\nWHILE {phase} >= {whole} DO\n    {phase} := {phase} - {whole};\nEND_WHILE;\n{name} := {phase} >= {half};"
                )
            }
            SystemTag::Fault | SystemTag::On | SystemTag::Off => Ok(()),
        };
        debug_assert!(said.is_ok());
    }
    text.push_str("runs := TRUE;\n");
    for task in &mut project.tasks {
        task.programs.insert(0, (LineColumn::START, program.clone()));
    }
    let unit = Made {
        place: LineColumn::START,
        name: program,
        kind: UnitKind::Program,
        returns: None,
        variables,
        comment: Some(own::ALONG.to_owned()),
        body: Does::Text("ST", text),
        parts: Vec::new(),
    };
    project.units.insert(0, unit);
}
