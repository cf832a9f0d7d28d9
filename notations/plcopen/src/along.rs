//! Blocks of ladder text that the standard does not have: a project that uses them has them as units of its own, in ST. The remark
//! on such a unit says so, and the reader takes it out again.

use crate::model::{Body, Project, Role, Type, Unit, UnitKind, Variable};
use crate::own;
use ladder_notation::LineColumn;

/// A block: its name in the project, its variables with their types, and what it does.
struct Row {
    name: &'static str,
    inputs: &'static [(&'static str, &'static str)],
    outputs: &'static [(&'static str, &'static str)],
    locals: &'static [(&'static str, &'static str)],
    text: &'static str,
}

/// A clock measures the time between two evaluations, and starts again after half an hour: a TIME of 32 bits ends after weeks.
const BLOCKS: &[Row] = &[
    Row {
        name: "LADDER_RTO",
        inputs: &[("IN", "BOOL"), ("PT", "TIME"), ("R", "BOOL")],
        outputs: &[("Q", "BOOL"), ("ET", "TIME")],
        locals: &[("clock", "TON"), ("before", "TIME")],
        text: include_str!("along/RTO.st"),
    },
    Row {
        name: "LADDER_RTOF",
        inputs: &[("IN", "BOOL"), ("PT", "TIME"), ("R", "BOOL")],
        outputs: &[("Q", "BOOL"), ("ET", "TIME")],
        locals: &[("clock", "TON"), ("before", "TIME"), ("was_high", "BOOL")],
        text: include_str!("along/RTOF.st"),
    },
    Row {
        name: "LADDER_CTC",
        inputs: &[("CU", "BOOL"), ("R", "BOOL"), ("PV", "DINT")],
        outputs: &[("Q", "BOOL"), ("CV", "DINT")],
        locals: &[("before", "BOOL")],
        text: include_str!("along/CTC.st"),
    },
];

/// Puts the units that a written project uses before all others.
pub(crate) fn add(project: &mut Project) {
    let is_used = |row: &&Row| {
        let of_units = project.units.iter().flat_map(|unit| &unit.variables);
        let members = project.types.iter().map(|declared| &declared.ty);
        let mut types = of_units
            .chain(&project.globals)
            .map(|variable| &variable.ty)
            .chain(members);
        types.any(|ty| is_of(ty, row.name))
    };
    let used: Vec<Unit> = BLOCKS.iter().filter(is_used).map(unit).collect();
    project.units.splice(0..0, used);
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

fn unit(row: &Row) -> Unit {
    let variables = [
        (Role::Input, row.inputs),
        (Role::Output, row.outputs),
        (Role::Local, row.locals),
    ];
    let variables = variables.iter().flat_map(|(role, list)| {
        list.iter().map(|(name, ty)| Variable {
            role: *role,
            ..Variable::local(
                LineColumn::START,
                (*name).to_owned(),
                Type::Named((*ty).to_owned()),
            )
        })
    });
    Unit {
        place: LineColumn::START,
        name: row.name.to_owned(),
        kind: UnitKind::FunctionBlock,
        returns: None,
        variables: variables.collect(),
        comment: Some(own::ALONG.to_owned()),
        body: Body::Text("ST", row.text.to_owned()),
        parts: Vec::new(),
    }
}
