//! Networks as what is in series and in parallel, and back to a drawing.
//!
//! A branch may end by itself: at the right rail, at a `|`, or at nothing. Its last element is that end then, and all branches
//! next to it end like it.

use super::item::{Item, ItemKind};
use super::parallel::Parallel;
use super::rows::{Drawing, Row, comments};
use ladder_format::{Circuit, Piece, PieceKind};
use std::ops::Range;

/// More rows are no term: a staircase of so many is deeper than the stack.
const MOST_ROWS: usize = 300;

/// A network from the left rail to its end, if all of it is in series and in parallel.
#[derive(Debug, Clone)]
pub(crate) struct Rung {
    /// What is in series, from left to right.
    pub(crate) parts: Vec<Circuit<Item>>,
    /// Whether it ends at the right rail.
    pub(crate) railed: bool,
}

impl Rung {
    /// A network with one end.
    pub(crate) fn read(drawing: &Drawing) -> Option<Rung> {
        let rung = Rung::with_ends(drawing)?;
        let ends = |part: &Circuit<Item>| items(part).into_iter().any(Item::is_end);
        (!rung.parts.iter().any(ends)).then_some(rung)
    }

    /// A network of whose branches some may end by themselves.
    pub(crate) fn with_ends(drawing: &Drawing) -> Option<Rung> {
        if drawing.rows.len() > MOST_ROWS {
            return None;
        }
        let start = drawing.drawn_start(0);
        if drawing.rows.first()?.items.get(start)?.kind != ItemKind::LeftRail {
            return None;
        }
        let end = drawing.segment(0, start).end;
        let mut parts = open_series(drawing, 0, start + 1..end)?;
        let last = parts.last().and_then(|last| match last {
            Circuit::Element(item) => Some(item.kind),
            _ => None,
        });
        let railed = last == Some(ItemKind::RightRail);
        if railed || last == Some(ItemKind::Open) {
            parts.pop();
        }
        // Nothing is left out.
        let is_drawn = |item: &Item| !matches!(item.kind, ItemKind::Open);
        let read = parts.iter().flat_map(items).filter(|item| is_drawn(item)).count() + usize::from(railed);
        let all: usize = drawing.rows.iter().map(elements).sum();
        (read + 1 == all).then_some(Rung { parts, railed })
    }

    /// The drawing of a network of these parts, with the comments of another one next to them.
    pub(crate) fn draw(&self, like: &Drawing, parts: Vec<Circuit<Item>>) -> Drawing {
        let mut drawing = like.with_rows(self.rows(parts));
        place_comments(like, &mut drawing);
        drawing
    }

    /// The drawing without comments.
    pub(crate) fn draw_bare(&self, like: &Drawing, parts: Vec<Circuit<Item>>) -> Drawing {
        like.with_rows(self.rows(parts))
    }

    fn rows(&self, parts: Vec<Circuit<Item>>) -> Vec<Row> {
        let mut rows = rows(&Circuit::Series(parts));
        if let Some(first) = rows.first_mut() {
            first.items.insert(0, Item::left_rail());
            first.items.extend(self.railed.then(Item::right_rail));
        }
        rows
    }
}

/// How many things of a row a term must hold: all but connectors and loose comments.
fn elements(row: &Row) -> usize {
    let counts = |(index, item): &(usize, &Item)| {
        !matches!(item.kind, ItemKind::Down | ItemKind::Up) && !item.is_loose(row.items.get(index + 1))
    };
    row.items.iter().enumerate().filter(counts).count()
}

/// The rows of a circuit.
pub(crate) fn rows(circuit: &Circuit<Item>) -> Vec<Row> {
    let mut rungs = circuit.rungs();
    open_ends(&mut rungs);
    let rungs = rungs.into_iter().map(|rung| {
        let items = rung.into_iter().filter_map(|piece| match piece.kind {
            PieceKind::Down => Some(Item {
                joined: piece.joined,
                ..Item::down()
            }),
            PieceKind::Up => Some(Item::up(piece.joined)),
            PieceKind::Element(item) if item.kind == ItemKind::Open => None,
            PieceKind::Element(item) => Some(Item {
                joined: true,
                ..item.clone()
            }),
        });
        Row {
            items: items.collect(),
            ..Row::default()
        }
    });
    rungs.collect()
}

/// Branches that end by themselves meet nowhere: the connectors behind them go, and those that pass below.
fn open_ends(rungs: &mut [Vec<Piece<'_, Item>>]) {
    let mut above = 0;
    for rung in rungs {
        let drawn = rung
            .iter()
            .rev()
            .find(|piece| matches!(piece.kind, PieceKind::Element(_)));
        let ends = drawn.is_some_and(|piece| matches!(piece.kind, PieceKind::Element(item) if item.is_end()));
        let mut below = 0;
        loop {
            match rung.last() {
                Some(Piece {
                    kind: PieceKind::Up, ..
                }) if above > 0 => {
                    above -= 1;
                    rung.pop();
                    let passes = |piece: &Piece<'_, Item>| piece.kind == PieceKind::Down && !piece.joined;
                    if rung.last().is_some_and(passes) {
                        rung.pop();
                        below += 1;
                    }
                }
                Some(Piece {
                    kind: PieceKind::Down,
                    ..
                }) if ends => {
                    below += 1;
                    rung.pop();
                }
                _ => break,
            }
        }
        above = below;
    }
}

/// Puts what is next to the rungs of one drawing into another with the same things: comments stay with their rungs, and lines
/// between two rungs above the lower one.
fn place_comments(old: &Drawing, new: &mut Drawing) {
    let places = places(old, new);
    for (row, own) in old.rows.iter().enumerate() {
        let at = places[..=row].iter().rev().find_map(|place| *place).unwrap_or(0);
        let drawn = old.drawn_start(row);
        let loose = own.items.iter().enumerate();
        let loose = loose.filter(|(index, item)| item.is_loose(own.items.get(index + 1)));
        let mut before = Vec::new();
        for (index, item) in loose {
            if index < drawn && places[row].is_some() {
                before.push(item.clone());
            } else {
                new.rows[at].items.push(item.clone());
            }
        }
        new.rows[at].items.splice(0..0, before);
        let lower = places[row + 1..].iter().find_map(|place| *place);
        match lower.filter(|lower| *lower > 0) {
            Some(lower) => new.rows[lower - 1].below.extend(own.below.iter().cloned()),
            None => new.head.push_str(&comments(&own.below)),
        }
    }
}

/// For each row of the old drawing the first row of the new one that holds something of it.
fn places(old: &Drawing, new: &Drawing) -> Vec<Option<usize>> {
    let mut places = vec![None; old.rows.len()];
    for (row, own) in new.rows.iter().enumerate() {
        for item in own.items.iter().filter(|item| !item.is_new()) {
            let from = old.rows.partition_point(|row| row.at.end() < item.at.end());
            if old
                .rows
                .get(from)
                .is_some_and(|row| row.at.contains_range(item.at))
            {
                places[from].get_or_insert(row);
            }
        }
    }
    places
}

/// What is in series up to the end of its row.
fn open_series(drawing: &Drawing, row: usize, range: Range<usize>) -> Option<Vec<Circuit<Item>>> {
    let mut parts = Vec::new();
    let mut at = range.start;
    while at < range.end {
        let item = &drawing.rows[row].items[at];
        match item.kind {
            ItemKind::Down => match closed(drawing, row, at, range.end) {
                Some((part, after)) => {
                    parts.push(part);
                    at = after;
                }
                None => {
                    let upper = open_series(drawing, row, at + 1..range.end)?;
                    let mut branches = vec![Circuit::Series(upper)];
                    branches.extend(flat(open_lower(drawing, row, at)?));
                    parts.push(Circuit::Parallel(branches));
                    return Some(parts);
                }
            },
            _ if item.is_end() => {
                parts.push(Circuit::Element(item.clone()));
                return (at + 1 == range.end).then_some(parts);
            }
            _ => {
                parts.push(element(item)?);
                at += 1;
            }
        }
    }
    parts.push(Circuit::Element(Item::new(ItemKind::Open, "", true)));
    Some(parts)
}

/// The branch that a `\` leads to, which ends by itself.
fn open_lower(drawing: &Drawing, row: usize, down: usize) -> Option<Vec<Circuit<Item>>> {
    let (mut row, mut down) = (row, down);
    loop {
        let up = drawing.up_of(row, down)?;
        row += 1;
        let segment = drawing.segment(row, up);
        if segment.start != up {
            return None;
        }
        let passes = segment.len() == 2 && drawing.rows[row].items[up + 1].kind == ItemKind::Down;
        if !passes {
            return open_series(drawing, row, up + 1..segment.end);
        }
        down = up + 1;
    }
}

/// What is in series on a row between two places.
fn series(drawing: &Drawing, row: usize, range: Range<usize>) -> Option<Vec<Circuit<Item>>> {
    let mut parts = Vec::new();
    let mut at = range.start;
    while at < range.end {
        let item = &drawing.rows[row].items[at];
        if item.kind == ItemKind::Down {
            let (part, after) = closed(drawing, row, at, range.end)?;
            parts.push(part);
            at = after;
        } else {
            parts.push(element(item)?);
            at += 1;
        }
    }
    Some(parts)
}

fn element(item: &Item) -> Option<Circuit<Item>> {
    matches!(
        item.kind,
        ItemKind::Block(_) | ItemKind::Comment | ItemKind::Mark(_)
    )
    .then(|| Circuit::Element(item.clone()))
}

/// The branches that part at a `\` and meet again before a place of its row, and what follows them there.
fn closed(drawing: &Drawing, row: usize, down: usize, end: usize) -> Option<(Circuit<Item>, usize)> {
    let found = Parallel::at(drawing, row, down).filter(|found| found.right < end)?;
    let mut branches = vec![Circuit::Series(series(drawing, row, found.upper())?)];
    branches.extend(flat(series(drawing, found.below, found.lower())?));
    Some((Circuit::Parallel(branches), found.right + 1))
}

/// Branches of a branch are branches of the whole.
fn flat(mut parts: Vec<Circuit<Item>>) -> Vec<Circuit<Item>> {
    match parts.as_mut_slice() {
        [Circuit::Parallel(branches)] => std::mem::take(branches),
        _ => vec![Circuit::Series(parts)],
    }
}

/// The one form of a circuit: no series in a series, no parallel as the only thing of a branch, and no branch alone.
pub(crate) fn normal(parts: Vec<Circuit<Item>>) -> Vec<Circuit<Item>> {
    let mut all = Vec::with_capacity(parts.len());
    for part in parts {
        match part {
            Circuit::Element(_) => all.push(part),
            Circuit::Series(parts) => all.extend(normal(parts)),
            Circuit::Parallel(branches) => {
                let branches = branches.into_iter().map(|branch| normal(vec![branch]));
                let mut branches: Vec<_> = branches.flat_map(flat).collect();
                match branches.len() {
                    0 => {}
                    1 => match branches.remove(0) {
                        Circuit::Series(parts) => all.extend(parts),
                        part => all.push(part),
                    },
                    _ => all.push(Circuit::Parallel(branches)),
                }
            }
        }
    }
    all
}

/// Every item of a circuit.
pub(crate) fn items(circuit: &Circuit<Item>) -> Vec<&Item> {
    match circuit {
        Circuit::Element(item) => vec![item],
        Circuit::Series(parts) | Circuit::Parallel(parts) => parts.iter().flat_map(items).collect(),
    }
}
