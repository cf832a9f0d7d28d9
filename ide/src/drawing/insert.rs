//! Parts are put into a wire.

use super::gap::Gap;
use super::item::{Item, ItemKind, Mark};
use super::passing::splice;
use super::rows::Drawing;
use super::term::{Rung, items, normal, rows};
use ladder_format::Circuit;

/// The drawing with parts in a wire.
///
/// # Errors
/// Why they cannot be there.
pub(crate) fn with(drawing: &Drawing, gap: Gap, parts: Vec<Circuit<Item>>) -> Result<Drawing, &'static str> {
    let marked = drawing.marked(&[(gap, Mark::To)]);
    let new = match Rung::with_ends(&marked) {
        Some(rung) => rung.draw(drawing, in_place_of(Mark::To, &rung.parts, parts)),
        None => {
            let mut new = drawing.clone();
            splice(&mut new, gap.row, gap.index, rows(&Circuit::Series(parts)));
            new
        }
    };
    in_old_order(drawing, new)
}

/// A drawing in which all blocks of another one run one after the other as they did.
pub(crate) fn in_old_order(old: &Drawing, new: Drawing) -> Result<Drawing, &'static str> {
    const NOT_ONE: &str = "the lines would not be joined any more";
    let order = new.old_order().ok_or(NOT_ONE)?;
    let mut before = old.old_order().ok_or(NOT_ONE)?;
    before.retain(|block| order.contains(block));
    if before != order {
        return Err("the blocks of the network would run in another order");
    }
    Ok(new)
}

/// The parts with others in the place of a mark.
pub(crate) fn in_place_of(
    mark: Mark,
    parts: &[Circuit<Item>],
    with: Vec<Circuit<Item>>,
) -> Vec<Circuit<Item>> {
    let by = |item: Item| match item.kind {
        ItemKind::Mark(found) if found == mark => Circuit::Series(with.clone()),
        _ => Circuit::Element(item),
    };
    normal(parts.iter().cloned().map(|part| part.replaced(&by)).collect())
}

/// Whether one of some parts is a block.
pub(crate) fn has_block(parts: &[Circuit<Item>]) -> bool {
    parts.iter().flat_map(items).any(Item::is_block)
}
