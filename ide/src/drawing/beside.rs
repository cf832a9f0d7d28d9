//! A branch is drawn beside a run of things of a row.

use super::carry::NOT_A_RUN;
use super::gap::Gap;
use super::insert::{has_block, in_old_order};
use super::item::{Item, ItemKind, Mark};
use super::parallel::Parallel;
use super::passing::insert_rows;
use super::region::Region;
use super::rows::Drawing;
use super::term::{Rung, normal, rows};
use ladder_format::Circuit;

/// Where the new branch is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// It runs after what it is beside.
    Below,
    /// It runs before that.
    Above,
}

const JOINED_ELSEWHERE: &str = "what is selected is also joined to something else";

/// The drawing with a branch of some parts beside what is between two gaps of a row.
///
/// # Errors
/// Why it cannot be there.
pub(crate) fn with(
    drawing: &Drawing,
    [from, to]: [Gap; 2],
    branch: Vec<Circuit<Item>>,
    side: Side,
) -> Result<Drawing, &'static str> {
    if from.row != to.row || from.index >= to.index {
        return Err(NOT_A_RUN);
    }
    let marked = drawing.marked(&[(from, Mark::From), (to, Mark::To)]);
    if let Some(rung) = Rung::with_ends(&marked) {
        let mut parts = rung.parts.clone();
        if !is_beside(&mut parts, &branch, side)? {
            return Err(JOINED_ELSEWHERE);
        }
        return in_old_order(drawing, rung.draw(drawing, normal(parts)));
    }
    let region = Region::of(drawing, from.row, from.index..to.index).ok_or(JOINED_ELSEWHERE)?;
    if !region.items(drawing).any(Item::is_block) {
        return Err(NO_BLOCK);
    }
    let mut drawn = rows(&Circuit::Series(branch));
    if side == Side::Above || drawn.len() != 1 {
        return Err("this network is not in series and in parallel: draw one line below at a time");
    }
    let branch = drawn.remove(0).items;
    below(drawing, &lowest(drawing, region), branch).ok_or(JOINED_ELSEWHERE)
}

const NO_BLOCK: &str = "there is nothing between the two places that a branch could be beside";

/// Draws the branch beside what is between the marks. Whether they are in one series here.
fn is_beside(
    parts: &mut Vec<Circuit<Item>>,
    branch: &[Circuit<Item>],
    side: Side,
) -> Result<bool, &'static str> {
    let place = |parts: &[Circuit<Item>], mark| parts.iter().position(|part| is_mark(part, mark));
    if let (Some(from), Some(to)) = (place(parts, Mark::From), place(parts, Mark::To)) {
        if !has_block(&parts[from..to]) {
            return Err(NO_BLOCK);
        }
        let mut between: Vec<_> = parts.drain(from..=to).collect();
        between.retain(|part| !is_mark(part, Mark::From) && !is_mark(part, Mark::To));
        let (old, new) = (Circuit::Series(between), Circuit::Series(branch.to_vec()));
        let branches = match side {
            Side::Below => vec![old, new],
            Side::Above => vec![new, old],
        };
        parts.insert(from, Circuit::Parallel(branches));
        return Ok(true);
    }
    for part in parts {
        match part {
            Circuit::Element(_) => {}
            Circuit::Series(parts) => {
                if is_beside(parts, branch, side)? {
                    return Ok(true);
                }
            }
            Circuit::Parallel(branches) => {
                if let Some(whole) = branches.iter_mut().find_map(whole_branch) {
                    whole.retain(|part| !is_mark(part, Mark::From) && !is_mark(part, Mark::To));
                    let at = match side {
                        Side::Below => branches.len(),
                        Side::Above => 0,
                    };
                    branches.insert(at, Circuit::Series(branch.to_vec()));
                    return Ok(true);
                }
                if is_beside(branches, branch, side)? {
                    return Ok(true);
                }
            }
        }
    }
    Ok(false)
}

/// The parts of a branch all of which are between the marks, comments aside: what is beside one of several branches is a
/// branch of all.
fn whole_branch(branch: &mut Circuit<Item>) -> Option<&mut Vec<Circuit<Item>>> {
    let Circuit::Series(parts) = branch else {
        return None;
    };
    let from = parts.iter().position(|part| is_mark(part, Mark::From))?;
    let to = parts.iter().position(|part| is_mark(part, Mark::To))?;
    let is_comment =
        |part: &Circuit<Item>| matches!(part, Circuit::Element(item) if item.kind == ItemKind::Comment);
    let mut others = parts[..from].iter().chain(&parts[to + 1..]);
    (others.all(is_comment) && has_block(&parts[from..to])).then_some(parts)
}

pub(crate) fn is_mark(part: &Circuit<Item>, mark: Mark) -> bool {
    matches!(part, Circuit::Element(item) if item.kind == ItemKind::Mark(mark))
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

/// The drawing with a branch below a region. None where that would change the order of evaluation.
fn below(drawing: &Drawing, region: &Region, branch: Vec<Item>) -> Option<Drawing> {
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
