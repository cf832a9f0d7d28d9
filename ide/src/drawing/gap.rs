//! The places of a drawing where something can be put in: the wires between two things of a row, and the end of a branch.

use super::item::{Item, ItemKind, Mark};
use super::parallel::Parallel;
use super::rows::Drawing;
use super::term::Rung;
use ladder_syntax::TextSize;

/// A place before an item of a row, with wire on at least one side.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Gap {
    pub(crate) row: usize,
    pub(crate) index: usize,
}

impl Gap {
    /// The place in a wire, or behind the last thing of a branch that ends by itself. None elsewhere.
    pub(crate) fn at(drawing: &Drawing, place: TextSize) -> Option<Gap> {
        Some(Gap::on_line(drawing, place)?.of_branch(drawing))
    }

    /// The same, of a line as it is drawn.
    pub(crate) fn on_line(drawing: &Drawing, place: TextSize) -> Option<Gap> {
        let row = row_at(drawing, place)?;
        let items = &drawing.rows[row].items;
        let in_wire = |index: &usize| {
            let (before, item) = (&items[index - 1], &items[*index]);
            match (item.joined, item.kind, before.kind) {
                (true, ItemKind::Stub, _) => before.at.end() <= place && place <= item.at.end(),
                (true, _, ItemKind::Stub) => before.at.start() <= place && place <= item.at.start(),
                (true, ..) => before.at.end() <= place && place <= item.at.start(),
                (false, ..) => false,
            }
        };
        let is_end = |index: &usize| {
            let last = &items[index - 1];
            last.at.end() == place && is_open(items, *index)
        };
        let index = (1..items.len())
            .find(in_wire)
            .or_else(|| (1..=items.len()).find(is_end))?;
        Some(Gap { row, index })
    }

    /// A wire that only passes a row is that of the branch that it leads to.
    fn of_branch(self, drawing: &Drawing) -> Gap {
        let Gap { mut row, mut index } = self;
        while passes(drawing, row, index) {
            let items = &drawing.rows[row].items;
            let begins = items[index].kind == ItemKind::Down;
            let down = if begins { index } else { index - 1 };
            let Some(up) = drawing.up_of(row, down) else { break };
            row += 1;
            index = if begins { up + 1 } else { up };
        }
        Gap { row, index }
    }

    /// The place where its wire begins.
    pub(crate) fn anchor(self, drawing: &Drawing) -> TextSize {
        let items = &drawing.rows[self.row].items;
        let before = items[self.index - 1].at;
        match items[self.index - 1].kind {
            ItemKind::Stub => before.start(),
            _ => before.end(),
        }
    }
}

/// Whether nothing follows what is before an index on its wire, and it is a thing that power leaves.
fn is_open(items: &[Item], index: usize) -> bool {
    matches!(
        items[index - 1].kind,
        ItemKind::Block(_) | ItemKind::Comment | ItemKind::Down | ItemKind::Up
    ) && !items[index - 1].is_loose(items.get(index))
        && items.get(index).is_none_or(|item| !item.joined)
}

/// The row whose line holds a place.
pub(crate) fn row_at(drawing: &Drawing, place: TextSize) -> Option<usize> {
    let row = drawing.rows.partition_point(|row| row.at.end() < place);
    let found = drawing.rows.get(row)?;
    found.at.contains_inclusive(place).then_some(row)
}

/// Whether the wire before an item is all that a segment is, from line to line.
fn passes(drawing: &Drawing, row: usize, index: usize) -> bool {
    let items = &drawing.rows[row].items;
    let Some(item) = items.get(index).filter(|item| item.joined) else {
        return false;
    };
    let is_pair = matches!(
        (items[index - 1].kind, item.kind),
        (ItemKind::Up, ItemKind::Down) | (ItemKind::Down, ItemKind::Up)
    );
    is_pair && drawing.segment(row, index).len() == 2
}

/// Whether a gap is in the staircase of several branches, between the ends of one and those of the next: what is put in
/// there is before, or behind, all that are below.
fn is_in_staircase(drawing: &Drawing, row: usize, index: usize) -> bool {
    let items = &drawing.rows[row].items;
    let segment = drawing.segment(row, index);
    if items[segment.start].kind != ItemKind::Up || items[segment.start + 1].kind != ItemKind::Down {
        return false;
    }
    match Parallel::at(drawing, row, segment.start + 1) {
        Some(found) => {
            found.right + 2 == segment.end && (index == segment.start + 1 || index == found.right + 1)
        }
        // Branches that end by themselves.
        None => index == segment.start + 1,
    }
}

/// The places where the picture of a network has a point, from top to bottom: those of its wires that are a place in a
/// series of their own.
pub(crate) fn points(drawing: &Drawing) -> Vec<Gap> {
    let is_term = Rung::with_ends(drawing).is_some();
    let mut found = Vec::new();
    for (row, own) in drawing.rows.iter().enumerate() {
        for (index, item) in own.items.iter().enumerate().skip(1) {
            let is_point = item.joined
                && !passes(drawing, row, index)
                && !(is_term && is_in_staircase(drawing, row, index));
            found.extend(is_point.then_some(Gap { row, index }));
        }
    }
    found
}

impl Drawing {
    /// Marks gaps, from the last to the first.
    pub(crate) fn marked(&self, gaps: &[(Gap, Mark)]) -> Drawing {
        let mut new = self.clone();
        let mut gaps: Vec<(usize, (Gap, Mark))> = gaps.iter().copied().enumerate().collect();
        gaps.sort_by_key(|(order, (gap, _))| (gap.row, gap.index, *order));
        for (_, (gap, mark)) in gaps.into_iter().rev() {
            let items = &mut new.rows[gap.row].items;
            items.insert(gap.index, Item::new(ItemKind::Mark(mark), "", true));
        }
        new
    }
}
