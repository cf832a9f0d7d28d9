//! A parallel branch around the selected contacts that holds a copy of them, to be changed afterwards.

use super::drawing::{Drawing, Item, ItemKind, Row};
use super::insert_branch::{first_name, with_branch};
use super::place::{OnNetwork, Place};
use super::region::Region;
use super::{Action, ActionKind};
use ladder_analysis::network::BoundBlock;
use ladder_instructions::Op;

pub(super) fn offer(place: &Place<'_>, out: &mut Vec<Action>) {
    let Some(on) = &place.on else { return };
    let Some(region) = on.region() else { return };
    if !on.blocks(&region.blocks(&on.drawing)).all(only_reads) {
        return;
    }
    let Some(drawing) = doubled(on, &region) else {
        return;
    };
    let title = format!(
        "Wrap `{}` in a branch, with a copy in parallel (changes nothing yet)",
        first_name(on, &region)
    );
    out.push(Action::new(ActionKind::Rewrite, title, vec![drawing.replace()]));
}

/// Whether a block has no effect and no memory: twice the same is the same.
pub(super) fn only_reads(block: &BoundBlock) -> bool {
    matches!(
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
    )
}

fn doubled(on: &OnNetwork<'_>, region: &Region) -> Option<Drawing> {
    // A branch within the selection would have to be drawn twice below each other.
    if region.rows.len() > 1 {
        return None;
    }
    let Row { items, .. } = region.copy(&on.drawing).pop()?;
    let copy = items.into_iter().filter(|item| item.kind != ItemKind::Comment);
    let copy: Vec<Item> = copy
        .map(|item| match item.kind {
            ItemKind::Block(_) => Item::block(item.text),
            _ => item,
        })
        .collect();
    with_branch(&on.drawing, region, copy)
}
