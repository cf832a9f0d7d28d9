//! Formatting a part of a file: what nobody asked for stays.

use crate::flat::Source;
use crate::stays::{Stays, item_lines};
use ladder_syntax::{Item, LineKind, TextRange, TextSize};
use std::ops::Range;

/// Makes stay what none of the ranges reaches into.
pub(crate) fn keep_all_but(source: Source<'_>, asked: &Asked, stays: &mut Stays) {
    let lines = source.lines;
    let items = &lines.structure().items;
    let is_touched = |item: &Range<usize>| {
        asked.reaches_into(TextRange::new(
            lines.line_start(item.start),
            lines.line_range(item.end - 1).end(),
        ))
    };
    let mut index = 0;
    // Rail lines have the rails of the network above: they change with it.
    let mut is_network_above_touched = false;
    while index < items.len() {
        // Blank and rail lines in a row become one line or none, so they stay together.
        let run = items[index..]
            .iter()
            .take_while(|item| matches!(item, Item::Decoration(line) if !source.has_comment(*line)))
            .count()
            .max(1);
        let run = &items[index..index + run];
        let is_rail =
            |item: &Item| matches!(item, Item::Decoration(line) if source.kind(*line) == LineKind::Rail);
        let follows = is_network_above_touched && run.iter().all(is_rail);
        let is_kept = run.iter().any(|item| !is_touched(&item_lines(lines, *item)));
        if let Item::Network(_) = run[0] {
            is_network_above_touched = !is_kept;
        }
        if is_kept && !follows {
            for item in run {
                stays.keep(item_lines(lines, *item));
            }
        }
        index += run.len();
    }
}

/// Ranges that are asked for, in an order in which many are found quickly.
pub(crate) struct Asked {
    /// Where ranges begin, in order, each with the furthest end of those up to it.
    ranges: Vec<(TextSize, TextSize)>,
    /// Where cursors are, in order.
    cursors: Vec<TextSize>,
    text_len: TextSize,
}

impl Asked {
    /// Ranges of a text that is this long.
    pub(crate) fn new(asked: &[TextRange], text_len: TextSize) -> Asked {
        let mut cursors: Vec<TextSize> = Vec::new();
        let mut ranges: Vec<(TextSize, TextSize)> = Vec::new();
        for range in asked {
            if range.is_empty() {
                cursors.push(range.start());
            } else {
                ranges.push((range.start(), range.end()));
            }
        }
        cursors.sort_unstable();
        ranges.sort_unstable();
        let mut furthest = TextSize::new(0);
        for (_, end) in &mut ranges {
            furthest = furthest.max(*end);
            *end = furthest;
        }
        Asked {
            ranges,
            cursors,
            text_len,
        }
    }

    fn reaches_into(&self, place: TextRange) -> bool {
        let before_end = self.ranges.partition_point(|(start, _)| *start < place.end());
        let reaches = before_end
            .checked_sub(1)
            .is_some_and(|last| self.ranges[last].1 > place.start());
        // A cursor is on the line that begins there; at the end of the text on the last one.
        let first = self.cursors.partition_point(|cursor| *cursor < place.start());
        let cursor = self.cursors.get(first).is_some_and(|cursor| {
            *cursor < place.end() || (*cursor == place.end() && place.end() == self.text_len)
        });
        reaches || cursor
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_as_asking_each_range() {
        let at = |start: u32, end: u32| TextRange::new(start.into(), end.into());
        let mut asked = vec![];
        for seed in 0..200u32 {
            let start = seed * 7919 % 60;
            asked.push(at(start, (start + seed * 31 % 9).min(64)));
            let each = |place: TextRange| {
                asked.iter().any(|range| {
                    let cursor = range.is_empty()
                        && (place.contains(range.start())
                            || (place.end() == range.start() && place.end() == 64.into()));
                    cursor || place.intersect(*range).is_some_and(|common| !common.is_empty())
                })
            };
            let some = &asked[asked.len().saturating_sub(3)..];
            let (all, few) = (Asked::new(&asked, 64.into()), Asked::new(some, 64.into()));
            for start in 0..64 {
                for end in [start + 1, (start + 9).min(64), 64] {
                    let place = at(start, end);
                    assert_eq!(all.reaches_into(place), each(place), "{place:?} of {asked:?}");
                    let by_each = some
                        .iter()
                        .any(|range| Asked::new(&[*range], 64.into()).reaches_into(place));
                    assert_eq!(few.reaches_into(place), by_each, "{place:?} of {some:?}");
                }
            }
        }
    }
}
