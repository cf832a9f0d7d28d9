//! A parallel branch around the selected blocks, with a new contact (or coil) that does nothing yet.

use super::drawing::{Drawing, Item, ItemKind};
use super::names::{called, new_tag};
use super::parallel::Parallel;
use super::passing::insert_rows;
use super::place::{OnNetwork, Selected};
use super::region::Region;
use super::{Action, ActionKind};
use ladder_analysis::names::declaring::Places;
use ladder_analysis::names::scope::SectionKind;
use ladder_instructions::Shape;

pub(super) fn offer(place: &Selected<'_>, out: &mut Vec<Action>) {
    let Some(on) = &place.on else { return };
    let Some(region) = on.region() else { return };
    let name = first_name(on, &region);
    let region = lowest(&on.drawing, region);
    let output = is_output(on, &region);
    let has_coil = on
        .blocks(&region.blocks(&on.drawing))
        .any(|block| block.facts.shape != Shape::Logical);
    if has_coil && !output {
        let title = format!("Draw a parallel branch around `{name}`");
        let why = "a coil is selected together with contacts";
        out.push(Action::disabled(ActionKind::Rewrite, title, why));
        return;
    }
    let tag = new_tag(
        place.context,
        &[],
        if output { "new_coil" } else { "new_contact" },
    );
    let block = if output {
        format!("( )( {tag} )")
    } else {
        format!("[ ]( {tag} )")
    };
    let Some(drawing) = with_branch(&on.drawing, &region, vec![Item::block(block)]) else {
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

/// Where a region is the upper one of two branches, or both, the lower one: what is parallel to it is parallel to both,
/// and a new branch is drawn below those that are there.
fn lowest(drawing: &Drawing, mut region: Region) -> Region {
    loop {
        let on_top = region.on_top();
        let downs = drawing.all(region.top, ItemKind::Down);
        let around = downs
            .filter_map(|down| Parallel::at(drawing, region.top, down))
            .find(|found| {
                found.upper() == on_top || (found.left == on_top.start && found.right + 1 == on_top.end)
            });
        let lower = around.and_then(|found| Region::of(drawing, found.below, found.lower()));
        let Some(lower) = lower.filter(|lower| lower.items(drawing).any(Item::is_block)) else {
            return region;
        };
        region = lower;
    }
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

/// Whether a region is coils that end a rung: a coil goes next to them, not a contact.
fn is_output(on: &OnNetwork<'_>, region: &Region) -> bool {
    let all_coils = on
        .blocks(&region.blocks(&on.drawing))
        .all(|block| block.facts.shape == Shape::Coil);
    let items = &on.drawing.rows[region.top].items;
    let after = items.get(region.on_top().end).filter(|item| item.joined);
    all_coils && after.is_none_or(|item| item.kind == ItemKind::RightRail)
}

/// The drawing with a branch around a region. None where that would change the order of evaluation.
pub(super) fn with_branch(drawing: &Drawing, region: &Region, branch: Vec<Item>) -> Option<Drawing> {
    let mut new = drawing.clone();
    let top = region.top;
    let branch: Vec<Item> = std::iter::once(Item::up(false))
        .chain(branch)
        .chain([Item::up(true)])
        .collect();
    let room = (region.rows.len() == 1)
        .then(|| room_below(drawing, top, region.on_top().start))
        .flatten();
    let mut shift = 0;
    match room {
        Some(at) => {
            let items = &mut new.rows[top + 1].items;
            items.splice(at..at, branch);
        }
        None => {
            let bottom = region.bottom();
            let left = drawing.count_before(bottom, region.rows[region.rows.len() - 1].start, ItemKind::Down);
            let more = insert_rows(&mut new, bottom, left, vec![branch]);
            for (n, range) in region.rows.iter().enumerate().skip(1) {
                let shift = if top + n == bottom { more } else { 0 };
                let items = &mut new.rows[top + n].items;
                let end = range.end + shift;
                items.splice(end..end, [Item::new(ItemKind::Down, "\\", false), Item::up(true)]);
                let start = range.start + shift;
                items.splice(start..start, [Item::up(false), Item::down()]);
            }
            if bottom == top {
                shift = more;
            }
        }
    }
    let items = &mut new.rows[top].items;
    let range = region.on_top();
    items.insert(range.end + shift, Item::down());
    items.insert(range.start + shift, Item::down());
    let joined = items[range.start + shift + 1].joined;
    items[range.start + shift].joined = joined;
    items[range.start + shift + 1].joined = true;
    (new.old_order()? == drawing.old_order()?).then_some(new)
}

/// Where on the row below a new segment can be that is joined after an item of this row: what is left of it there has
/// been evaluated by then.
fn room_below(drawing: &Drawing, row: usize, item: usize) -> Option<usize> {
    let below = drawing.rows.get(row + 1)?;
    let left = drawing.count_before(row, item, ItemKind::Down);
    let at = match left.checked_sub(1) {
        Some(last) => drawing.all(row + 1, ItemKind::Up).nth(last)? + 1,
        None => {
            let start = drawing.drawn_start(row + 1);
            let at_rail = below
                .items
                .get(start)
                .is_some_and(|item| item.kind == ItemKind::LeftRail);
            if at_rail {
                return None;
            }
            start
        }
    };
    let free = below.items.get(at).is_none_or(|item| !item.joined);
    free.then_some(at)
}
