//! `division-by-zero`: a divisor that is always zero.

use super::survey::Place;
use crate::diagnostic::Diagnostic;
use crate::facts::{Node, NodeKind, Operator};
use crate::network::BoundBlock;
use crate::operand_value::{Number, each_node, number};
use crate::rule::Rule;

pub(super) fn check(place: &Place<'_>, out: &mut Vec<Diagnostic>) {
    // The result, then the dividend.
    for operand in place.bound.facts.operands.iter().skip(2) {
        if is_zero(place, &operand.value) {
            out.push(found(place.bound, &operand.value));
        }
    }
}

/// `/` and `MOD` in a `[CALC]`.
pub(super) fn in_expression(place: &Place<'_>, out: &mut Vec<Diagnostic>) {
    for operand in &place.bound.facts.operands {
        each_node(&operand.value, &mut |node| {
            if let NodeKind::Binary(Operator::Div | Operator::Mod, _, right) = &node.kind
                && is_zero(place, right)
            {
                out.push(found(place.bound, right));
            }
        });
    }
}

fn is_zero(place: &Place<'_>, node: &Node) -> bool {
    number(place.context, place.network.scope, node).is_some_and(Number::is_zero)
}

fn found(bound: &BoundBlock, divisor: &Node) -> Diagnostic {
    Diagnostic::new(
        Rule::DivisionByZero,
        bound.absolute(divisor.range),
        "this divides by zero: every time it runs it is a fault, and no result is written",
    )
    .help("divide by another number, or run the block only while the divisor is not zero")
}
