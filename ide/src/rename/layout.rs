//! Edits of names and of the drawing that they move.
//!
//! A longer name shifts what is after it, and the connectors below are no longer under theirs. So the names are changed first, then
//! every network is laid out again in which a name has another width now, and every section that was laid out before; and both
//! steps become one list of small edits.

use ladder_format::{Edit, Options, apply, display_width, format_ranges};
use ladder_syntax::{LineKind, Parse, TextRange, TextSize, parse};

/// The edits of names in a text, and those that put its drawing straight afterwards, as one.
pub(super) fn laid_out(old: &Parse, text: &str, names: &[Edit], options: &Options) -> Vec<Edit> {
    let renamed = apply(text, names);
    let parsed = parse(&renamed);
    let shift = Shift::of(names);
    let mut ranges = moved(old, text, names, &shift);
    let sections = straight_sections(old, names, options);
    ranges.extend(sections.into_iter().map(|range| shift.range(range)));
    let straighten = format_ranges(&parsed, options, &ranges);
    compose(text, names, &renamed, &straighten)
}

/// Where the new names appear once all are there, as far as they move what is drawn after them. Declarations are no
/// drawing: those that were not laid out stay.
fn moved(old: &Parse, text: &str, names: &[Edit], shift: &Shift<'_>) -> Vec<TextRange> {
    let moves = |edit: &&Edit| {
        let line = old.line_at(edit.range.start());
        line.is_some_and(|line| old.lines()[line].kind == LineKind::Rung)
            && display_width(&text[edit.range]) != display_width(&edit.text)
    };
    names
        .iter()
        .filter(moves)
        .map(|edit| {
            let start = shift.offset(edit.range.start());
            TextRange::at(start, TextSize::of(edit.text.as_str()))
        })
        .collect()
}

/// The sections with one of the names that are laid out as they should be.
fn straight_sections(old: &Parse, names: &[Edit], options: &Options) -> Vec<TextRange> {
    let structure = old.structure_once();
    let ranges = structure.sections.iter().map(|section| {
        let end = old.line_range(section.lines.end - 1).end();
        TextRange::new(old.line_start(section.lines.start), end)
    });
    let is_named = |range: &TextRange| names.iter().any(|name| range.contains_range(name.range));
    let is_straight = |range: &TextRange| format_ranges(old, options, &[*range]).is_empty();
    ranges.filter(is_named).filter(is_straight).collect()
}

/// Where things lie when the edits before them are made.
struct Shift<'e> {
    edits: &'e [Edit],
    /// How much the text has grown before each edit, and after the last.
    grown: Vec<i64>,
}

impl<'e> Shift<'e> {
    fn of(edits: &'e [Edit]) -> Shift<'e> {
        let mut grown = vec![0];
        for edit in edits {
            let by = edit.text.len() as i64 - i64::from(u32::from(edit.range.len()));
            grown.push(grown[grown.len() - 1] + by);
        }
        Shift { edits, grown }
    }

    fn offset(&self, offset: TextSize) -> TextSize {
        let before = self
            .edits
            .partition_point(|edit| edit.range.end() <= offset && edit.range.start() < offset);
        TextSize::new((i64::from(u32::from(offset)) + self.grown[before]) as u32)
    }

    fn range(&self, range: TextRange) -> TextRange {
        TextRange::new(self.offset(range.start()), self.offset(range.end()))
    }
}

/// Two lists of edits, one made after the other, as one list of edits of the first text. `between` is the text that
/// the first ones make.
pub(super) fn compose(text: &str, first: &[Edit], between: &str, second: &[Edit]) -> Vec<Edit> {
    /// An edit by the range that it has in the text between, and what it adds to the length of that text.
    struct GrownEdit<'e> {
        start: usize,
        end: usize,
        grows: i64,
        second: Option<&'e Edit>,
    }
    let mut grown = 0i64;
    let mut steps: Vec<GrownEdit<'_>> = first
        .iter()
        .map(|edit| {
            let start = (i64::from(u32::from(edit.range.start())) + grown) as usize;
            let grows = edit.text.len() as i64 - i64::from(u32::from(edit.range.len()));
            grown += grows;
            GrownEdit {
                start,
                end: start + edit.text.len(),
                grows,
                second: None,
            }
        })
        .collect();
    steps.extend(second.iter().map(|edit| GrownEdit {
        start: edit.range.start().into(),
        end: edit.range.end().into(),
        grows: 0,
        second: Some(edit),
    }));
    steps.sort_by_key(|step| (step.start, step.end));
    let mut edits = Vec::new();
    let mut before = 0i64;
    let mut rest = &steps[..];
    while let Some(leader) = rest.first() {
        let mut end = leader.end;
        let mut count = 1;
        while rest.get(count).is_some_and(|step| step.start <= end) {
            end = end.max(rest[count].end);
            count += 1;
        }
        let (group, others) = rest.split_at(count);
        rest = others;
        let grows: i64 = group.iter().map(|step| step.grows).sum();
        let old = (leader.start as i64 - before) as usize..(end as i64 - before - grows) as usize;
        before += grows;
        let mut new = String::new();
        let mut at = leader.start;
        for edit in group.iter().filter_map(|step| step.second) {
            new.push_str(&between[at..usize::from(edit.range.start())]);
            new.push_str(&edit.text);
            at = edit.range.end().into();
        }
        new.push_str(&between[at..end]);
        if text[old.clone()] != new {
            let range = TextRange::new(TextSize::new(old.start as u32), TextSize::new(old.end as u32));
            edits.push(Edit { range, text: new });
        }
    }
    edits
}

#[cfg(test)]
mod tests {
    use super::*;

    fn edit(start: u32, end: u32, text: &str) -> Edit {
        Edit {
            range: TextRange::new(start.into(), end.into()),
            text: text.to_owned(),
        }
    }

    #[test]
    fn two_lists_become_one() {
        let text = "abcdefgh";
        let check = |first: &[Edit], second: &[Edit], expected: &[Edit]| {
            let between = apply(text, first);
            let both = compose(text, first, &between, second);
            assert_eq!(apply(text, &both), apply(&between, second));
            assert_eq!(both, expected);
        };
        check(&[], &[edit(1, 2, "x")], &[edit(1, 2, "x")]);
        check(&[edit(1, 2, "xyz")], &[], &[edit(1, 2, "xyz")]);
        // bcd -> xyz, then after it f -> .
        check(
            &[edit(1, 2, "xyz")],
            &[edit(7, 8, "")],
            &[edit(1, 2, "xyz"), edit(5, 6, "")],
        );
        // What touches becomes one.
        check(&[edit(1, 2, "xyz")], &[edit(4, 5, "-")], &[edit(1, 3, "xyz-")]);
        check(&[edit(1, 2, "xyz")], &[edit(2, 6, "")], &[edit(1, 4, "x")]);
        // What was changed and changed back is nothing.
        check(&[edit(1, 2, "xyz")], &[edit(1, 4, "b")], &[]);
        check(
            &[edit(0, 1, ""), edit(4, 4, "!!")],
            &[edit(0, 1, "B"), edit(6, 7, "F")],
            &[edit(0, 2, "B"), edit(4, 4, "!!"), edit(5, 6, "F")],
        );
    }
}
