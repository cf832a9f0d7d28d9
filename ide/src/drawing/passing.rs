//! New rows between two rungs: what joins them goes through the new row.

use super::item::{Item, ItemKind};
use super::rows::{Drawing, Row};
use ladder_syntax::TextRange;

/// Which way power runs between two rungs at a pair of connectors.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Way {
    Down,
    Up,
    /// Power runs both ways: first up, then down again.
    Both,
}

impl Way {
    fn of(drawing: &Drawing, row: usize, down: usize, up: usize) -> Way {
        let above = (
            drawing.has_wire_before(row, down),
            drawing.has_wire_after(row, down),
        );
        let below = (
            drawing.has_wire_before(row + 1, up),
            drawing.has_wire_after(row + 1, up),
        );
        match (above.0 && below.1, below.0 && above.1) {
            (true, true) => Way::Both,
            (false, true) => Way::Up,
            // Power that goes nowhere comes from where it came.
            (false, false) if below.0 && !above.0 => Way::Up,
            _ => Way::Down,
        }
    }

    /// What is on the new row.
    fn wires(self) -> Vec<Item> {
        let down = || [Item::up(false), Item::down()];
        let up = || [Item::new(ItemKind::Down, "\\", false), Item::up(true)];
        match self {
            Way::Down => down().into(),
            Way::Up => up().into(),
            Way::Both => up().into_iter().chain(down()).collect(),
        }
    }
}

/// Puts rows between a row and the next one. What they hold comes after the wires of the first `before` pairs between
/// the two. Says how many items the row above has more among those pairs than before.
pub(crate) fn insert_rows(drawing: &mut Drawing, above: usize, before: usize, rows: Vec<Vec<Item>>) -> usize {
    let pairs: Vec<(usize, usize)> = drawing
        .all(above, ItemKind::Down)
        .zip(drawing.all(above + 1, ItemKind::Up))
        .collect();
    let ways: Vec<Way> = pairs
        .iter()
        .map(|&(down, up)| Way::of(drawing, above, down, up))
        .collect();
    // From the right, so that the indices of those on the left stay true.
    for (&(down, up), way) in pairs.iter().zip(&ways).rev() {
        if *way == Way::Both {
            drawing.rows[above].items.insert(down + 1, Item::down());
            drawing.rows[above + 1].items.insert(up + 1, Item::up(true));
        }
    }
    let (left, right) = ways.split_at(before.min(ways.len()));
    let mut below = std::mem::take(&mut drawing.rows[above].below);
    for items in rows.into_iter().rev() {
        let left = left.iter().flat_map(|way| way.wires());
        let right = right.iter().flat_map(|way| way.wires());
        let row = Row {
            at: TextRange::default(),
            items: left.chain(items).chain(right).collect(),
            below: std::mem::take(&mut below),
        };
        drawing.rows.insert(above + 1, row);
    }
    if !below.is_empty() {
        drawing.rows[above].below = below;
    }
    left.iter().filter(|way| **way == Way::Both).count()
}

/// Puts rows into a drawing before an item of a row: the first onto that row, where wire joins it on both sides, each
/// other onto a new row.
pub(crate) fn splice(drawing: &mut Drawing, row: usize, at: usize, rows: Vec<Row>) {
    let before = drawing.count_before(row, at, ItemKind::Down);
    let mut rows = rows.into_iter().map(|row| row.items);
    let Some(first) = rows.next() else { return };
    let rest: Vec<_> = rows.collect();
    let more = if rest.is_empty() {
        0
    } else {
        insert_rows(drawing, row, before, rest)
    };
    let at = at + more;
    drawing.rows[row].items.splice(at..at, first);
}
