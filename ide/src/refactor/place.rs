//! What an editor's selection means: the network, its drawing, the things on a rung.

use crate::drawing::item::{Item, ItemKind};
use crate::drawing::region::Region;
use crate::drawing::rows::Drawing;
use ladder_analysis::Analysis;
use ladder_analysis::context::Context;
use ladder_analysis::networks::{BlockAt, NetworkAt};
use ladder_syntax::TextRange;
use std::ops::Range;

/// A place in a file that actions are asked for.
pub(crate) struct Selected<'a> {
    analysis: Option<&'a Analysis>,
    pub(crate) context: &'a Context,
    pub(crate) range: TextRange,
    /// The networks that the selection reaches into, or the cursor is in.
    pub(crate) networks: Range<usize>,
    /// Where it is one network whose drawing can be read: what is selected in it.
    pub(crate) on: Option<OnNetwork<'a>>,
}

/// A place in a network.
pub(crate) struct OnNetwork<'a> {
    pub(crate) network: usize,
    pub(crate) facts: NetworkAt<'a>,
    pub(crate) drawing: Drawing,
    /// The row, and the items on it that are selected, if all are on one row.
    pub(crate) items: Option<(usize, Range<usize>)>,
}

impl<'a> Selected<'a> {
    pub(crate) fn find(analysis: &'a Analysis, range: TextRange) -> Selected<'a> {
        Selected {
            analysis: Some(analysis),
            ..Selected::in_context(&analysis.context, range)
        }
    }

    /// The same where it is not known what is wrong in the file.
    pub(crate) fn in_context(context: &'a Context, range: TextRange) -> Selected<'a> {
        let networks = touched(context, range);
        let on = (networks.len() == 1)
            .then(|| on_network(context, networks.start, range))
            .flatten();
        Selected {
            analysis: None,
            context,
            range,
            networks,
            on,
        }
    }
}

impl Selected<'_> {
    /// Whether the file has errors.
    pub(crate) fn has_errors(&self) -> bool {
        self.analysis.is_some_and(Analysis::has_errors)
    }
}

/// The networks that a range reaches into.
fn touched(context: &Context, range: TextRange) -> Range<usize> {
    let networks = &context.networks;
    let first = networks.partition_point(|network| network.range.end() <= range.start());
    let reaches = |place: TextRange| {
        place.start() < range.end() || (range.is_empty() && place.contains_inclusive(range.start()))
    };
    let count = networks
        .range(first..networks.len())
        .take_while(|network| reaches(network.range))
        .count();
    // At the end of a text without a last line end.
    let at_end = first > 0 && range.is_empty() && range.start() == context.parse.text_len();
    if count == 0 && at_end && networks.at(first - 1).range.end() == range.start() {
        return first - 1..first;
    }
    first..first + count
}

fn on_network(context: &Context, network: usize, range: TextRange) -> Option<OnNetwork<'_>> {
    let drawing = Drawing::read(context, network)?;
    let items = selected(&drawing, range);
    Some(OnNetwork {
        network,
        facts: context.networks.at(network),
        drawing,
        items,
    })
}

/// The items that a range reaches into, all on one row; for a cursor the one that it is in or touches.
fn selected(drawing: &Drawing, range: TextRange) -> Option<(usize, Range<usize>)> {
    let mut found: Option<(usize, Range<usize>)> = None;
    for (number, row) in drawing.rows.iter().enumerate() {
        let touched: Vec<usize> = if range.is_empty() {
            let at_cursor = row.items.iter().enumerate();
            let at_cursor = at_cursor.filter(|(_, item)| item.at.contains_inclusive(range.start()));
            // Of two that touch, a block before all else, then the right one.
            let best = at_cursor.max_by_key(|(index, item)| (item.is_block(), *index));
            best.map(|(index, _)| index).into_iter().collect()
        } else {
            let reaches = |at: TextRange| at.start() < range.end() && range.start() < at.end();
            let items = row.items.iter().enumerate();
            items
                .filter(|(_, item)| reaches(item.at))
                .map(|(index, _)| index)
                .collect()
        };
        let (Some(&first), Some(&last)) = (touched.first(), touched.last()) else {
            continue;
        };
        if found.is_some() {
            return None;
        }
        found = Some((number, first..last + 1));
    }
    found
}

impl OnNetwork<'_> {
    /// The selected items without rails, loose comments and loose ends at both ends.
    pub(crate) fn trimmed(&self) -> Option<(usize, Range<usize>)> {
        let (row, items) = self.items.clone()?;
        let wanted = |index: usize| {
            matches!(
                self.drawing.rows[row].items[index].kind,
                ItemKind::Block(_) | ItemKind::Down | ItemKind::Up
            )
        };
        let start = items.clone().find(|&index| wanted(index))?;
        let end = items.rev().find(|&index| wanted(index))? + 1;
        Some((row, start..end))
    }

    /// The region that is selected, if it holds a block.
    pub(crate) fn region(&self) -> Option<Region> {
        let (row, items) = self.trimmed()?;
        let region = Region::of(&self.drawing, row, items)?;
        let has_block = region.items(&self.drawing).any(Item::is_block);
        has_block.then_some(region)
    }

    /// The one block that is selected.
    pub(crate) fn block(&self) -> Option<BlockAt<'_>> {
        let (row, items) = self.items.clone()?;
        let [item] = &self.drawing.rows[row].items[items] else {
            return None;
        };
        match item.kind {
            ItemKind::Block(Some(number)) => self.facts.blocks().nth(number),
            _ => None,
        }
    }

    /// Some of its blocks.
    pub(crate) fn blocks(&self, numbers: &[usize]) -> impl Iterator<Item = BlockAt<'_>> {
        let numbers = numbers.to_vec();
        numbers
            .into_iter()
            .filter_map(|number| self.facts.blocks().nth(number))
    }
}
