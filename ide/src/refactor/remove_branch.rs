//! A parallel branch goes: the one that the cursor is in.

use super::insert_branch::first_name;
use super::place::{OnNetwork, Selected};
use super::{Action, ActionKind};
use crate::drawing::remove::{branch_around, without};
use crate::drawing::rows::Drawing;
use std::ops::Range;

pub(super) fn offer(place: &Selected<'_>, out: &mut Vec<Action>) {
    let Some(on) = &place.on else { return };
    let Some((row, items)) = on.trimmed() else { return };
    let Some((drawing, name)) = removed(on, row, items) else {
        return;
    };
    let title = format!("Remove the parallel branch with `{name}` (changes what the rung does)");
    out.push(Action::new(ActionKind::Rewrite, title, vec![drawing.replace()]));
}

/// The drawing without the smallest branch around some items of a row, and how a title calls that branch.
pub(super) fn removed(on: &OnNetwork<'_>, row: usize, items: Range<usize>) -> Option<(Drawing, String)> {
    let branch = branch_around(&on.drawing, row, items)?;
    let new = without(&on.drawing, &branch.region.things(&on.drawing)).ok()??;
    Some((new, first_name(on, &branch.region)))
}
