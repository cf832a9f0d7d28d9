//! Units that files of a folder have in Structured Text: they are written as they are there.

use crate::declarations::{Declared, without_comments};
use crate::graph::Kind;
use crate::model::{Body, Project, Role, Type, Unit, UnitKind, Variable};
use crate::own::{POWER_IN, POWER_OUT};
use ladder_notation::{LineColumn, Project as Files, Report, WriteError};
use ladder_notation_st::read::{UnitText, unit_texts};
use std::collections::HashMap;

/// Puts the units of such files in the place of those that stand for them.
pub(super) fn put_back(
    files: &Files,
    project: &mut Project,
    programs: &HashMap<usize, String>,
    reports: &mut [Report],
) -> Result<(), WriteError> {
    for (number, report) in reports.iter_mut().enumerate() {
        let Some(text) = files.written(number) else {
            continue;
        };
        let wrong = |why: &str| WriteError::new(format!("{}: {why}", files.file(number)));
        // Of the networks it is that something is reported.
        report.entries.clear();
        for written in unit_texts(text).map_err(|why| wrong(&why))? {
            let mut unit = unit_of(text, &written, report).map_err(|why| wrong(&why))?;
            match unit.kind {
                UnitKind::Program => match programs.get(&number) {
                    Some(name) => unit.name.clone_from(name),
                    None => continue,
                },
                _ => unit.name = super::identifier(&unit.name),
            }
            let mut units = project.units.iter();
            let Some(at) = units.position(|drawn| drawn.name.eq_ignore_ascii_case(&unit.name)) else {
                let why = "its name is another one in what is written: give it one that nothing else has";
                report.refused(LineColumn::START, format!("unit {}", unit.name), why);
                continue;
            };
            let drawn = std::mem::replace(&mut project.units[at], unit);
            if !fit_calls(project, &drawn, at) {
                let why = "a drawing runs it with and without power, for which its text has no pin: call it at the left rail";
                report.refused(LineColumn::START, format!("unit {}", drawn.name), why);
            }
        }
    }
    Ok(())
}

/// The function that a drawing has as a block with an instance, as blocks in ladder text are drawn: it has none there.
pub(crate) fn function_as_block<'u>(unit: &'u Unit, project: &Project) -> Option<&'u str> {
    let Body::Graph(graph) = &unit.body else {
        return None;
    };
    let mut blocks = graph.nodes.iter().filter_map(|node| match &node.kind {
        Kind::Block {
            name,
            instance: Some(_),
            ..
        } => Some(name.as_str()),
        _ => None,
    });
    let is_function = |name: &&str| {
        let mut named = project
            .units
            .iter()
            .filter(|unit| unit.name.eq_ignore_ascii_case(name));
        named.any(|unit| unit.kind == UnitKind::Function)
    };
    blocks.find(is_function)
}

/// Calls in drawings have the pins of a text, which runs where it has power. Whether it always has, as what was drawn of it needs.
fn fit_calls(project: &mut Project, drawn: &Unit, at: usize) -> bool {
    let is_pin = |variable: &&Variable| {
        let told = variable.comment.as_deref();
        !matches!(told, Some(POWER_IN | POWER_OUT))
    };
    let mut pins: HashMap<&str, &str> = HashMap::new();
    let written = project.units[at].clone();
    for role in [Role::Input, Role::Output, Role::InOut] {
        let drawn = drawn.variables.iter().filter(is_pin);
        let drawn = drawn.filter(|variable| variable.role == role);
        let written = written.variables.iter().filter(|variable| variable.role == role);
        pins.extend(
            drawn
                .zip(written)
                .map(|(one, other)| (one.name.as_str(), other.name.as_str())),
        );
    }
    for variable in &drawn.variables {
        match variable.comment.as_deref() {
            Some(POWER_IN) => drop(pins.insert(&variable.name, "EN")),
            Some(POWER_OUT) => drop(pins.insert(&variable.name, "ENO")),
            _ => {}
        }
    }
    let mut always = true;
    for unit in &mut project.units {
        let Body::Graph(graph) = &mut unit.body else {
            continue;
        };
        for node in 0..graph.nodes.len() {
            let is_call = matches!(&graph.nodes[node].kind, Kind::Block { name, .. } if name.eq_ignore_ascii_case(&drawn.name));
            if !is_call {
                continue;
            }
            let own = &graph.nodes[node];
            let enables = own
                .inputs
                .iter()
                .filter(|pin| pins.get(pin.name.as_str()) == Some(&"EN"));
            let mut sources = enables.flat_map(|pin| &pin.from);
            always &= sources.all(|end| graph.nodes[end.node].kind == Kind::LeftRail);
            let own = &mut graph.nodes[node];
            for name in own
                .inputs
                .iter_mut()
                .map(|pin| &mut pin.name)
                .chain(own.outputs.iter_mut().map(|pin| &mut pin.name))
            {
                if let Some(there) = pins.get(name.as_str()) {
                    *name = (*there).to_owned();
                }
            }
        }
    }
    always
}

/// A unit as its text has it.
fn unit_of(text: &str, written: &UnitText, report: &mut Report) -> Result<Unit, String> {
    let head = &text[written.head.clone()];
    let plain = without_comments(head);
    let declared = Declared {
        text: head,
        plain: &plain,
        place: &|_| LineColumn::START,
    };
    let mut unit = declared.unit(report).map_err(|error| error.message)?;
    unit.comment.clone_from(&written.comment);
    if let Some(other) = unit.variables.iter().find(|one| matches!(one.ty, Type::Other(_))) {
        return Err(format!("the type of `{}` has no counterpart there", other.name));
    }
    let body = text[written.body.clone()]
        .trim_start_matches(['\r', '\n'])
        .trim_end();
    unit.body = Body::Text("ST", format!("{body}\n"), LineColumn::START);
    Ok(unit)
}
