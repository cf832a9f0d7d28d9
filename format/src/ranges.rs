//! Formatting a part of a file: what nobody asked for stays.

use crate::flat::Source;
use crate::stays::{Stays, item_lines};
use ladder_syntax::{Item, TextRange};
use std::ops::Range;

/// Makes stay what none of the ranges reaches into.
pub(crate) fn keep_all_but(source: Source<'_>, ranges: &[TextRange], stays: &mut Stays) {
    let lines = source.lines;
    let items = &lines.structure().items;
    let is_touched = |item: &Range<usize>| {
        let place = TextRange::new(lines.line_start(item.start), lines.line_range(item.end - 1).end());
        ranges.iter().any(|range| {
            // A cursor is on the line that begins there; at the end of the text on the last one.
            let cursor = range.is_empty()
                && (place.contains(range.start())
                    || (place.end() == range.start() && place.end() == lines.text_len()));
            cursor || place.intersect(*range).is_some_and(|common| !common.is_empty())
        })
    };
    let mut index = 0;
    while index < items.len() {
        // Blank and rail lines in a row become one line or none, so they stay together.
        let run = items[index..]
            .iter()
            .take_while(|item| matches!(item, Item::Decoration(line) if !source.has_comment(*line)))
            .count()
            .max(1);
        let run = &items[index..index + run];
        if run.iter().any(|item| !is_touched(&item_lines(lines, *item))) {
            for item in run {
                stays.keep(item_lines(lines, *item));
            }
        }
        index += run.len();
    }
}
