//! Power that goes nowhere: a coil takes it, another line takes it, or nothing makes it.

use super::{Spot, action, join_above};
use crate::drawing::item::{Item, ItemKind};
use crate::drawing::remove::{drop_passed_rows, remove};
use crate::drawing::rows::Drawing;
use crate::refactor::Action;
use crate::refactor::names::new_tag;
use crate::refactor::place::Selected;
use crate::refactor::split_network::declare;
use ladder_analysis::{Analysis, Diagnostic};
use ladder_syntax::TextRange;

pub(super) fn offer(analysis: &Analysis, found: &Diagnostic) -> Vec<Action> {
    let Some(spot) = Spot::find(analysis, found.range) else {
        return Vec::new();
    };
    let segment = spot.on.drawing.segment(spot.row, spot.index);
    let goes_on = |item: &Item| {
        matches!(
            item.kind,
            ItemKind::Down | ItemKind::Up | ItemKind::RightRail | ItemKind::LeftRail
        )
    };
    let items = &spot.on.drawing.rows[spot.row].items;
    if items[spot.index..segment.end].iter().any(goes_on) {
        return Vec::new();
    }
    // A bare wire would short what is above it.
    let has_block = items[segment.clone()].iter().any(Item::is_block);
    let joined = has_block
        .then(|| join_above::offer_end(&spot, segment.end))
        .flatten();
    let coil = with_coil(analysis, &spot, segment.end);
    let gone = without(&spot, segment.start, segment.end).map(|drawing| {
        let name = spot
            .name()
            .map_or_else(|| "the wire".to_owned(), |name| format!("`{name}`"));
        action(
            format!("Remove {name}, whose power nothing uses"),
            vec![drawing.replace()],
        )
    });
    joined.into_iter().chain(coil).chain(gone).collect()
}

/// A new coil takes the power.
fn with_coil(analysis: &Analysis, spot: &Spot<'_>, end: usize) -> Option<Action> {
    let tag = new_tag(spot.context, &[], "new_coil");
    let mut new = spot.on.drawing.clone();
    let rails = new.rows.iter().flat_map(|row| &row.items);
    let is_railed = rails.into_iter().any(|item| item.kind == ItemKind::RightRail);
    let items = &mut new.rows[spot.row].items;
    let is_last = items[end..].iter().all(|item| item.kind == ItemKind::Comment);
    let mut end = end;
    if items[end - 1].kind == ItemKind::Stub {
        end -= 1;
        items.remove(end);
    }
    let drawn = std::iter::once(Item::block(format!("( )( {tag} )")))
        .chain((is_railed && is_last).then(Item::right_rail));
    items.splice(end..end, drawn);
    new.order()?;
    let mut edits = vec![new.replace()];
    let place = Selected::find(analysis, TextRange::empty(spot.on.drawing.range().start()));
    edits.extend(declare(&place, spot.on.facts.scope, &tag)?);
    Some(action(format!("Put a coil `{tag}` after it"), edits))
}

/// The drawing without what nothing uses, and without the branch that holds nothing else.
fn without(spot: &Spot<'_>, start: usize, end: usize) -> Option<Drawing> {
    let drawing = &spot.on.drawing;
    let mut new = drawing.clone();
    let items = &drawing.rows[spot.row].items;
    let is_first = spot.index == start + 1;
    match items[start].kind {
        ItemKind::Up if is_first => {
            let above = spot.row.checked_sub(1)?;
            let down = drawing.down_of(spot.row, start)?;
            remove(&mut new, spot.row, start..end);
            new.take(above, down);
        }
        ItemKind::LeftRail if is_first => remove(&mut new, spot.row, start..end),
        _ => remove(&mut new, spot.row, spot.index..end),
    }
    new.drop_empty_rows();
    drop_passed_rows(&mut new);
    new.order()?;
    Some(new)
}
