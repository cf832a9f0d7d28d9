//! A network as rows of things that refactorings move about, and back to text.
//!
//! Only the order of things on a row and whether wire joins them is kept: the columns are the formatter's. Operands,
//! comments and the lines between rungs keep their text to the letter.

use super::item::{Item, ItemKind};
use super::remove::Spot;
use ladder_analysis::networks::order::order;
use ladder_analysis::program::Step;
use ladder_format::Edit;
use ladder_syntax::wiring::wiring;
use ladder_syntax::{Parse, TextRange};
use std::ops::Range;

/// One rung.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Row {
    pub(crate) items: Vec<Item>,
    /// Where its line is in the file, without the line end; empty if it is new.
    pub(crate) at: TextRange,
    /// The lines between it and the next rung, line ends included.
    pub(crate) below: Vec<String>,
}

/// A network.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Drawing {
    pub(crate) rows: Vec<Row>,
    /// Lines of comments above the first rung, line ends included.
    pub(crate) head: String,
    pub(super) line_end: &'static str,
    /// The text of the network in the file, without the last line end.
    pub(super) range: TextRange,
}

impl Drawing {
    /// A drawing of some rows that is not in the file yet, to be written with the line ends of another one.
    pub(crate) fn with_rows(&self, rows: Vec<Row>) -> Drawing {
        Drawing {
            rows,
            head: String::new(),
            line_end: self.line_end,
            range: self.range,
        }
    }

    pub(crate) fn line_end(&self) -> &'static str {
        self.line_end
    }

    /// Where it is in the file, without the last line end.
    pub(crate) fn range(&self) -> TextRange {
        self.range
    }

    /// The text, without the last line end. Its columns are for the formatter to set right.
    pub(crate) fn text(&self) -> String {
        let mut out = self.head.clone();
        for (number, row) in self.rows.iter().enumerate() {
            if number > 0 {
                out.push_str(self.line_end);
                out.extend(self.rows[number - 1].below.iter().map(String::as_str));
            }
            for (index, item) in row.items.iter().enumerate() {
                match (index, item.kind) {
                    (0, ItemKind::LeftRail | ItemKind::Bar) => {}
                    (0, _) => out.push_str("   "),
                    _ if item.joined => out.push_str("--"),
                    _ => out.push_str("  "),
                }
                out.push_str(&item.text);
            }
        }
        out
    }

    /// The edit that puts it in the place of what it was read from.
    pub(crate) fn replace(&self) -> Edit {
        Edit {
            range: self.range,
            text: self.text(),
        }
    }

    /// The numbers of the blocks in the order in which they are evaluated, new ones as none. None if the text would
    /// not be one network.
    pub(crate) fn order(&self) -> Option<Vec<Option<usize>>> {
        let parse = ladder_syntax::parse(&self.text());
        let [network] = parse.structure().networks.as_slice() else {
            return None;
        };
        let wiring = wiring(&parse, network);
        if !wiring.unpaired.is_empty() || wiring.rungs.len() != self.rows.len() {
            return None;
        }
        let numbers: Vec<Option<usize>> = self
            .rows
            .iter()
            .flat_map(|row| &row.items)
            .filter_map(|item| match item.kind {
                ItemKind::Block(number) => Some(number),
                _ => None,
            })
            .collect();
        let steps = order(&wiring).steps;
        let blocks = steps.iter().filter_map(|step| match step {
            Step::Block { block, .. } => numbers.get(*block).copied(),
            _ => None,
        });
        Some(blocks.collect())
    }

    /// The same, without the new blocks.
    pub(crate) fn old_order(&self) -> Option<Vec<usize>> {
        Some(self.order()?.into_iter().flatten().collect())
    }

    /// The items of a kind on a row.
    pub(crate) fn all(&self, row: usize, kind: ItemKind) -> impl Iterator<Item = usize> + '_ {
        let items = self.rows.get(row).map_or(&[][..], |row| &row.items);
        let found = items
            .iter()
            .enumerate()
            .filter(move |(_, item)| item.kind == kind);
        found.map(|(index, _)| index)
    }

    /// How many items of a kind are on a row before an index.
    pub(crate) fn count_before(&self, row: usize, index: usize, kind: ItemKind) -> usize {
        self.all(row, kind).take_while(|&at| at < index).count()
    }

    /// The `/` that a `\` pairs with, on the next row.
    pub(crate) fn up_of(&self, row: usize, down: usize) -> Option<usize> {
        let ordinal = self.count_before(row, down, ItemKind::Down);
        self.all(row + 1, ItemKind::Up).nth(ordinal)
    }

    /// The `\` that a `/` pairs with, on the row before.
    pub(crate) fn down_of(&self, row: usize, up: usize) -> Option<usize> {
        let ordinal = self.count_before(row, up, ItemKind::Up);
        self.all(row.checked_sub(1)?, ItemKind::Down).nth(ordinal)
    }

    /// The items that wire joins to one.
    pub(crate) fn segment(&self, row: usize, index: usize) -> Range<usize> {
        let items = &self.rows[row].items;
        let mut start = index;
        while start > 0 && items[start].joined {
            start -= 1;
        }
        let after = items[index + 1..].iter().take_while(|item| item.joined).count();
        start..index + 1 + after
    }

    /// Whether a wire leads from a rail or another thing to the item.
    pub(crate) fn has_wire_before(&self, row: usize, index: usize) -> bool {
        self.rows[row].items[index].joined
    }

    /// Whether a wire goes on after an item.
    pub(crate) fn has_wire_after(&self, row: usize, index: usize) -> bool {
        self.rows[row]
            .items
            .get(index + 1)
            .is_some_and(|item| item.joined)
    }

    /// Where on a row its first thing that is drawn is: before it are only comments.
    pub(crate) fn drawn_start(&self, row: usize) -> usize {
        let items = &self.rows[row].items;
        let loose = |&(n, item): &(usize, &Item)| item.is_loose(items.get(n + 1));
        items.iter().enumerate().take_while(loose).count()
    }

    /// Takes an item out; what is on both sides of it is joined if both were.
    pub(crate) fn take(&mut self, row: usize, index: usize) -> Item {
        let items = &mut self.rows[row].items;
        let item = items.remove(index);
        if let Some(next) = items.get_mut(index) {
            next.joined &= item.joined;
        }
        item
    }

    /// Puts comments beside a rung, after it.
    pub(super) fn put_beside(&mut self, row: usize, comments: impl IntoIterator<Item = Item>) {
        let loose = comments.into_iter().map(|item| Item {
            joined: false,
            ..item
        });
        self.rows[row].items.extend(loose);
    }

    /// Where the things are that something holds for.
    pub(super) fn spots(&self, is: impl Fn(&Item) -> bool) -> Vec<Spot> {
        let items = self.rows.iter().enumerate().flat_map(|(row, own)| {
            let items = own.items.iter().enumerate();
            items.map(move |(index, item)| ((row, index), item))
        });
        items.filter(|(_, item)| is(item)).map(|(spot, _)| spot).collect()
    }

    /// The rows of this network and those of a network below it, with the lines that are between the two. The blocks of the second
    /// are counted on.
    pub(crate) fn followed_by(&self, between: Vec<String>, second: &Drawing) -> Drawing {
        let mut both = self.clone();
        let items = || self.rows.iter().flat_map(|row| &row.items);
        let count = items().filter(|item| item.is_block()).count();
        if let Some(last) = both.rows.last_mut() {
            last.below = between;
        }
        both.rows.extend(second.rows.iter().cloned().map(|mut row| {
            for item in &mut row.items {
                if let ItemKind::Block(Some(number)) = &mut item.kind {
                    *number += count;
                }
            }
            row
        }));
        both.range = self.range.cover(second.range);
        both
    }

    /// Takes over the comments of a drawing that it takes the place of as well: those on rungs behind its own first one, those
    /// between rungs above it.
    pub(crate) fn take_comments_of(&mut self, other: &Drawing) {
        for row in &other.rows {
            self.head.push_str(&comments(&row.below));
            for (index, item) in row.items.iter().enumerate() {
                if let (true, Some(first)) = (item.is_loose(row.items.get(index + 1)), self.rows.first_mut())
                {
                    first.items.push(item.clone());
                }
            }
        }
    }

    /// Takes rows out that hold nothing but comments; the comments go to the row above, or below the first. Lines of
    /// comments that no rung is below any more go above the first.
    pub(crate) fn drop_empty_rows(&mut self) {
        let mut row = 0;
        while row < self.rows.len() {
            let drawn = self.rows[row]
                .items
                .iter()
                .any(|item| item.kind != ItemKind::Comment);
            if drawn || self.rows.len() == 1 {
                row += 1;
                continue;
            }
            let gone = self.rows.remove(row);
            if row > 0 {
                self.put_beside(row - 1, gone.items);
                self.rows[row - 1].below.extend(gone.below);
            } else {
                let comments = gone.items.into_iter().map(|item| Item {
                    joined: false,
                    ..item
                });
                self.rows[0].items.splice(0..0, comments);
            }
        }
        if let Some(last) = self.rows.last_mut() {
            self.head.push_str(&comments(&std::mem::take(&mut last.below)));
        }
    }
}

/// The lines of comments among some lines between rungs.
pub(crate) fn comments(lines: &[String]) -> String {
    let comments = lines.iter().filter(|line| line.contains('#'));
    comments.map(String::as_str).collect()
}

/// The text of a logical line, line end included.
pub(crate) fn line_text(parse: &Parse, line: usize) -> String {
    parse.lines()[line].text().to_owned()
}

/// The text of some logical lines.
pub(crate) fn lines_text(parse: &Parse, lines: Range<usize>) -> String {
    lines.map(|line| line_text(parse, line)).collect()
}
