//! A line without power, or one whose power goes nowhere, is joined to the line above.

use super::{Spot, action};
use crate::drawing::item::{Item, ItemKind};
use crate::drawing::rows::Drawing;
use crate::refactor::Action;
use ladder_analysis::{Analysis, Diagnostic};
use ladder_instructions::Shape;

/// A line that begins with nothing begins as a branch of the line above.
pub(super) fn offer_start(analysis: &Analysis, found: &Diagnostic) -> Option<Action> {
    let spot = Spot::find(analysis, found.range)?;
    let items = &spot.on.drawing.rows[spot.row].items;
    if items[spot.index].joined
        || matches!(
            items[spot.index].kind,
            ItemKind::Up | ItemKind::Down | ItemKind::LeftRail
        )
    {
        return None;
    }
    let column = spot.column(spot.row, items[spot.index].at.start());
    let mut new = spot.on.drawing.clone();
    draw_down(&spot, &mut new, spot.index, column)?;
    let items = &mut new.rows[spot.row].items;
    if items[spot.index].kind == ItemKind::Stub {
        items.remove(spot.index);
    }
    if let Some(first) = items.get_mut(spot.index) {
        first.joined = true;
    }
    items.insert(spot.index, Item::up(false));
    new.order()?;
    let title = "Begin it as a branch of the line above";
    Some(action(title.to_owned(), vec![new.replace()]))
}

/// A line whose power goes nowhere ends as a branch of the line above. `end` is after its last thing.
pub(super) fn offer_end(spot: &Spot<'_>, end: usize) -> Option<Action> {
    let items = &spot.on.drawing.rows[spot.row].items;
    let last = end.checked_sub(1)?;
    let column = spot.column(spot.row, items[last].at.end());
    let mut new = spot.on.drawing.clone();
    draw_down(spot, &mut new, end, column)?;
    let items = &mut new.rows[spot.row].items;
    if items[last].kind == ItemKind::Stub {
        items[last] = Item::up(items[last].joined);
    } else {
        items.insert(end, Item::up(true));
    }
    new.order()?;
    let title = "Join it to the line above, as a parallel branch";
    Some(action(title.to_owned(), vec![new.replace()]))
}

/// Draws a `\` on the row above, where it pairs with a `/` at an index of this row, into the wire that is nearest to a
/// column.
fn draw_down(spot: &Spot<'_>, new: &mut Drawing, index: usize, column: usize) -> Option<()> {
    let drawing = &spot.on.drawing;
    let above = spot.row.checked_sub(1)?;
    let before = drawing.count_before(spot.row, index, ItemKind::Up);
    let items = &drawing.rows[above].items;
    let first = match before.checked_sub(1) {
        Some(last) => drawing.all(above, ItemKind::Down).nth(last)? + 1,
        None => 0,
    };
    let until = drawing.all(above, ItemKind::Down).nth(before);
    let until = until.unwrap_or(items.len().checked_sub(1)?);
    // A branch comes back before what acts.
    let acts = |item: &Item| match item.kind {
        ItemKind::Block(Some(number)) => {
            let block = spot.on.facts.blocks.get(number);
            block.is_some_and(|block| block.facts.shape != Shape::Logical)
        }
        _ => false,
    };
    let acting = items[first..].iter().position(acts).map(|at| first + at);
    let until = acting.map_or(until, |acting| until.min(acting));
    let distance = |at: usize| {
        let start = spot.column(above, items[at].at.start());
        let end = spot.column(above, items[at - 1].at.end());
        end.saturating_sub(column) + (column + 1).saturating_sub(start)
    };
    let wires = (first.max(1)..=until).filter(|&at| items[at].joined);
    let at = wires.min_by_key(|&at| distance(at))?;
    new.rows[above].items.insert(at, Item::down());
    Some(())
}
