//! `ambiguous-sign`: `-a ^ b`, which people read in two ways.

use super::survey::SurveyedBlock;
use crate::findings::diagnostic::{Applicability, Diagnostic, Fix};
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::names::operand_value::each_node;
use crate::values::literal::Literal;
use crate::written::facts::{Node, NodeKind, Operator};
use ladder_format::Edit;
use ladder_instructions::Op;
use ladder_syntax::TextRange;

pub(crate) const RULE: Rule = Rule(&RuleFacts::new(
    RuleGroup::Blocks,
    "ambiguous-sign",
    Severity::Info,
));

pub(super) fn check(place: &SurveyedBlock<'_>, out: &mut Vec<Diagnostic>) {
    if place.op() != Some(Op::Calc) {
        return;
    }
    for operand in &place.bound.facts.operands {
        each_node(&operand.value, &mut |node| {
            let NodeKind::Binary(Operator::Power, base, _) = &node.kind else {
                return;
            };
            if !has_sign(base) {
                return;
            }
            let base = place.bound.absolute(base.range);
            let mut found = Diagnostic::new(
                RULE,
                place.bound.absolute(node.range),
                "the sign is taken before the power: -2 ^ 2 is 4 here, and -4 in mathematics",
            )
            .help("show with parentheses what is meant: (-a) ^ b, or -(a ^ b)");
            let parenthesis = |at, text: &str| Edit {
                range: TextRange::empty(at),
                text: text.to_owned(),
            };
            let edits = vec![parenthesis(base.start(), "("), parenthesis(base.end(), ")")];
            let title = "Put parentheses around what it means now";
            found.fixes.push(Fix::new(Applicability::Safe, title, edits));
            out.push(found);
        });
    }
}

fn has_sign(node: &Node) -> bool {
    match &node.kind {
        NodeKind::Unary(Operator::Sub, _) => true,
        _ => match node.literal() {
            Some(Literal::Int(n)) => *n < 0,
            Some(Literal::Real(r)) => *r < 0.0,
            _ => false,
        },
    }
}
