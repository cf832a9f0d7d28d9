//! What decides nothing, or always the same, is taken out of a rung.

use super::{Spot, action};
use crate::drawing::item::ItemKind;
use crate::drawing::parallel::Parallel;
use crate::drawing::region::Region;
use crate::refactor::Action;
use crate::refactor::remove_branch::removed;
use ladder_analysis::{Analysis, Diagnostic};
use ladder_format::Edit;
use ladder_syntax::TextRange;

/// A title shows a block whole that is not longer.
const LONGEST: usize = 40;

/// Of two conditions that are never on together one is too many. Two branches of which one always conducts are a wire.
pub(super) fn of_constant(analysis: &Analysis, found: &Diagnostic) -> Vec<Action> {
    let Some(spot) = Spot::find(analysis, found.range) else {
        return Vec::new();
    };
    let others = || found.related.iter().filter(|place| place.file.is_none());
    let is_beside = |place: TextRange| Spot::find(analysis, place).is_some_and(|other| other.row != spot.row);
    if others().any(|place| is_beside(place.range)) {
        return wire_for_branches(&spot).into_iter().collect();
    }
    // One that always conducts has a fix.
    if !found.fixes.is_empty() {
        return Vec::new();
    }
    let places = std::iter::once(found.range).chain(others().map(|place| place.range));
    places.filter_map(|place| block(analysis, place)).collect()
}

/// What is redundant goes with its branch, where a wire in its place would not do: that is a fix of the rule.
pub(super) fn of_redundant(analysis: &Analysis, found: &Diagnostic) -> Option<Action> {
    branch(analysis, found.range).filter(|_| found.fixes.is_empty())
}

/// A wire in the place of a block.
fn block(analysis: &Analysis, place: TextRange) -> Option<Action> {
    let spot = Spot::find(analysis, place)?;
    let name = spot.name()?;
    let item = &spot.on.drawing.rows[spot.row].items[spot.index];
    let edit = Edit {
        range: item.at,
        text: "--".to_owned(),
    };
    let shown = match item.text.len() {
        0..=LONGEST => &item.text,
        _ => &name,
    };
    Some(action(
        format!("Draw a wire in the place of `{shown}`"),
        vec![edit],
    ))
}

/// The branch that a block is in goes.
pub(super) fn branch(analysis: &Analysis, place: TextRange) -> Option<Action> {
    let spot = Spot::find(analysis, place)?;
    let (drawing, name) = removed(&spot.on, spot.row, spot.index..spot.index + 1)?;
    Some(action(
        format!("Remove the branch with `{name}`"),
        vec![drawing.replace()],
    ))
}

/// A wire in the place of the two branches of which one holds a block.
fn wire_for_branches(spot: &Spot<'_>) -> Option<Action> {
    let drawing = &spot.on.drawing;
    let downs = drawing.all(spot.row, ItemKind::Down);
    let parallels = downs.filter_map(|down| Parallel::at(drawing, spot.row, down));
    let around = parallels
        .filter(|found| found.upper().contains(&spot.index))
        .min_by_key(|found| found.upper().len())?;
    let region = Region::of(drawing, around.row, around.left..around.right + 1)?;
    let mut new = drawing.clone();
    region.replace(&mut new, Vec::new());
    new.order()?;
    Some(action(
        "Draw a wire instead of the branches".to_owned(),
        vec![new.replace()],
    ))
}
