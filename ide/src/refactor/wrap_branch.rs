//! A parallel branch around the selected contacts that holds a copy of them, to be changed afterwards.

use super::insert_branch::first_name;
use super::place::{OnNetwork, Selected};
use super::{Action, ActionKind};
use crate::drawing::beside::{self, Side};
use crate::drawing::carry::{copied, fresh};
use crate::drawing::item::{Item, ItemKind};
use crate::drawing::region::Region;
use crate::drawing::rows::Drawing;
use crate::drawing::term::normal;
use ladder_analysis::networks::network::BoundBlock;
use ladder_analysis::written::facts::{Node, NodeKind};
use ladder_format::Circuit;
use ladder_instructions::Op;

pub(super) fn offer(place: &Selected<'_>, out: &mut Vec<Action>) {
    let Some(on) = &place.on else { return };
    let Some(region) = on.region() else { return };
    let Some(drawing) = doubled(on, &region) else {
        return;
    };
    let title = format!(
        "Wrap `{}` in a branch, with a copy in parallel (changes nothing yet)",
        first_name(on, &region)
    );
    let numbers = region.blocks(&on.drawing);
    if let Some(block) = on.blocks(&numbers).find(|block| !only_reads(block)) {
        let why = format!(
            "{} has an effect or a memory, and a copy would have them once more",
            block.head_text()
        );
        out.push(Action::disabled(ActionKind::Rewrite, title, why));
        return;
    }
    out.push(Action::new(ActionKind::Rewrite, title, vec![drawing.replace()]));
}

/// Whether a block has no effect, no memory and no fault: twice the same is the same.
pub(super) fn only_reads(block: &BoundBlock) -> bool {
    let reads = matches!(
        block.op(),
        Some(
            Op::Contact
                | Op::NegatedContact
                | Op::Eq
                | Op::Ne
                | Op::Gt
                | Op::Ge
                | Op::Lt
                | Op::Le
                | Op::Inverter
        )
    );
    reads
        && block
            .facts
            .operands
            .iter()
            .all(|operand| cannot_fault(&operand.value))
}

/// Whether a value can be read without a fault: an index that is a tag may be outside its array.
fn cannot_fault(node: &Node) -> bool {
    let literal = |node: &Node| matches!(node.kind, NodeKind::Literal(_));
    match &node.kind {
        NodeKind::Name(_) | NodeKind::Address(_) | NodeKind::Literal(_) => true,
        NodeKind::Member(base, _) => cannot_fault(base),
        NodeKind::Index(base, index) => cannot_fault(base) && literal(index),
        NodeKind::Range(base, first, last) => cannot_fault(base) && literal(first) && literal(last),
        _ => false,
    }
}

fn doubled(on: &OnNetwork<'_>, region: &Region) -> Option<Drawing> {
    let copy = fresh(copied(&on.drawing, &region.things(&on.drawing)).ok()?);
    let without_comments = |item: Item| match item.kind {
        ItemKind::Comment => Circuit::Series(Vec::new()),
        _ => Circuit::Element(item),
    };
    let copy = copy.into_iter().map(|part| part.replaced(&without_comments));
    beside::with(&on.drawing, region.gaps(), normal(copy.collect()), Side::Below).ok()
}
