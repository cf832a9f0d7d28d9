//! Two networks become one: branches between the rails.

use super::item::Item;
use super::rows::Drawing;
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
    if new.old_order().is_none() || new.old_order() != one_after_the_other(first, second) {
        return Err("the blocks of the networks would run in another order");
    }
    Ok(new)
}

/// The order in which the blocks of a network and the next one run.
fn one_after_the_other(first: &Drawing, second: &Drawing) -> Option<Vec<usize>> {
    let mut order = first.old_order()?;
    let count = order.len();
    order.extend(second.old_order()?.into_iter().map(|number| number + count));
    Some(order)
}
