//! What the writer adds to a project so that it means the same there, and the reader takes out again. The remark on a
//! variable says so, for people and for the reader.

use crate::graph::Kind;
use crate::model::{Body, Role, Unit, Variable};

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

/// What a TIME as a number is divided by: some systems count seconds there, others milliseconds.
const ONE: &str = "TIME_TO_LREAL(T#1ms)";

/// A TIME as a number of milliseconds, in any system.
pub(crate) fn milliseconds(time: &str) -> String {
    format!("TIME_TO_LREAL({time}) / {ONE}")
}

/// The TIME of which an expression is the number of milliseconds.
pub(crate) fn in_milliseconds(text: &str) -> Option<&str> {
    let time = text
        .trim()
        .strip_suffix(ONE)?
        .trim_end()
        .strip_suffix('/')?
        .trim_end();
    let time = time.strip_prefix("TIME_TO_LREAL(")?.strip_suffix(')')?;
    (!time.contains(['(', ')'])).then_some(time)
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
        if matches!(&node.kind, Kind::Coil(tag, ..) if sinks.iter().any(|sink| sink.eq_ignore_ascii_case(tag)))
        {
            node.kind = Kind::Joint;
            node.inputs.clear();
        }
    }
}
