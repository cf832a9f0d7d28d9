//! The one writer that draws a network: rungs, and the lines between them, from a sketch and its columns.

use crate::sketch::{ElementKind, NONE, Sketch};

/// What a network is drawn onto: the old text with what changes in it, or a new text.
pub(crate) trait Surface {
    fn blanks(&mut self, count: u32);
    fn dashes(&mut self, count: u32);
    fn bar(&mut self);
    /// The text of an element.
    fn element(&mut self, index: usize);
}

/// The rails of a network.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Rails {
    /// There is a rail in column 0.
    pub(crate) left: bool,
    /// The column, from 0, of the right rail.
    pub(crate) right: Option<u32>,
}

/// Draws a rung from its left end to its right rail.
pub(crate) fn rung(sketch: &Sketch, rung: usize, columns: &[u32], rails: Rails, on: &mut impl Surface) {
    let range = &sketch.rungs[rung];
    let elements = sketch.rung(rung);
    let mut column = 0;
    let begins_at_rail = elements
        .first()
        .is_some_and(|e| matches!(e.kind, ElementKind::LeftRail | ElementKind::LeftBar));
    if rails.left && !begins_at_rail {
        on.bar();
        column = 1;
    }
    for (index, element) in (range.start as usize..).zip(elements) {
        let distance = columns[index] - column;
        if element.joined {
            on.dashes(distance);
        } else {
            on.blanks(distance);
        }
        match element.kind {
            ElementKind::Stub => on.dashes(element.width),
            ElementKind::LeftBar | ElementKind::RightBar => on.bar(),
            _ => on.element(index),
        }
        column = columns[index] + element.width;
    }
    let ends_at_rail = elements
        .last()
        .is_some_and(|e| matches!(e.kind, ElementKind::RightRail | ElementKind::RightBar));
    if let Some(rail) = rails.right.filter(|_| !ends_at_rail) {
        on.blanks(rail.saturating_sub(column));
        on.bar();
    }
}

/// The columns in which the pairs between a rung and the next one go on downward.
pub(crate) fn verticals<'s>(
    sketch: &'s Sketch,
    rung: usize,
    columns: &'s [u32],
) -> impl Iterator<Item = u32> + use<'s> {
    let start = sketch.rungs[rung].start as usize;
    sketch
        .rung(rung)
        .iter()
        .enumerate()
        .filter(|(_, e)| e.kind == ElementKind::Down && e.partner != NONE)
        .map(move |(n, _)| columns[start + n])
}

/// Draws the rails and verticals of a line between two rungs, all but those in `covered`, a range of columns.
/// `comments` draws what is there, once all left of it is drawn, and says in which column it ends.
pub(crate) fn between<S: Surface>(
    rails: Rails,
    verticals: impl Iterator<Item = u32>,
    covered: Option<(u32, Cover)>,
    on: &mut S,
    comments: impl FnOnce(&mut S),
) {
    let mut column = 0;
    let mut comments = Some(comments);
    let left = rails.left.then_some(0);
    for at in left.into_iter().chain(verticals).chain(rails.right) {
        if let Some((start, cover)) = covered {
            // What a comment covers or touches is left out.
            if at + 1 >= start && cover.reaches(at) {
                continue;
            }
            if at >= start
                && let Some(comments) = comments.take()
            {
                on.blanks(start - column);
                comments(on);
                column = match cover {
                    Cover::Until(end) => end,
                    Cover::Everything => return,
                };
            }
        }
        // A pair in the rail's own column cannot be, but two in one column would be one vertical.
        if at < column {
            continue;
        }
        on.blanks(at - column);
        on.bar();
        column = at + 1;
    }
    if let Some((start, _)) = covered
        && let Some(comments) = comments.take()
    {
        on.blanks(start - column);
        comments(on);
    }
}

/// How far the comments on a line between two rungs reach.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Cover {
    /// Up to this column, which is free.
    Until(u32),
    /// One of them ends on a later line of the text: nothing can be right of it.
    Everything,
}

impl Cover {
    fn reaches(self, column: u32) -> bool {
        match self {
            Cover::Until(end) => column <= end,
            Cover::Everything => true,
        }
    }
}
