//! The end of a branch is joined to another place of the line that the branch is beside.

use super::beside::is_mark;
use super::gap::Gap;
use super::insert::has_block;
use super::item::{Item, ItemKind, Mark};
use super::remove::Spot;
use super::rows::Drawing;
use super::term::{Rung, items, normal};
use ladder_format::Circuit;

type Parts = Vec<Circuit<Item>>;

const NO_TERM: &str = "this network is not in series and in parallel: draw that in the text";
const ALONE: &str = "nothing would be beside the branch then";

/// The drawing in which the end of a branch that a connector is joins another place.
///
/// # Errors
/// Why it cannot.
pub(crate) fn moved(drawing: &Drawing, connector: Spot, to: Gap) -> Result<Drawing, &'static str> {
    let (gap, end) = end_of(drawing, connector).ok_or("a branch neither begins nor ends there")?;
    let marked = drawing.marked(&[(gap, Mark::From), (to, Mark::To)]);
    let rung = Rung::with_ends(&marked).ok_or(NO_TERM)?;
    let mut parts = rung.parts.clone();
    if !end_moves(&mut parts, end)? {
        return Err("the end of a branch can only be moved along the line that it is joined to");
    }
    Ok(rung.draw(drawing, normal(parts)))
}

/// Which end of a branch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum End {
    Left,
    Right,
}

/// The place in a lower branch that is next to a connector of its end, and which end that is.
fn end_of(drawing: &Drawing, (row, index): Spot) -> Option<(Gap, End)> {
    let (mut row, mut up) = match drawing.rows[row].items[index].kind {
        ItemKind::Up => (row, index),
        ItemKind::Down => (row + 1, drawing.up_of(row, index)?),
        _ => return None,
    };
    loop {
        let segment = drawing.segment(row, up);
        let end = match (segment.start == up, segment.end == up + 1) {
            (true, false) => End::Left,
            (false, true) => End::Right,
            _ => return None,
        };
        let other = if end == End::Left { up + 1 } else { up - 1 };
        if segment.len() > 2 || drawing.rows[row].items[other].kind != ItemKind::Down {
            let index = if end == End::Left { up + 1 } else { up };
            return Some((Gap { row, index }, end));
        }
        up = drawing.up_of(row, other)?;
        row += 1;
    }
}

fn place(parts: &[Circuit<Item>], mark: Mark) -> Option<usize> {
    parts.iter().position(|part| is_mark(part, mark))
}

/// The branch of some in whose series a mark is, and where there.
fn branch_with(branches: &[Circuit<Item>], mark: Mark) -> Option<(usize, usize)> {
    branches
        .iter()
        .enumerate()
        .find_map(|(number, branch)| match branch {
            Circuit::Series(parts) => Some((number, place(parts, mark)?)),
            _ => None,
        })
}

fn end_moves(parts: &mut Parts, end: End) -> Result<bool, &'static str> {
    for at in 0..parts.len() {
        let Circuit::Parallel(branches) = &mut parts[at] else {
            if let Circuit::Series(inner) = &mut parts[at]
                && end_moves(inner, end)?
            {
                return Ok(true);
            }
            continue;
        };
        let Some((number, _)) = branch_with(branches, Mark::From).filter(|(number, _)| *number > 0) else {
            if end_moves(branches, end)? {
                return Ok(true);
            }
            continue;
        };
        let mut lower = branches.split_off(number);
        for branch in &mut lower {
            unmark(branch, Mark::From);
        }
        let mut upper = std::mem::take(branches);
        if let Some((within, place)) = branch_with(&upper, Mark::To) {
            if within + 1 < number {
                return Err("the branch is joined to the line directly above it");
            }
            let Some(Circuit::Series(mut before)) = upper.pop() else {
                return Ok(false);
            };
            let mut behind = before.split_off(place);
            behind.remove(0);
            let beside = if end == End::Right {
                &mut before
            } else {
                &mut behind
            };
            if !has_block(beside) {
                return Err(ALONE);
            }
            let mut group = vec![Circuit::Series(std::mem::take(beside))];
            group.append(&mut lower);
            match end {
                End::Right => before.push(Circuit::Parallel(group)),
                End::Left => behind.insert(0, Circuit::Parallel(group)),
            }
            before.append(&mut behind);
            upper.push(Circuit::Series(before));
            parts[at] = Circuit::Parallel(upper);
            return Ok(true);
        }
        let found = place(parts, Mark::To).filter(|to| (*to > at) == (end == End::Right));
        let Some(to) = found else { return Ok(false) };
        let mut beside: Parts = match end {
            End::Right => parts.drain(at..=to).collect(),
            End::Left => parts.drain(to..=at).collect(),
        };
        let upper = Circuit::Parallel(upper);
        match end {
            End::Right => {
                beside.pop();
                beside[0] = upper;
            }
            End::Left => {
                beside.remove(0);
                beside.pop();
                beside.push(upper);
            }
        }
        let mut group = vec![Circuit::Series(beside)];
        group.append(&mut lower);
        parts.insert(at.min(to), Circuit::Parallel(group));
        return Ok(true);
    }
    Ok(false)
}

fn unmark(branch: &mut Circuit<Item>, mark: Mark) {
    if let Circuit::Series(parts) = branch {
        parts.retain(|part| !is_mark(part, mark));
    }
}

/// The drawing in which a branch that ends by itself is joined to the line above it. `last` is the last thing of the branch.
///
/// # Errors
/// Why it cannot be.
pub(crate) fn closed(drawing: &Drawing, (row, last): Spot, to: Gap) -> Result<Drawing, &'static str> {
    const NO_END: &str = "no branch ends there by itself";
    let segment = drawing.segment(row, last);
    let items = &drawing.rows[row].items;
    if items[segment.start].kind != ItemKind::Up {
        return Err(NO_END);
    }
    let index = segment.end - usize::from(items[segment.end - 1].is_end());
    let marked = drawing.marked(&[(Gap { row, index }, Mark::From), (to, Mark::To)]);
    let rung = Rung::with_ends(&marked).ok_or(NO_TERM)?;
    let mut parts = rung.parts.clone();
    if !closes(&mut parts)? {
        return Err("the loose end of a branch can only be joined to the line that it begins at");
    }
    Ok(rung.draw(drawing, normal(parts)))
}

fn closes(parts: &mut Parts) -> Result<bool, &'static str> {
    for part in parts {
        let branches = match part {
            Circuit::Parallel(branches) => branches,
            Circuit::Series(parts) => {
                if closes(parts)? {
                    return Ok(true);
                }
                continue;
            }
            Circuit::Element(_) => continue,
        };
        let (from, to) = (branch_with(branches, Mark::From), branch_with(branches, Mark::To));
        let (Some((from, _)), Some((to, place))) = (from, to) else {
            if closes(branches)? {
                return Ok(true);
            }
            continue;
        };
        if from != to + 1 {
            return Err("the branch is joined to the line directly above it");
        }
        let Circuit::Series(mut lower) = branches.remove(from) else {
            return Ok(false);
        };
        lower.retain(|part| {
            let is_end = items(part).into_iter().any(Item::is_end);
            !is_mark(part, Mark::From) && !is_end
        });
        let Circuit::Series(upper) = &mut branches[to] else {
            return Ok(false);
        };
        let mut behind = upper.split_off(place);
        if !has_block(upper) {
            return Err(ALONE);
        }
        let before = Circuit::Series(std::mem::take(upper));
        behind[0] = Circuit::Parallel(vec![before, Circuit::Series(lower)]);
        *upper = behind;
        return Ok(true);
    }
    Ok(false)
}
