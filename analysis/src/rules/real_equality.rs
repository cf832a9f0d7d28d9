//! `real-equality`: real numbers are compared for being exactly equal.

use super::survey::SurveyedBlock;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::names::operand_value::{Number, each_node};
use crate::written::facts::{Node, NodeKind, Operator};
use ladder_instructions::Op;
use ladder_syntax::TextRange;

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Blocks, "real-equality", Severity::Warning).about_types());

pub(super) fn check(place: &SurveyedBlock<'_>, out: &mut Vec<Diagnostic>) {
    match place.op() {
        Some(Op::Eq | Op::Ne) => {}
        Some(Op::Calc) => return in_expression(place, out),
        _ => return,
    }
    let operands = || place.bound.facts.operands.iter().map(|operand| &operand.value);
    if compares_reals(place, operands()) {
        let negated = place.bound.op() == Some(Op::Ne);
        out.push(found(place.bound.range(), negated));
    }
}

/// `=` and `<>` in a `[CALC]`.
fn in_expression(place: &SurveyedBlock<'_>, out: &mut Vec<Diagnostic>) {
    for operand in &place.bound.facts.operands {
        each_node(&operand.value, &mut |node| {
            let NodeKind::Binary(operator @ (Operator::Equal | Operator::NotEqual), left, right) = &node.kind
            else {
                return;
            };
            if compares_reals(place, [&**left, &**right].into_iter()) {
                let range = place.bound.absolute(node.range);
                out.push(found(range, *operator == Operator::NotEqual));
            }
        });
    }
}

/// Zero is exact: nothing is wrong with guarding a division.
fn compares_reals<'n>(place: &SurveyedBlock<'_>, mut nodes: impl Iterator<Item = &'n Node> + Clone) -> bool {
    let tags = place.tags;
    let is_zero = |node: &Node| tags.number(node).is_some_and(Number::is_zero);
    nodes.clone().any(|node| tags.is_real(node)) && !nodes.any(is_zero)
}

fn found(range: TextRange, negated: bool) -> Diagnostic {
    let message = if negated {
        "two real numbers are nearly always unequal: this conducts although they are as good as the same"
    } else {
        "two real numbers are nearly never exactly equal: this may not conduct when it should"
    };
    Diagnostic::new(RULE, range, message)
        .help("compare with a tolerance: one [GE] for the lower and one [LE] for the upper limit")
}
