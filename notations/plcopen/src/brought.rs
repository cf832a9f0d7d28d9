//! Function blocks that a project uses and does not declare, and that do otherwise than those of ladder text, or are not among
//! them: each is brought along, written in ladder text, and is from there on a unit like any other.

use crate::graph::{Graph, Kind};
use crate::model::{Body, Evaluation, Project, Role, Type, Unit, UnitKind, Variable};
use crate::own;
use ladder_format::program::{Expression, Path, ProgramSketch};
use ladder_instructions::Op;
use ladder_notation::{LineColumn, blocks};
use ladder_syntax::Name;
use std::collections::HashSet;

/// Their names in the standard, the input that is power, the others as `name:type`, and the texts.
type Row = (
    &'static str,
    &'static str,
    &'static [&'static str],
    &'static [&'static str],
    &'static str,
);

macro_rules! row {
    ($name:literal, $power:literal, $inputs:expr, $outputs:expr) => {
        (
            $name,
            $power,
            $inputs,
            $outputs,
            include_str!(concat!("brought/", $name, ".clad")),
        )
    };
}

/// The additional blocks of Beremiz and OpenPLC, as the annex of IEC 61131-3 has them.
const BLOCKS: &[Row] = &[
    row!("RTC", "", &["IN:BOOL", "PDT:DT"], &["Q:BOOL", "CDT:DT"]),
    row!("SEMA", "", &["CLAIM:BOOL", "RELEASE:BOOL"], &["BUSY:BOOL"]),
    row!(
        "INTEGRAL",
        "",
        &["RUN:BOOL", "R1:BOOL", "XIN:REAL", "X0:REAL", "CYCLE:TIME"],
        &["Q:BOOL", "XOUT:REAL"]
    ),
    row!(
        "DERIVATIVE",
        "",
        &["RUN:BOOL", "XIN:REAL", "CYCLE:TIME"],
        &["XOUT:REAL"]
    ),
    row!(
        "PID",
        "",
        &[
            "AUTO:BOOL",
            "PV:REAL",
            "SP:REAL",
            "X0:REAL",
            "KP:REAL",
            "TR:REAL",
            "TD:REAL",
            "CYCLE:TIME"
        ],
        &["XOUT:REAL"]
    ),
    row!(
        "RAMP",
        "",
        &["RUN:BOOL", "X0:REAL", "X1:REAL", "TR:TIME", "CYCLE:TIME"],
        &["BUSY:BOOL", "XOUT:REAL"]
    ),
    row!(
        "HYSTERESIS",
        "",
        &["XIN1:REAL", "XIN2:REAL", "EPS:REAL"],
        &["Q:BOOL"]
    ),
];

/// Counters that stop at PV and at 0, and count in the type that their name says.
const COUNTERS: &[Row] = &[
    row!("CTU", "CU", &["R:BOOL", "PV:INT"], &["Q:BOOL", "CV:INT"]),
    row!("CTD", "CD", &["LD:BOOL", "PV:INT"], &["Q:BOOL", "CV:INT"]),
    row!(
        "CTUD",
        "CU",
        &["CD:BOOL", "R:BOOL", "LD:BOOL", "PV:INT"],
        &["QU:BOOL", "QD:BOOL", "CV:INT"]
    ),
];

/// Adds the units that a project uses without declaring them.
pub(crate) fn along(project: &mut Project) {
    let mut used: Vec<String> = Vec::new();
    let mut note = |name: &str| {
        if !used.iter().any(|used| used.eq_ignore_ascii_case(name)) {
            used.push(name.to_ascii_uppercase());
        }
    };
    let graphs: Vec<&Graph> = project.units.iter().flat_map(graphs).collect();
    for graph in &graphs {
        for node in &graph.nodes {
            if let Kind::Block { name, code: None, .. } = &node.kind {
                note(name);
            }
        }
    }
    let of_units = project.units.iter().flat_map(|unit| &unit.variables);
    of_units
        .chain(&project.globals)
        .for_each(|variable| named_in(&variable.ty, &mut note));
    project
        .types
        .iter()
        .for_each(|declared| named_in(&declared.ty, &mut note));
    let counted = match project.evaluation {
        Evaluation::EachOutput if !project.is_own => counted(&graphs),
        _ => HashSet::new(),
    };
    used.sort();
    for name in used {
        if project
            .units
            .iter()
            .any(|unit| unit.name.eq_ignore_ascii_case(&name))
        {
            continue;
        }
        let (base, ty) = name.split_once('_').unwrap_or((&name, "INT"));
        let unit = if let Some(row) = BLOCKS.iter().find(|row| row.0 == name) {
            Some(unit(&name, row, "INT"))
        } else {
            let row = COUNTERS
                .iter()
                .find(|row| row.0 == base && counted.contains(base));
            row.filter(|_| matches!(ty, "INT" | "DINT" | "LINT" | "UDINT" | "ULINT"))
                .map(|row| unit(&name, row, ty))
        };
        project.units.extend(unit);
    }
}

fn graphs(unit: &Unit) -> impl Iterator<Item = &Graph> {
    let bodies = unit.parts.iter().map(|part| &part.body).chain([&unit.body]);
    bodies.filter_map(|body| match body {
        Body::Graph(graph) => Some(graph),
        _ => None,
    })
}

/// The types that a type names.
fn named_in(ty: &Type, note: &mut impl FnMut(&str)) {
    match ty {
        Type::Named(name) => note(name),
        Type::Array(_, of) => named_in(of, note),
        Type::Structure(members) => members.iter().for_each(|member| named_in(&member.ty, note)),
        _ => {}
    }
}

/// The counters of which it shows that they stop: something reads their count. One that goes both ways always shows it.
fn counted(graphs: &[&Graph]) -> HashSet<&'static str> {
    let mut counted = HashSet::from(["CTUD"]);
    for graph in graphs {
        for node in &graph.nodes {
            let named = match &node.kind {
                Kind::Contact(text, _)
                | Kind::Coil(text, ..)
                | Kind::Value(text, _)
                | Kind::Variable(text, _) => text.to_ascii_uppercase().contains(".CV"),
                _ => false,
            };
            if named {
                counted.extend(["CTU", "CTD"]);
            }
            for end in node.inputs.iter().flat_map(|pin| &pin.from) {
                let source = &graph.nodes[end.node];
                let is_count = source
                    .outputs
                    .get(end.output)
                    .is_some_and(|output| output.name.eq_ignore_ascii_case("CV"));
                if let (Kind::Block { name, .. }, true) = (&source.kind, is_count) {
                    let upper = name.to_ascii_uppercase();
                    let base = upper.split('_').next().unwrap_or_default();
                    counted.extend(COUNTERS.iter().map(|row| row.0).filter(|name| *name == base));
                }
            }
        }
    }
    counted
}

fn unit(name: &str, row: &Row, ty: &str) -> Unit {
    let (_, power, inputs, outputs, text) = row;
    let place = LineColumn::START;
    let variable = |told: &str, role| {
        let (name, own) = told.split_once(':').unwrap_or((told, "BOOL"));
        let own = if own == "INT" { ty } else { own };
        Variable {
            role,
            ..Variable::local(place, name.to_owned(), Type::Named(own.to_owned()))
        }
    };
    let power = (!power.is_empty()).then(|| Variable {
        comment: Some(own::POWER_IN.to_owned()),
        ..variable(power, Role::Input)
    });
    let inputs = inputs.iter().map(|told| variable(told, Role::Input));
    let outputs = outputs.iter().map(|told| variable(told, Role::Output));
    let text = match ty {
        "INT" => (*text).to_owned(),
        ty => text
            .replace(": INT", &format!(": {ty}"))
            .replace("]\nVAR", &format!("{ty}]\nVAR")),
    };
    Unit {
        place,
        name: name.to_owned(),
        kind: UnitKind::FunctionBlock,
        returns: None,
        variables: power.into_iter().chain(inputs).chain(outputs).collect(),
        comment: None,
        body: Body::Ladder(text),
        parts: Vec::new(),
    }
}

/// The name of the block in a text that was brought along: `CountUp`.
pub(crate) fn name(text: &str) -> Option<&str> {
    text.split_once("[$")?.1.split(']').next()
}

/// Whether power after such a block is this output.
pub(crate) fn is_power(unit: &Unit, output: &str) -> bool {
    let Body::Ladder(text) = &unit.body else {
        return false;
    };
    let mut is_power = false;
    let mut before = None;
    blocks(
        &ProgramSketch::of_text(&ladder_syntax::parse(text)).items,
        &mut |block| {
            let coil = block.only().filter(|_| block.op() == Some(Op::Coil));
            let name = coil
                .and_then(Expression::path)
                .and_then(Path::whole)
                .map(Name::new);
            is_power |= name == Some(Name::new("ENO")) && before == Some(Name::new(output));
            before = name;
        },
    );
    is_power
}
