//! What is selected in a drawing.

use super::item::{Item, ItemKind};
use super::region::Region;
use super::remove::Spot;
use super::rows::Drawing;
use ladder_syntax::TextRange;

/// The blocks and comments that a range of the text reaches into; with what leads down and up again all that is between.
pub(crate) fn things(drawing: &Drawing, range: TextRange) -> Vec<Spot> {
    let mut found = Vec::new();
    for (row, own) in drawing.rows.iter().enumerate() {
        let reaches = |at: TextRange| {
            if range.is_empty() {
                at.contains_inclusive(range.start())
            } else {
                at.start() < range.end() && range.start() < at.end()
            }
        };
        let touched = own.items.iter().enumerate().filter(|(_, item)| reaches(item.at));
        let touched: Vec<usize> = touched.map(|(index, _)| index).collect();
        let leads = |index: &&usize| own.items[**index].kind == ItemKind::Down;
        let lines: Vec<usize> = touched.iter().filter(leads).copied().collect();
        if let (Some(&first), Some(&last)) = (lines.first(), lines.last())
            && first < last
            && let Some(region) = Region::of(drawing, row, first..last + 1)
        {
            for (n, range) in region.rows.iter().enumerate() {
                found.extend(range.clone().map(|index| (region.top + n, index)));
            }
        }
        found.extend(touched.into_iter().map(|index| (row, index)));
    }
    let is_thing = |&(row, index): &Spot| {
        let item: &Item = &drawing.rows[row].items[index];
        let is_comment =
            item.kind == ItemKind::Comment && !item.is_loose(drawing.rows[row].items.get(index + 1));
        item.is_block() || is_comment
    };
    found.retain(is_thing);
    found.sort_unstable();
    found.dedup();
    found
}
