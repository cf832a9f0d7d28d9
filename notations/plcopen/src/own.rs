//! What the writer adds to a project so that it means the same there, and the reader takes out again. The remark on a
//! variable says so, for people and for the reader.

use crate::graph::{End, Graph, Kind, Node, Pin};
use crate::model::{Body, Role, Unit, Variable};
use ladder_analysis::values::types::Scalar;
use std::collections::HashSet;

/// The company of a project that is written: editors put something there. In such a project standard blocks mean those of
/// ladder text, as counters that go on past PV.
pub(crate) const COMPANY: &str = "";

/// The remark on the input of a block that is its EN: an IEC block without power does not run at all, one of ladder text
/// always does.
pub(crate) const POWER_IN: &str = "EN of the block in ladder text";

/// The remark on the output that is its ENO.
pub(crate) const POWER_OUT: &str = "ENO of the block in ladder text";

/// The remark on a variable that power ends in. Generators run a block when something after it asks for it.
pub(crate) const SINK: &str = "takes power that nothing else takes, so that its block runs in its turn";

/// The function that makes a number of milliseconds of a TIME: it is written along.
pub(crate) const MILLISECONDS: &str = "LADDER_MILLISECONDS";

/// A TIME as a number of milliseconds, in any system.
pub(crate) fn milliseconds(time: &str) -> String {
    format!("{MILLISECONDS}({time})")
}

/// The TIME of which an expression is the number of milliseconds.
pub(crate) fn in_milliseconds(text: &str) -> Option<&str> {
    let time = text.trim().strip_prefix(MILLISECONDS)?;
    let time = time.trim_start().strip_prefix('(')?.strip_suffix(')')?;
    (!time.contains(['(', ')'])).then_some(time)
}

/// A bit of a number, which generators know no name for.
pub(crate) fn bit(number: &str, ty: Scalar, bit: u8) -> String {
    let bits = match ty.width() {
        8 => "BYTE",
        16 => "WORD",
        32 => "DWORD",
        _ => "LWORD",
    };
    let number = if ty.is_bits() {
        number.to_owned()
    } else {
        format!("{}_TO_{bits}({number})", ty.name())
    };
    format!("({number} AND {}) <> 0", 1u64 << bit)
}

/// The bit that an expression is: of which number, and which one.
pub(crate) fn as_bit(text: &str) -> Option<(&str, u32)> {
    let inside = text.trim().strip_prefix('(')?.strip_suffix(") <> 0")?;
    let (number, mask) = inside.split_once(" AND ")?;
    let mask: u64 = mask.parse().ok().filter(|mask: &u64| mask.is_power_of_two())?;
    let number = match number.split_once("_TO_") {
        Some((_, call)) => call.split_once('(')?.1.strip_suffix(')')?,
        None => number,
    };
    let is_path = number
        .chars()
        .all(|c| c.is_alphanumeric() || "_.[], ".contains(c));
    is_path.then(|| (number, mask.trailing_zeros()))
}

/// The expression that is true where a bit is low, of the expression for that bit.
pub(crate) fn low(bit: &str) -> Option<String> {
    as_bit(bit)?;
    Some(format!("{} = 0", bit.strip_suffix(" <> 0")?))
}

/// The bit that is low where an expression is true.
fn is_low(text: &str) -> Option<String> {
    let bit = format!("{} <> 0", text.strip_suffix(" = 0")?);
    as_bit(&bit).is_some().then_some(bit)
}

/// Makes blocks again of comparisons of names, which are expressions in a project, and bits of their comparisons: see the writer.
pub(crate) fn with_comparisons(unit: &mut Unit) {
    let Body::Graph(graph) = &mut unit.body else {
        return;
    };
    let mut in_formulas = HashSet::new();
    for node in &graph.nodes {
        if matches!(&node.kind, Kind::Block { name, .. } if name == "MOVE") {
            in_formulas.extend(
                node.inputs
                    .iter()
                    .filter(|pin| pin.name == "IN")
                    .flat_map(|pin| &pin.from)
                    .map(|end| end.node),
            );
        }
    }
    for node in 0..graph.nodes.len() {
        let Kind::Value(text, false) = &graph.nodes[node].kind else {
            continue;
        };
        if let Some(bit) = is_low(text) {
            graph.nodes[node].kind = Kind::Value(bit, true);
            continue;
        }
        let Some((name, sides)) = comparison(text).filter(|_| !in_formulas.contains(&node)) else {
            continue;
        };
        let (place, position) = (graph.nodes[node].place, graph.nodes[node].position);
        for (side, pin) in sides.into_iter().zip(["IN1", "IN2"]) {
            let value = Node::new(place, Kind::Value(side, false), Vec::new());
            let from = vec![End {
                node: graph.nodes.len(),
                output: 0,
            }];
            graph.nodes.push(Node { position, ..value });
            graph.nodes[node].inputs.push(Pin {
                name: pin.to_owned(),
                from,
                ..Pin::default()
            });
        }
        graph.nodes[node].kind = Kind::Block {
            name: name.to_owned(),
            instance: None,
            code: None,
        };
    }
}

/// A comparison of two names: the block that does that, and the names.
fn comparison(text: &str) -> Option<(&'static str, [String; 2])> {
    let (name, (one, other)) = match text.split_once(" <> ") {
        Some(sides) => ("NE", sides),
        None => ("EQ", text.split_once(" = ")?),
    };
    let is_name = |side: &str| side.chars().all(|c| c.is_alphanumeric() || "_.[], ".contains(c));
    (is_name(one) && is_name(other)).then(|| (name, [one.to_owned(), other.to_owned()]))
}

/// Takes out the conversions of what LEN and FIND give, which are INT for compilers alone: what takes them takes that.
pub(crate) fn without_conversions(unit: &mut Unit) {
    let Body::Graph(graph) = &mut unit.body else {
        return;
    };
    for conversion in 0..graph.nodes.len() {
        let Some([power, value]) = converted(graph, conversion) else {
            continue;
        };
        let pins = graph.nodes.iter_mut().flat_map(|node| &mut node.inputs);
        for end in pins.flat_map(|pin| &mut pin.from) {
            if end.node == conversion {
                *end = if end.output == 0 { power } else { value };
            }
        }
        graph.nodes[conversion].kind = Kind::Joint;
        graph.nodes[conversion].inputs.clear();
    }
}

/// ENO and the result of the LEN or FIND that a node converts, if it is such a conversion.
fn converted(graph: &Graph, conversion: usize) -> Option<[End; 2]> {
    let called = |node: usize| match &graph.nodes[node].kind {
        Kind::Block { name, .. } => Some(name.as_str()),
        _ => None,
    };
    let [enable, value] = &graph.nodes[conversion].inputs[..] else {
        return None;
    };
    let ([power], [value]) = (&enable.from[..], &value.from[..]) else {
        return None;
    };
    let is_one = power.node == value.node
        && called(conversion)?.starts_with("INT_TO_")
        && matches!(called(value.node)?, "LEN" | "FIND");
    is_one.then_some([*power, *value])
}

/// Which of EN and ENO a variable of a block stands for.
pub(crate) fn power(variable: &Variable) -> Option<&'static str> {
    match (variable.role, variable.comment.as_deref()?) {
        (Role::Input, POWER_IN) => Some("EN"),
        (Role::Output, POWER_OUT) => Some("ENO"),
        _ => None,
    }
}

/// Takes the ends of power out of a unit, with their variables.
pub(crate) fn without_sinks(unit: &mut Unit) {
    let is_sink = |variable: &Variable| variable.comment.as_deref() == Some(SINK);
    let sinks: Vec<String> = unit
        .variables
        .iter()
        .filter(|variable| is_sink(variable))
        .map(|variable| variable.name.clone())
        .collect();
    let Body::Graph(graph) = &mut unit.body else {
        return;
    };
    if sinks.is_empty() {
        return;
    }
    unit.variables.retain(|variable| !is_sink(variable));
    for node in &mut graph.nodes {
        if matches!(&node.kind, Kind::Coil(tag, ..) | Kind::Variable(tag, _) if sinks.iter().any(|sink| sink.eq_ignore_ascii_case(tag)))
        {
            node.kind = Kind::Joint;
            node.inputs.clear();
        }
    }
}
