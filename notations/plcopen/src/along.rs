//! What ladder text has and the standard does not: a project that uses it has units of its own for it, in ST. Three instructions
//! are function blocks; the tags of `SYS` are globals, which a function block sets: the program calls it before all else. Remarks say
//! what they are. The reader takes out again what is as it was written: what was changed since stays, and is read like any other text
//! in ST.

use crate::arrays;
use crate::graph::Kind;
use crate::model::{Body, Project, Role, Type, Unit, UnitKind, Variable};
use crate::own;
use crate::shared;
use ladder_analysis::program::SystemTag;
use ladder_notation::LineColumn;
use std::fmt::Write as _;

/// The remark on a unit.
const ALONG: &str = "of ladder text: written along with what needs it";

/// What the remark on a global ends with that stands for a tag of `SYS`.
const SYSTEM: &str = " of ladder text";

/// The name of the block that sets these globals.
pub(crate) const SYSTEM_BLOCK: &str = "LADDER_SYS";

/// The output of this block that something asks for, so that generators run it.
pub(crate) const RUNS: &str = "runs";

/// What the function is called that passes on a value of an enumeration, before the name of the type: compilers have `MOVE` for
/// elementary types alone.
const MOVE: &str = "LADDER_MOVE_";

const CLOCK: &str = "LADDER_CLOCK";

/// A block: its name in the project, its variables with their types, and what it does.
struct Row {
    name: &'static str,
    /// Of a function.
    returns: Option<&'static str>,
    inputs: &'static [(&'static str, &'static str)],
    outputs: &'static [(&'static str, &'static str)],
    locals: &'static [(&'static str, &'static str)],
    text: &'static str,
}

/// Each may use those above it.
const BLOCKS: &[Row] = &[
    // The time since the evaluation before, while it runs. It starts again after half an hour: a TIME of 32 bits ends after weeks.
    Row {
        name: CLOCK,
        returns: None,
        inputs: &[("RUN", "BOOL")],
        outputs: &[("PASSED", "TIME")],
        locals: &[("timer", "TON"), ("before", "TIME")],
        text: include_str!("along/CLOCK.st"),
    },
    // Some systems count seconds in TIME_TO_LREAL, others milliseconds.
    Row {
        name: own::MILLISECONDS,
        returns: Some("LREAL"),
        inputs: &[("SPAN", "TIME")],
        outputs: &[],
        locals: &[],
        text: include_str!("along/MILLISECONDS.st"),
    },
    Row {
        name: "LADDER_RTO",
        returns: None,
        inputs: &[("IN", "BOOL"), ("PT", "TIME"), ("R", "BOOL")],
        outputs: &[("Q", "BOOL"), ("ET", "TIME")],
        locals: &[("clock", CLOCK)],
        text: include_str!("along/RTO.st"),
    },
    Row {
        name: "LADDER_RTOF",
        returns: None,
        inputs: &[("IN", "BOOL"), ("PT", "TIME"), ("R", "BOOL")],
        outputs: &[("Q", "BOOL"), ("ET", "TIME")],
        locals: &[("clock", CLOCK), ("was_high", "BOOL")],
        text: include_str!("along/RTOF.st"),
    },
    Row {
        name: "LADDER_CTC",
        returns: None,
        inputs: &[("CU", "BOOL"), ("R", "BOOL"), ("PV", "DINT")],
        outputs: &[("Q", "BOOL"), ("CV", "DINT")],
        locals: &[("before", "BOOL")],
        text: include_str!("along/CTC.st"),
    },
];

/// Counters of the standard, for systems that have none of DINT.
const COUNTERS: &[Row] = &[
    Row {
        name: "CTU_DINT",
        returns: None,
        inputs: &[("CU", "BOOL"), ("R", "BOOL"), ("PV", "DINT")],
        outputs: &[("Q", "BOOL"), ("CV", "DINT")],
        locals: &[("before", "BOOL")],
        text: include_str!("along/CTU.st"),
    },
    Row {
        name: "CTD_DINT",
        returns: None,
        inputs: &[("CD", "BOOL"), ("LD", "BOOL"), ("PV", "DINT")],
        outputs: &[("Q", "BOOL"), ("CV", "DINT")],
        locals: &[("before", "BOOL")],
        text: include_str!("along/CTD.st"),
    },
    Row {
        name: "CTUD_DINT",
        returns: None,
        inputs: &[
            ("CU", "BOOL"),
            ("CD", "BOOL"),
            ("R", "BOOL"),
            ("LD", "BOOL"),
            ("PV", "DINT"),
        ],
        outputs: &[("QU", "BOOL"), ("QD", "BOOL"), ("CV", "DINT")],
        locals: &[
            ("was_up", "BOOL"),
            ("was_down", "BOOL"),
            ("up", "BOOL"),
            ("down", "BOOL"),
        ],
        text: include_str!("along/CTUD.st"),
    },
];

/// Puts the units that a written project needs before all others: the block that sets these globals for tags of `SYS`, under this
/// name, and the blocks that units use; counters of DINT too, where that is asked for.
pub(crate) fn add(project: &mut Project, system: &[(SystemTag, String)], name: String, has_counters: bool) {
    if !system.is_empty() {
        project.units.insert(0, system_block(name, system));
    }
    let moves: Vec<Unit> = project
        .types
        .iter()
        .filter(|declared| matches!(declared.ty, Type::Enumeration(_)))
        .map(|declared| move_function(&declared.name))
        .filter(|function| project.units.iter().any(|unit| calls(unit, &function.name)))
        .collect();
    project.units.splice(0..0, moves);
    let counters = if has_counters { COUNTERS } else { &[] };
    for row in BLOCKS.iter().chain(counters).rev() {
        let of_units = project.units.iter().flat_map(|unit| &unit.variables);
        let mut types = of_units
            .chain(&project.globals)
            .map(|variable| &variable.ty)
            .chain(project.types.iter().map(|declared| &declared.ty));
        if types.any(|ty| is_of(ty, row.name)) || project.units.iter().any(|unit| calls(unit, row.name)) {
            project.units.insert(0, block(row));
        }
    }
}

/// Takes these units out of a project, where they are as they were written. The globals of `SYS` have no meaning without theirs.
pub(crate) fn take_out(project: &mut Project) {
    arrays::take_out(project);
    shared::take_out(project);
    let globals: Vec<(SystemTag, String)> = project
        .globals
        .iter()
        .filter_map(|global| Some((system(global)?, global.name.clone())))
        .collect();
    let (mut is_set, mut called, mut moves, mut taken) = (false, Vec::new(), Vec::new(), Vec::new());
    let units = std::mem::take(&mut project.units);
    for unit in units {
        let written = match unit.kind {
            _ if unit.comment.as_deref() != Some(ALONG) => None,
            _ if unit
                .variables
                .iter()
                .any(|variable| variable.role == Role::External) =>
            {
                Some(system_block(unit.name.clone(), &globals))
            }
            _ => match unit.name.strip_prefix(MOVE) {
                Some(ty) => Some(move_function(ty)),
                None => {
                    let mut rows = BLOCKS.iter().chain(COUNTERS);
                    rows.find(|row| row.name == unit.name).map(block)
                }
            },
        };
        if !written.is_some_and(|written| is_same(&written, &unit)) {
            project.units.push(unit);
            continue;
        }
        if unit
            .variables
            .iter()
            .any(|variable| variable.role == Role::External)
        {
            is_set = true;
            called.push(unit.name.clone());
        }
        if unit.name.starts_with(MOVE) {
            moves.push(unit.name.clone());
        }
        project
            .report
            .translated(unit.place, format!("unit {}", unit.name));
        taken.push(unit);
    }
    // What was changed since may use others: each those above it.
    while let Some(unit) = taken.pop() {
        let uses = |other: &Unit| {
            let mut types = other.variables.iter().map(|variable| &variable.ty);
            types.any(|ty| is_of(ty, &unit.name))
                || matches!(&other.body, Body::Text("ST", text, _) if text.contains(&unit.name))
        };
        let mut changed = (project.units.iter()).filter(|other| other.comment.as_deref() == Some(ALONG));
        if changed.any(uses) {
            project.units.insert(0, unit);
        }
    }
    for unit in &mut project.units {
        for name in &called {
            without(unit, name);
        }
        let Body::Graph(graph) = &mut unit.body else {
            continue;
        };
        for node in &mut graph.nodes {
            if let Kind::Block { name, .. } = &mut node.kind
                && moves.contains(name)
            {
                "MOVE".clone_into(name);
            }
        }
    }
    if !is_set {
        for global in project
            .globals
            .iter_mut()
            .filter(|global| system(global).is_some())
        {
            global.comment = global.comment.take().map(|told| format!("once {told}"));
        }
    }
}

/// Takes the calls of a block out of a unit, with its instances.
fn without(unit: &mut Unit, block: &str) {
    unit.variables.retain(|variable| !is_of(&variable.ty, block));
    let Body::Graph(graph) = &mut unit.body else {
        return;
    };
    for node in &mut graph.nodes {
        if matches!(&node.kind, Kind::Block { name, .. } if name == block) {
            node.kind = Kind::Joint;
            node.inputs.clear();
        }
    }
}

/// Whether two units have the same variables, and the same text but for how it is broken into lines.
fn is_same(one: &Unit, other: &Unit) -> bool {
    let (Body::Text("ST", own, _), Body::Text("ST", there, _)) = (&one.body, &other.body) else {
        return false;
    };
    let roles = |unit: &Unit| unit.variables.iter().map(|it| it.role).collect::<Vec<_>>();
    own.split_whitespace().eq(there.split_whitespace())
        && one.variables == other.variables
        && roles(one) == roles(other)
}

/// A tag of `SYS` as a global, or in a unit that uses it.
pub(crate) fn system_variable(tag: SystemTag, name: &str, role: Role) -> Variable {
    Variable {
        comment: (role == Role::Global).then(|| format!("SYS.{}{SYSTEM}", tag.name())),
        ..variable(name, tag.ty().name(), role)
    }
}

/// The tag of `SYS` that a global stands for.
pub(crate) fn system(variable: &Variable) -> Option<SystemTag> {
    let told = variable.comment.as_deref()?.strip_suffix(SYSTEM)?;
    SystemTag::from_name(told.strip_prefix("SYS.")?)
}

/// The block that sets the globals of these tags.
fn system_block(name: String, tags: &[(SystemTag, String)]) -> Unit {
    let mut variables: Vec<Variable> = tags
        .iter()
        .map(|(tag, name)| system_variable(*tag, name, Role::External))
        .collect();
    variables.push(variable("clock", CLOCK, Role::Local));
    variables.push(variable(RUNS, "BOOL", Role::Output));
    let mut text = "clock(RUN := TRUE);\n".to_owned();
    for (tag, name) in tags {
        let told = match tag {
            SystemTag::FirstScan => writeln!(text, "{name} := NOT runs;"),
            SystemTag::Scan => writeln!(text, "IF runs THEN\n    {name} := {name} + 1;\nEND_IF;"),
            SystemTag::Time => writeln!(text, "{name} := {name} + clock.PASSED;"),
            SystemTag::ScanTime => writeln!(text, "{name} := clock.PASSED;"),
            SystemTag::Clock(clock) => {
                let phase = format!("in_{}", tag.name());
                let milliseconds = clock.period() / 1_000_000;
                let (whole, half) = (format!("T#{milliseconds}ms"), format!("T#{}ms", milliseconds / 2));
                variables.push(variable(&phase, "TIME", Role::Local));
                writeln!(
                    text,
                    "{phase} := {phase} + clock.PASSED;\nWHILE {phase} >= {whole} DO\n    {phase} := {phase} - {whole};\nEND_WHILE;\n{name} := {phase} >= {half};"
                )
            }
            SystemTag::Fault | SystemTag::On | SystemTag::Off => Ok(()),
        };
        debug_assert!(told.is_ok());
    }
    text.push_str("runs := TRUE;\n");
    unit(name, UnitKind::FunctionBlock, variables, text)
}

/// The name of the function that passes on a value of an enumeration.
pub(crate) fn move_name(ty: &str) -> String {
    format!("{MOVE}{ty}")
}

fn move_function(ty: &str) -> Unit {
    let name = move_name(ty);
    let text = format!("{name} := IN;\n");
    Unit {
        returns: Some(Type::Named(ty.to_owned())),
        ..unit(
            name,
            UnitKind::Function,
            vec![variable("IN", ty, Role::Input)],
            text,
        )
    }
}

/// Whether a unit calls a function.
fn calls(unit: &Unit, function: &str) -> bool {
    let Body::Graph(graph) = &unit.body else {
        return false;
    };
    let is_call = |text: &str| {
        text.strip_prefix(function)
            .is_some_and(|rest| rest.starts_with('('))
    };
    graph.nodes.iter().any(|node| match &node.kind {
        Kind::Value(text, _) => is_call(text),
        Kind::Block { name, .. } => name == function,
        _ => false,
    })
}

/// Whether a type is this one, or has parts of it.
fn is_of(ty: &Type, name: &str) -> bool {
    match ty {
        Type::Named(named) => named == name,
        Type::Array(_, of) => is_of(of, name),
        Type::Structure(members) => members.iter().any(|member| is_of(&member.ty, name)),
        _ => false,
    }
}

fn block(row: &Row) -> Unit {
    let variables = [
        (Role::Input, row.inputs),
        (Role::Output, row.outputs),
        (Role::Local, row.locals),
    ];
    let variables = variables
        .iter()
        .flat_map(|(role, list)| list.iter().map(|(name, ty)| variable(name, ty, *role)));
    let kind = match row.returns {
        Some(_) => UnitKind::Function,
        None => UnitKind::FunctionBlock,
    };
    Unit {
        returns: row.returns.map(|ty| Type::Named(ty.to_owned())),
        ..unit(
            row.name.to_owned(),
            kind,
            variables.collect(),
            row.text.to_owned(),
        )
    }
}

fn unit(name: String, kind: UnitKind, variables: Vec<Variable>, text: String) -> Unit {
    Unit {
        place: LineColumn::START,
        name,
        kind,
        returns: None,
        variables,
        comment: Some(ALONG.to_owned()),
        body: Body::Text("ST", text, LineColumn::START),
        parts: Vec::new(),
    }
}

fn variable(name: &str, ty: &str, role: Role) -> Variable {
    Variable {
        role,
        ..Variable::local(LineColumn::START, name.to_owned(), Type::Named(ty.to_owned()))
    }
}
