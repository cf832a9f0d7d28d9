//! Two networks become one: branches between the rails.

use super::rows::{Drawing, Item};
use super::term::{Rung, normal};
use ladder_format::Circuit;

/// The drawing of a network and the next one as branches of one, with the lines of comments that are between them.
///
/// # Errors
/// Why they cannot be.
pub(crate) fn merged(
    first: &Drawing,
    second: &Drawing,
    between: Vec<String>,
) -> Result<Drawing, &'static str> {
    const NO_TERM: &str = "both networks must be in series and in parallel, from the left rail to one end";
    let both = first.followed_by(between, second);
    let (upper, lower) = (
        Rung::read(first).ok_or(NO_TERM)?,
        Rung::read(second).ok_or(NO_TERM)?,
    );
    if upper.railed != lower.railed {
        return Err("one of the networks ends at the right rail, and the other does not");
    }
    let numbered = |parts: Vec<Circuit<Item>>| -> Vec<Circuit<Item>> {
        let by = |item: Item| {
            let items = both.rows.iter().flat_map(|row| &row.items);
            let found = items
                .into_iter()
                .find(|other| !item.is_new() && other.at == item.at);
            Circuit::Element(found.cloned().unwrap_or(item))
        };
        parts.into_iter().map(|part| part.replaced(&by)).collect()
    };
    let branches = [upper.parts.clone(), numbered(lower.parts)].map(Circuit::Series);
    let new = upper.draw(&both, normal(vec![Circuit::Parallel(branches.into())]));
    let order = new.old_order().unwrap_or_default();
    let runs_on = order
        .iter()
        .enumerate()
        .all(|(number, _)| order.contains(&number));
    let before = [first, second].map(|drawing| drawing.old_order().unwrap_or_default());
    let count = before[0].len();
    let expected = before[0]
        .iter()
        .copied()
        .chain(before[1].iter().map(|number| number + count));
    if !runs_on || !order.iter().copied().eq(expected) {
        return Err("the blocks of the networks would run in another order");
    }
    Ok(new)
}
