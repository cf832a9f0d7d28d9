//! A parallel branch goes: the one that the cursor is in.

use super::drawing::{Drawing, Item, ItemKind};
use super::insert_branch::first_name;
use super::parallel::Parallel;
use super::place::{OnNetwork, Selected};
use super::region::Region;
use super::{Action, ActionKind};
use std::ops::Range;

pub(super) fn offer(place: &Selected<'_>, out: &mut Vec<Action>) {
    let Some(on) = &place.on else { return };
    let Some((row, items)) = on.trimmed() else { return };
    let Some((drawing, name)) = removed(on, row, items) else {
        return;
    };
    let title = format!("Remove the parallel branch with `{name}` (changes what the rung does)");
    out.push(Action::new(ActionKind::Rewrite, title, vec![drawing.replace()]));
}

/// The drawing without the smallest branch around some items of a row, and how a title calls that branch.
pub(super) fn removed(on: &OnNetwork<'_>, row: usize, items: Range<usize>) -> Option<(Drawing, String)> {
    let drawing = &on.drawing;
    let holds =
        |at: usize, range: Range<usize>| at == row && range.start <= items.start && items.end <= range.end;
    let parallels = (0..drawing.rows.len())
        .flat_map(|row| drawing.all(row, ItemKind::Down).map(move |down| (row, down)))
        .filter_map(|(row, down)| Parallel::at(drawing, row, down));
    let sides = parallels.flat_map(|found| [(found.clone(), false), (found, true)]);
    let (parallel, is_lower) = sides
        .filter(|(found, is_lower)| match is_lower {
            true => holds(found.below, found.lower()),
            false => holds(found.row, found.upper()),
        })
        .min_by_key(|(found, is_lower)| {
            if *is_lower {
                found.lower().len()
            } else {
                found.upper().len()
            }
        })?;
    let (gone_row, gone) = if is_lower {
        (parallel.below, parallel.lower())
    } else {
        (parallel.row, parallel.upper())
    };
    let gone = Region::of(drawing, gone_row, gone)?;
    if !gone.items(drawing).any(Item::is_block) {
        return None;
    }
    let name = first_name(on, &gone);
    let new = if is_lower {
        without_lower(drawing, &parallel, &gone)?
    } else {
        without_upper(drawing, &parallel, &gone)?
    };
    new.order()?;
    Some((new, name))
}

fn without_lower(drawing: &Drawing, parallel: &Parallel, gone: &Region) -> Option<Drawing> {
    let mut new = drawing.clone();
    for (n, range) in gone.rows.iter().enumerate().skip(1) {
        remove(&mut new, gone.top + n, range.clone());
    }
    remove(
        &mut new,
        parallel.below,
        parallel.below_left..parallel.below_right + 1,
    );
    // The rows that it passes, from the last.
    let mut ends = vec![];
    let (mut left, mut right) = (parallel.left, parallel.right);
    for row in parallel.row..parallel.below - 1 {
        let (up_left, up_right) = (drawing.up_of(row, left)?, drawing.up_of(row, right)?);
        ends.push((row + 1, up_left..up_left + 2, up_right - 1..up_right + 1));
        (left, right) = (up_left + 1, up_right - 1);
    }
    for (row, left, right) in ends.into_iter().rev() {
        remove(&mut new, row, right);
        remove(&mut new, row, left);
    }
    new.take(parallel.row, parallel.right);
    new.take(parallel.row, parallel.left);
    new.drop_empty_rows();
    drop_passed_rows(&mut new);
    Some(new)
}

/// The lower branch takes the place of the upper one. It must be on one row, so that nothing below it moves.
fn without_upper(drawing: &Drawing, parallel: &Parallel, gone: &Region) -> Option<Drawing> {
    let lower = &drawing.rows[parallel.below].items[parallel.lower()];
    if parallel.below != parallel.row + 1
        || gone.rows.len() > 1
        || lower.iter().any(|item| item.kind == ItemKind::Down)
    {
        return None;
    }
    let mut new = drawing.clone();
    let joined = new.rows[parallel.row].items[parallel.left].joined;
    let mut moved = lower.to_vec();
    remove(
        &mut new,
        parallel.below,
        parallel.below_left..parallel.below_right + 1,
    );
    if let Some(first) = moved.first_mut() {
        first.joined = joined;
    }
    // A comment of the branch that goes stays.
    let kept = drawing.rows[gone.top].items[gone.on_top()].iter();
    moved.extend(kept.filter(|item| item.kind == ItemKind::Comment).cloned());
    new.rows[parallel.row]
        .items
        .splice(parallel.left..=parallel.right, moved);
    new.drop_empty_rows();
    drop_passed_rows(&mut new);
    Some(new)
}

/// Takes whole segments out of a row; their comments stay, after the rung.
pub(super) fn remove(drawing: &mut Drawing, row: usize, range: Range<usize>) {
    let items = &mut drawing.rows[row].items;
    let gone: Vec<Item> = items.drain(range.clone()).collect();
    if let Some(next) = items.get_mut(range.start) {
        next.joined = false;
    }
    let comments = gone.into_iter().filter(|item| item.kind == ItemKind::Comment);
    items.extend(comments.map(|item| Item {
        joined: false,
        ..item
    }));
}

/// Takes rows out that wires only pass: with one `/` and one `\\` in each wire the pairs above and below are in the same
/// order.
pub(super) fn drop_passed_rows(drawing: &mut Drawing) {
    let mut row = 0;
    while row < drawing.rows.len() {
        let items = &drawing.rows[row].items;
        let mut at = 0;
        let mut wires = 0;
        while at < items.len() {
            let kinds = (items[at].kind, items.get(at + 1).map(|item| item.kind));
            let pair = matches!(
                kinds,
                (ItemKind::Up, Some(ItemKind::Down)) | (ItemKind::Down, Some(ItemKind::Up))
            );
            let segment = drawing.segment(row, at);
            if pair && segment == (at..at + 2) {
                wires += 1;
                at += 2;
            } else if items[at].kind == ItemKind::Comment && segment.len() == 1 {
                at += 1;
            } else {
                break;
            }
        }
        if wires == 0 || at < items.len() {
            row += 1;
            continue;
        }
        drawing.rows[row]
            .items
            .retain(|item| item.kind == ItemKind::Comment);
        drawing.drop_empty_rows();
    }
}
