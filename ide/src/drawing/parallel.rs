//! Two branches that part at one point and meet at another.

use super::item::ItemKind;
use super::rows::Drawing;
use std::ops::Range;

/// Two branches between the same two points.
#[derive(Debug, Clone)]
pub(crate) struct Parallel {
    /// The row of the upper one, and the `\` at both ends of it.
    pub(crate) row: usize,
    pub(crate) left: usize,
    pub(crate) right: usize,
    /// The row of the lower one, and the `/` at both ends of it.
    pub(crate) below: usize,
    pub(crate) below_left: usize,
    pub(crate) below_right: usize,
}

impl Parallel {
    /// The branches that part at a `\`, if they meet again further right and nothing else joins the lower one. Rows
    /// that they only pass count.
    pub(crate) fn at(drawing: &Drawing, row: usize, left: usize) -> Option<Parallel> {
        let found = Parallel::below(drawing, row, left)?;
        // On the row of the upper branch one wire holds both ends.
        let upper = drawing.segment(row, left);
        (found.right > left && upper.contains(&found.right)).then_some(found)
    }

    fn below(drawing: &Drawing, row: usize, left: usize) -> Option<Parallel> {
        let up = drawing.up_of(row, left)?;
        let segment = drawing.segment(row + 1, up);
        let last = segment.end - 1;
        let kind = |index: usize| drawing.rows[row + 1].items[index].kind;
        if segment.start != up || last == up {
            return None;
        }
        if segment.len() == 2 && kind(last) == ItemKind::Down {
            let inner = Parallel::below(drawing, row + 1, last)?;
            let back = inner.right + 1;
            if drawing.segment(row + 1, inner.right) != (inner.right..back + 1) || kind(back) != ItemKind::Up
            {
                return None;
            }
            let right = drawing.down_of(row + 1, back)?;
            return Some(Parallel {
                row,
                left,
                right,
                ..inner
            });
        }
        if kind(last) != ItemKind::Up {
            return None;
        }
        Some(Parallel {
            row,
            left,
            right: drawing.down_of(row + 1, last)?,
            below: row + 1,
            below_left: up,
            below_right: last,
        })
    }

    pub(crate) fn upper(&self) -> Range<usize> {
        self.left + 1..self.right
    }

    pub(crate) fn lower(&self) -> Range<usize> {
        self.below_left + 1..self.below_right
    }
}
