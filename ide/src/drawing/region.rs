//! A part of a network that power enters at one end and leaves at the other: some things in a row of one rung, with
//! all that is joined below them.

use super::gap::Gap;
use super::item::{Item, ItemKind};
use super::rows::{Drawing, Row};
use std::ops::Range;

/// A part of a network with one wire in and one wire out.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Region {
    /// The row that both wires are on.
    pub(crate) top: usize,
    /// The items on that row and on those below it.
    pub(crate) rows: Vec<Range<usize>>,
}

impl Region {
    /// The region that begins and ends on a row with these items. None if what is below them is also joined to
    /// something else.
    pub(crate) fn of(drawing: &Drawing, top: usize, items: Range<usize>) -> Option<Region> {
        let on_top = drawing.rows.get(top)?.items.get(items.clone())?;
        let rail = |item: &Item| matches!(item.kind, ItemKind::LeftRail | ItemKind::RightRail);
        if on_top.is_empty()
            || on_top.iter().any(rail)
            || on_top
                .iter()
                .any(|item| item.kind == ItemKind::Up || item.kind == ItemKind::Stub)
            || !on_top[1..].iter().all(|item| item.joined)
        {
            return None;
        }
        let mut rows = vec![items];
        loop {
            let row = top + rows.len() - 1;
            let range = rows[rows.len() - 1].clone();
            let first = drawing.count_before(row, range.start, ItemKind::Down);
            let after = drawing.count_before(row, range.end, ItemKind::Down);
            if first == after {
                break;
            }
            let left = drawing.all(row + 1, ItemKind::Up).nth(first)?;
            let right = drawing.all(row + 1, ItemKind::Up).nth(after - 1)?;
            let start = drawing.segment(row + 1, left).start;
            let end = drawing.segment(row + 1, right).end;
            let below = &drawing.rows[row + 1].items[start..end];
            if below.iter().any(rail)
                || drawing.count_before(row + 1, start, ItemKind::Up) != first
                || drawing.count_before(row + 1, end, ItemKind::Up) != after
            {
                return None;
            }
            rows.push(start..end);
        }
        Some(Region { top, rows })
    }

    /// The places in the wires on both sides of it.
    pub(crate) fn gaps(&self) -> [Gap; 2] {
        [self.rows[0].start, self.rows[0].end].map(|index| Gap { row: self.top, index })
    }

    /// Its items on its first row.
    pub(crate) fn on_top(&self) -> Range<usize> {
        self.rows[0].clone()
    }

    /// The last row that it reaches to.
    pub(crate) fn bottom(&self) -> usize {
        self.top + self.rows.len() - 1
    }

    /// All its items.
    pub(crate) fn items<'d>(&'d self, drawing: &'d Drawing) -> impl Iterator<Item = &'d Item> {
        let rows = self.rows.iter().enumerate();
        rows.flat_map(|(n, range)| &drawing.rows[self.top + n].items[range.clone()])
    }

    /// Where its blocks are.
    pub(crate) fn things(&self, drawing: &Drawing) -> Vec<(usize, usize)> {
        let rows = self.rows.iter().enumerate();
        let spots = rows.flat_map(|(n, range)| range.clone().map(move |index| (self.top + n, index)));
        spots
            .filter(|&(row, index)| drawing.rows[row].items[index].is_block())
            .collect()
    }

    /// The numbers of its blocks, from left to right, top to bottom.
    pub(crate) fn blocks(&self, drawing: &Drawing) -> Vec<usize> {
        let number = |item: &Item| match item.kind {
            ItemKind::Block(number) => number,
            _ => None,
        };
        self.items(drawing).filter_map(number).collect()
    }

    /// Whether its blocks are evaluated one after the other, with no other between them.
    pub(crate) fn is_evaluated_at_once(&self, drawing: &Drawing) -> bool {
        let Some(order) = drawing.old_order() else {
            return false;
        };
        let blocks = self.blocks(drawing);
        let first = order.iter().position(|block| blocks.contains(block));
        let run = first.and_then(|first| order.get(first..first + blocks.len()));
        run.is_some_and(|run| run.iter().all(|block| blocks.contains(block)))
    }

    /// Its rows as a drawing of their own, without what is around them.
    pub(crate) fn copy(&self, drawing: &Drawing) -> Vec<Row> {
        let rows = self.rows.iter().enumerate();
        rows.map(|(n, range)| Row {
            items: drawing.rows[self.top + n].items[range.clone()].to_vec(),
            ..Row::default()
        })
        .collect()
    }

    /// Takes it out of a drawing, from its last row to its first; on the first row something comes in its place.
    pub(crate) fn replace(&self, drawing: &mut Drawing, with: Vec<Item>) {
        for (n, range) in self.rows.iter().enumerate().skip(1).rev() {
            let items = &mut drawing.rows[self.top + n].items;
            items.drain(range.clone());
            if let Some(next) = items.get_mut(range.start) {
                next.joined = false;
            }
        }
        let items = &mut drawing.rows[self.top].items;
        let joined = items[self.rows[0].start].joined;
        let none = with.is_empty();
        items.splice(self.rows[0].clone(), with);
        if let Some(next) = items.get_mut(self.rows[0].start) {
            next.joined = if none { next.joined && joined } else { joined };
        }
        drawing.drop_empty_rows();
    }
}
