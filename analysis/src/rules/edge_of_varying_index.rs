//! `edge-of-varying-index`: an edge contact on an element whose index is computed.
//!
//! The memory of the edge belongs to the contact, not to the element: where the index changes, two elements are compared.

use super::survey::SurveyedBlock;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::written::facts::{Node, NodeKind};
use ladder_instructions::Op;

pub(crate) const RULE: Rule = Rule(&RuleFacts::new(
    RuleGroup::Program,
    "edge-of-varying-index",
    Severity::Warning,
));

pub(super) fn check(block: &SurveyedBlock<'_>, out: &mut Vec<Diagnostic>) {
    let bound = block.bound;
    if !matches!(bound.op(), Some(Op::RisingContact | Op::FallingContact)) {
        return;
    }
    let Some(operand) = bound.facts.operands.first() else {
        return;
    };
    if let Some(index) = varying(block, &operand.value) {
        let message =
            "the index of this edge contact is computed: where it changes, two elements are compared";
        out.push(
            Diagnostic::new(RULE, bound.absolute(index.range), message)
                .help("the edge belongs to the contact: put a contact with a fixed index before [OSR], or one for each element"),
        );
    }
}

/// The first index of a path that is not a number and no constant.
fn varying<'n>(block: &SurveyedBlock<'_>, node: &'n Node) -> Option<&'n Node> {
    match &node.kind {
        NodeKind::Member(base, _) | NodeKind::Paren(base) => varying(block, base),
        NodeKind::Index(base, index) => {
            varying(block, base).or_else(|| block.tags.number(index).is_none().then_some(&**index))
        }
        _ => None,
    }
}
