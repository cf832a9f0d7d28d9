//! `short-preset`: a timer's time is shorter than a scan.

use super::survey::Place;
use crate::diagnostic::Diagnostic;
use crate::facts::{Node, NodeKind};
use crate::literal::Literal;
use crate::network::Formal;
use crate::operand_value::{Number, number, scalar};
use crate::rule::Rule;
use crate::types::Scalar;
use ladder_instructions::Accepts;

const MILLISECOND: i128 = 1_000_000;

pub(super) fn check(place: &Place<'_>, out: &mut Vec<Diagnostic>) {
    let bound = place.bound;
    let mut operands = bound.facts.operands.iter().zip(bound.formals.iter());
    let Some((operand, _)) = operands
        .find(|(_, formal)| matches!(formal, Formal::Operand(row) if row.accepts == Accepts::Duration))
    else {
        return;
    };
    let Some(Number::Int(value)) = number(place.context, place.network.scope, &operand.value) else {
        return;
    };
    // A plain integer is milliseconds.
    let plain = is_integer(place, &operand.value);
    let preset = if plain { value * MILLISECOND } else { value };
    let scan = i128::from(place.settings.scan_interval);
    if !(0..scan).contains(&preset) {
        return;
    }
    let message = if preset == 0 {
        "the preset is 0: the timer does not wait".to_owned()
    } else {
        format!(
            "the preset is shorter than a scan of {}: the timer cannot tell it from one scan",
            milliseconds(scan)
        )
    };
    let found = Diagnostic::new(Rule::ShortPreset, bound.absolute(operand.value.range), message);
    out.push(if plain && value > 0 {
        found.help(format!(
            "a plain number is milliseconds: {value} s is written T#{value}s"
        ))
    } else {
        found.help("give a time of at least a scan, or leave the timer out")
    });
}

fn is_integer(place: &Place<'_>, node: &Node) -> bool {
    match &node.kind {
        NodeKind::Literal(Ok(Literal::Int(_))) => true,
        NodeKind::Literal(_) => false,
        _ => scalar(place.context, place.network.scope, node).is_some_and(Scalar::is_integer),
    }
}

fn milliseconds(nanoseconds: i128) -> String {
    format!("{} ms", nanoseconds as f64 / MILLISECOND as f64)
}
