//! Things are taken from their place, and put in at another.

use super::beside::is_mark;
use super::gap::Gap;
use super::insert::{self, in_old_order, in_place_of};
use super::item::{Item, ItemKind, Mark};
use super::remove::{Spot, left, without};
use super::rows::Drawing;
use super::term::{Rung, items, normal};
use ladder_format::Circuit;
use ladder_syntax::TextRange;

/// Why some things are no run.
pub(crate) const NOT_A_RUN: &str = "select things that follow each other on one line";

/// The drawing with some things at another of its places.
///
/// # Errors
/// Why they cannot go there.
pub(crate) fn moved(drawing: &Drawing, things: &[Spot], to: Gap) -> Result<Drawing, &'static str> {
    let marked = drawing.marked(&[(to, Mark::To)]);
    let Some(rung) = Rung::with_ends(&marked) else {
        return moved_on_rows(drawing, things, to);
    };
    let run = run(&rung.parts, &selected(drawing, things)).ok_or(NOT_A_RUN)?;
    if run
        .iter()
        .flat_map(items)
        .any(|item| item.kind == ItemKind::Mark(Mark::To))
    {
        return Err("the place is among what is moved");
    }
    let places = places(&run);
    let goes = |item: &Item| !item.is_new() && places.contains(&item.at);
    let mut comments = Vec::new();
    let parts = normal(left(rung.parts.clone(), &goes, &mut comments));
    let mut new = rung.draw(drawing, in_place_of(Mark::To, &parts, fresh(run)));
    new.put_beside(0, comments);
    in_old_order(drawing, new)
}

/// Some things, and the drawing without them; none if no block is left.
///
/// # Errors
/// Why they cannot go.
pub(crate) fn taken(
    drawing: &Drawing,
    things: &[Spot],
) -> Result<(Vec<Circuit<Item>>, Option<Drawing>), &'static str> {
    let run = copied(drawing, things)?;
    let places = places(&run);
    let gone = drawing.spots(|item| places.contains(&item.at));
    Ok((run, without(drawing, &gone)?))
}

/// Some things that follow each other, as new ones.
///
/// # Errors
/// Why not.
pub(crate) fn copied(drawing: &Drawing, things: &[Spot]) -> Result<Vec<Circuit<Item>>, &'static str> {
    match Rung::with_ends(drawing) {
        Some(rung) => run(&rung.parts, &selected(drawing, things)).ok_or(NOT_A_RUN),
        None => run_on_row(drawing, things),
    }
}

/// What things are at the places of some spots.
fn selected<'d>(drawing: &'d Drawing, things: &[Spot]) -> impl Fn(&Item) -> bool + use<'d> {
    let places = things
        .iter()
        .map(|&(row, index)| drawing.rows[row].items[index].at);
    let places: Vec<TextRange> = places.collect();
    move |item| !item.is_new() && places.contains(&item.at)
}

fn places(parts: &[Circuit<Item>]) -> Vec<TextRange> {
    parts.iter().flat_map(items).map(|item| item.at).collect()
}

/// The same things, as new ones.
pub(crate) fn fresh(parts: Vec<Circuit<Item>>) -> Vec<Circuit<Item>> {
    let by = |item: Item| {
        let kind = match item.kind {
            ItemKind::Block(_) => ItemKind::Block(None),
            kind => kind,
        };
        Circuit::Element(Item::new(kind, item.text, true))
    };
    parts.into_iter().map(|part| part.replaced(&by)).collect()
}

/// The parts of one series that are selected as a whole, if nothing else is.
fn run(parts: &[Circuit<Item>], is: &dyn Fn(&Item) -> bool) -> Option<Vec<Circuit<Item>>> {
    let has_one = |part: &Circuit<Item>| items(part).into_iter().any(is);
    let is_whole = |part: &Circuit<Item>| {
        let own = items(part);
        let mut others = own.iter().filter(|item| !is(item));
        own.iter().any(|item| is(item))
            && others.all(|item| !item.is_block())
            && !own.iter().any(|item| item.is_end())
    };
    let first = parts.iter().position(has_one)?;
    let last = parts.iter().rposition(has_one)?;
    let between = &parts[first..=last];
    let is_aside = |part: &Circuit<Item>| {
        matches!(part, Circuit::Element(item) if item.kind == ItemKind::Comment) || is_mark(part, Mark::To)
    };
    if between.iter().all(|part| is_whole(part) || is_aside(part)) {
        return Some(between.to_vec());
    }
    match between {
        [Circuit::Series(parts)] => run(parts, is),
        [Circuit::Parallel(branches)] => {
            let mut touched = branches.iter().filter(|branch| has_one(branch));
            match (touched.next()?, touched.next()) {
                (branch, None) => run(std::slice::from_ref(branch), is),
                _ => None,
            }
        }
        _ => None,
    }
}

/// The same on a row of a network that is no term.
fn run_on_row(drawing: &Drawing, things: &[Spot]) -> Result<Vec<Circuit<Item>>, &'static str> {
    let mut things = things.to_vec();
    things.sort_unstable();
    let follow = |pair: &[Spot]| {
        let (row, index) = pair[1];
        pair[0] == (row, index.wrapping_sub(1)) && drawing.rows[row].items[index].joined
    };
    let is_thing = |&(row, index): &Spot| {
        let item = &drawing.rows[row].items[index];
        item.is_block() || item.kind == ItemKind::Comment
    };
    if things.is_empty() || !things.windows(2).all(follow) || !things.iter().all(is_thing) {
        return Err(NOT_A_RUN);
    }
    let items = things
        .iter()
        .map(|&(row, index)| drawing.rows[row].items[index].clone());
    Ok(items.map(Circuit::Element).collect())
}

fn moved_on_rows(drawing: &Drawing, things: &[Spot], to: Gap) -> Result<Drawing, &'static str> {
    let run = fresh(run_on_row(drawing, things)?);
    let (row, first) = *things.iter().min().ok_or(NOT_A_RUN)?;
    let last = things.iter().max().ok_or(NOT_A_RUN)?.1;
    if to.row == row && (first + 1..=last).contains(&to.index) {
        return Err("the place is among what is moved");
    }
    // The gap is found again by what is behind it.
    let mut new = drawing.marked(&[(to, Mark::To)]);
    let shift = usize::from(to.row == row && to.index <= first);
    for index in (first + shift..=last + shift).rev() {
        new.take(row, index);
    }
    let is_place = |item: &Item| item.kind == ItemKind::Mark(Mark::To);
    let index = new.rows[to.row]
        .items
        .iter()
        .position(is_place)
        .ok_or(NOT_A_RUN)?;
    let mark = new.rows[to.row].items.remove(index);
    if let Some(next) = new.rows[to.row].items.get_mut(index) {
        next.joined |= !mark.joined;
    }
    let gap = Gap { row: to.row, index };
    in_old_order(drawing, insert::with(&new, gap, run)?)
}
