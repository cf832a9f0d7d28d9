//! Things are taken out of a network, with the branches of which nothing is left.

use super::insert::in_old_order;
use super::item::{Item, ItemKind};
use super::parallel::Parallel;
use super::region::Region;
use super::rows::Drawing;
use super::term::{Rung, items, normal};
use ladder_format::Circuit;
use std::ops::Range;

/// A thing of a drawing: its row, and its index there.
pub(crate) type Spot = (usize, usize);

/// The drawing without some things. None if no block is left.
///
/// # Errors
/// Why they cannot go.
pub(crate) fn without(drawing: &Drawing, gone: &[Spot]) -> Result<Option<Drawing>, &'static str> {
    if drawing
        .spots(Item::is_block)
        .iter()
        .all(|spot| gone.contains(spot))
    {
        return Ok(None);
    }
    let Some(rung) = Rung::with_ends(drawing) else {
        return without_rows(drawing, gone).map(Some);
    };
    let places: Vec<_> = gone
        .iter()
        .map(|&(row, index)| drawing.rows[row].items[index].at)
        .collect();
    let goes = |item: &Item| places.contains(&item.at) && !item.is_new();
    let mut comments = Vec::new();
    let parts = left(rung.parts.clone(), &goes, &mut comments);
    let mut new = rung.draw(drawing, normal(parts));
    new.put_beside(0, comments);
    in_old_order(drawing, new).map(Some)
}

/// What is left of parts. The comments of branches that go are gathered.
pub(crate) fn left(
    parts: Vec<Circuit<Item>>,
    goes: &dyn Fn(&Item) -> bool,
    comments: &mut Vec<Item>,
) -> Vec<Circuit<Item>> {
    let mut all = Vec::with_capacity(parts.len());
    for part in parts {
        match part {
            Circuit::Element(item) => {
                if !goes(&item) {
                    all.push(Circuit::Element(item));
                }
            }
            Circuit::Series(parts) => all.push(Circuit::Series(left(parts, goes, comments))),
            Circuit::Parallel(branches) => {
                let mut stay = Vec::with_capacity(branches.len());
                for branch in branches {
                    let has_lost = items(&branch)
                        .into_iter()
                        .any(|item| item.is_block() && goes(item));
                    let branch = Circuit::Series(left(vec![branch], goes, comments));
                    let holds = |item: &&Item| item.is_block() || matches!(item.kind, ItemKind::Mark(_));
                    if has_lost && !items(&branch).iter().any(holds) {
                        // A bare wire would lead round what is beside it.
                        let kept = items(&branch)
                            .into_iter()
                            .filter(|item| item.kind == ItemKind::Comment);
                        comments.extend(kept.cloned());
                    } else {
                        stay.push(branch);
                    }
                }
                all.push(Circuit::Parallel(stay));
            }
        }
    }
    all
}

/// The same on the rows of a network that is no term.
fn without_rows(drawing: &Drawing, gone: &[Spot]) -> Result<Drawing, &'static str> {
    let mut rows: Vec<usize> = gone.iter().map(|(row, _)| *row).collect();
    rows.dedup();
    let [row] = rows[..] else {
        return Err(
            "this network is not in series and in parallel: take out the things of one line at a time",
        );
    };
    let mut gone: Vec<usize> = gone.iter().map(|(_, index)| *index).collect();
    gone.sort_unstable();
    let segment = drawing.segment(row, gone[0]);
    let own = &drawing.rows[row].items;
    let is_emptied = segment
        .clone()
        .all(|index| !own[index].is_block() || gone.contains(&index));
    if is_emptied
        && let Some(branch) = branch_around(drawing, row, gone[0]..gone[gone.len() - 1] + 1)
        && let Some(new) = branch.removed(drawing)
    {
        return Ok(new);
    }
    let (first, last) = (gone[0], gone[gone.len() - 1]);
    let is_all = gone.len() == last + 1 - first;
    if is_all
        && first > segment.start
        && last + 1 < segment.end
        && parts(drawing, row, first - 1)
        && meets(drawing, row, last + 1)
    {
        return Err("a bare wire would be left between two places that are joined in another way as well");
    }
    let mut new = drawing.clone();
    for &index in gone.iter().rev() {
        new.take(row, index);
    }
    in_old_order(drawing, new)
}

/// Whether power leaves a line at a connector, or comes to it there from above.
fn parts(drawing: &Drawing, row: usize, index: usize) -> bool {
    match drawing.rows[row].items[index].kind {
        ItemKind::Up => !drawing.has_wire_before(row, index),
        ItemKind::Down => {
            let up = drawing.up_of(row, index);
            up.is_some_and(|up| drawing.has_wire_after(row + 1, up))
        }
        _ => false,
    }
}

/// Whether power comes back to a line at a connector, or leaves it there for the line above.
fn meets(drawing: &Drawing, row: usize, index: usize) -> bool {
    match drawing.rows[row].items[index].kind {
        ItemKind::Up => !drawing.has_wire_after(row, index),
        ItemKind::Down => {
            let up = drawing.up_of(row, index);
            up.is_some_and(|up| drawing.has_wire_before(row + 1, up))
        }
        _ => false,
    }
}

/// A branch of two between the same points.
pub(crate) struct Branch {
    parallel: Parallel,
    is_lower: bool,
    /// What it consists of.
    pub(crate) region: Region,
}

/// The smallest branch around some things of a row.
pub(crate) fn branch_around(drawing: &Drawing, row: usize, things: Range<usize>) -> Option<Branch> {
    let holds =
        |at: usize, range: Range<usize>| at == row && range.start <= things.start && things.end <= range.end;
    let parallels = (0..drawing.rows.len())
        .flat_map(|row| drawing.all(row, ItemKind::Down).map(move |down| (row, down)))
        .filter_map(|(row, down)| Parallel::at(drawing, row, down));
    let sides = parallels.flat_map(|found| [(found.clone(), false), (found, true)]);
    let range = |found: &Parallel, is_lower: bool| {
        if is_lower {
            (found.below, found.lower())
        } else {
            (found.row, found.upper())
        }
    };
    let (parallel, is_lower) = sides
        .filter(|(found, is_lower)| {
            let (row, range) = range(found, *is_lower);
            holds(row, range)
        })
        .min_by_key(|(found, is_lower)| range(found, *is_lower).1.len())?;
    let (row, range) = range(&parallel, is_lower);
    let region = Region::of(drawing, row, range)?;
    let branch = Branch {
        parallel,
        is_lower,
        region,
    };
    let has_block = branch.region.items(drawing).any(Item::is_block);
    has_block.then_some(branch)
}

impl Branch {
    /// The row that it begins on with what is beside it, and the items of both there.
    pub(crate) fn group(&self) -> (usize, Range<usize>) {
        (self.parallel.row, self.parallel.left..self.parallel.right + 1)
    }

    /// The rows without it.
    fn removed(&self, drawing: &Drawing) -> Option<Drawing> {
        let new = if self.is_lower {
            without_lower(drawing, &self.parallel, &self.region)?
        } else {
            without_upper(drawing, &self.parallel, &self.region)?
        };
        in_old_order(drawing, new).ok()
    }
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
pub(crate) fn remove(drawing: &mut Drawing, row: usize, range: Range<usize>) {
    let items = &mut drawing.rows[row].items;
    let gone: Vec<Item> = items.drain(range.clone()).collect();
    if let Some(next) = items.get_mut(range.start) {
        next.joined = false;
    }
    let comments = gone.into_iter().filter(|item| item.kind == ItemKind::Comment);
    drawing.put_beside(row, comments);
}

/// Takes rows out that wires only pass: with one `/` and one `\\` in each wire the pairs above and below are in the same
/// order.
pub(crate) fn drop_passed_rows(drawing: &mut Drawing) {
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
