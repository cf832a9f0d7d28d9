//! A parallel branch around the selected blocks, with a new contact (or coil) that does nothing yet.

use super::names::{called, new_tag};
use super::place::{OnNetwork, Selected};
use super::{Action, ActionKind};
use crate::drawing::beside::{self, Side};
use crate::drawing::item::{Item, ItemKind};
use crate::drawing::region::Region;
use ladder_analysis::context::Context;
use ladder_analysis::names::declaring::Places;
use ladder_analysis::names::scope::SectionKind;
use ladder_format::Circuit;
use ladder_instructions::Role;

pub(super) fn offer(place: &Selected<'_>, out: &mut Vec<Action>) {
    let Some(on) = &place.on else { return };
    let Some(region) = on.region() else { return };
    let name = first_name(on, &region);
    let output = is_output(on, &region);
    let (tag, block) = new_block(place.context, output);
    let branch = vec![Circuit::Element(Item::block(block))];
    let Ok(drawing) = beside::with(&on.drawing, region.gaps(), branch, Side::Below) else {
        return;
    };
    let mut edits = vec![drawing.replace()];
    // In a body nothing runs with a tag that is not declared.
    if on.facts.scope > 0 {
        let places = Places::new(place.context, on.facts.scope);
        let Some(declaration) = places.declare(SectionKind::Var, &tag, "BOOL") else {
            return;
        };
        edits.extend(declaration);
    }
    let title = if output {
        format!("Draw a parallel coil `{tag}` next to `{name}`")
    } else {
        format!("Draw a parallel contact `{tag}` around `{name}` (no change while it is low)")
    };
    out.push(Action::new(ActionKind::Rewrite, title, edits));
}

/// A coil or contact with a new tag: the tag, and the block.
pub(crate) fn new_block(context: &Context, is_output: bool) -> (String, String) {
    let (base, head) = if is_output {
        ("new_coil", "( )")
    } else {
        ("new_contact", "[ ]")
    };
    let tag = new_tag(context, &[], base);
    let block = format!("{head}( {tag} )");
    (tag, block)
}

/// How a title calls the first block of a region.
pub(super) fn first_name(on: &OnNetwork<'_>, region: &Region) -> String {
    let first = region.items(&on.drawing).find(|item| item.is_block());
    let number = first.and_then(|item| match item.kind {
        ItemKind::Block(number) => number,
        _ => None,
    });
    match (first, number.and_then(|number| on.facts.blocks.get(number))) {
        (Some(item), Some(block)) => called(block, &item.text),
        _ => String::new(),
    }
}

/// Whether a region is blocks that act and end a rung: a coil goes next to them, not a contact.
pub(crate) fn is_output(on: &OnNetwork<'_>, region: &Region) -> bool {
    let all_coils = on
        .blocks(&region.blocks(&on.drawing))
        .all(|block| block.instruction().is_none_or(|row| row.role == Role::Acting));
    let items = &on.drawing.rows[region.top].items;
    let after = items.get(region.on_top().end).filter(|item| item.joined);
    all_coils && after.is_none_or(|item| item.kind == ItemKind::RightRail)
}
