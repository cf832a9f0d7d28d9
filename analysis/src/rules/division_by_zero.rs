//! `division-by-zero`: a divisor that is always zero.

use super::survey::SurveyedBlock;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::names::operand_value::{Number, each_node};
use crate::written::facts::{Node, NodeKind, Operator};
use ladder_instructions::Division;
use ladder_instructions::Op;

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Blocks, "division-by-zero", Severity::Warning).about_types());

pub(super) fn check(place: &SurveyedBlock<'_>, out: &mut Vec<Diagnostic>) {
    match place.op() {
        Some(Op::Div | Op::Mod) => {}
        Some(Op::Calc) => return in_expression(place, out),
        _ => return,
    }
    // The result, then the dividend.
    for operand in place.bound.facts.operands.iter().skip(2) {
        if is_zero(place, &operand.value) {
            out.push(found(place, &operand.value));
        }
    }
}

/// `/` and `MOD` in a `[CALC]`.
fn in_expression(place: &SurveyedBlock<'_>, out: &mut Vec<Diagnostic>) {
    for operand in &place.bound.facts.operands {
        each_node(&operand.value, &mut |node| {
            if let NodeKind::Binary(Operator::Div | Operator::Mod, _, right) = &node.kind
                && is_zero(place, right)
            {
                out.push(found(place, right));
            }
        });
    }
}

fn is_zero(place: &SurveyedBlock<'_>, node: &Node) -> bool {
    place.tags.number(node).is_some_and(Number::is_zero)
}

fn found(place: &SurveyedBlock<'_>, divisor: &Node) -> Diagnostic {
    let what = match place.tags.profile().semantics().division {
        Division::Fault => "it is a fault, and no result is written",
        Division::ZeroAndEnd => "the result is 0, and the scan is the last one",
        Division::Dividend => "the result is the dividend, or 0 for a remainder",
        Division::Zero => "the result is 0, and the controller tells of an error",
    };
    Diagnostic::new(
        RULE,
        place.bound.absolute(divisor.range),
        format!("this divides by zero: every time it runs {what}"),
    )
    .help("divide by another number, or run the block only while the divisor is not zero")
}
