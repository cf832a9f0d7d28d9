//! A network as rows of things that refactorings move about, and back to text.
//!
//! Only the order of things on a row and whether wire joins them is kept: the columns are the formatter's. Operands,
//! comments and the lines between rungs keep their text to the letter.

use ladder_analysis::context::Context;
pub(crate) use ladder_analysis::names::declaring::line_end;
use ladder_analysis::networks::order::order;
use ladder_analysis::program::Step;
use ladder_format::Edit;
use ladder_syntax::wiring::{PartKind, Rung, RungPart, Wiring, wiring};
use ladder_syntax::{Network, Parse, TextRange, TextSize};
use std::ops::Range;

/// What a thing on a row is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ItemKind {
    LeftRail,
    RightRail,
    Down,
    Up,
    /// A block; its number in the network's facts, or none for a new one.
    Block(Option<usize>),
    Comment,
    /// A wire that ends at nothing.
    Stub,
    /// A `|` that the wire at either end of a row reaches to.
    Bar,
    /// In a term: a branch ends there, and nothing is drawn.
    Open,
    /// A place that an operation is about; it is gone before anything is drawn.
    Mark(Mark),
}

/// What an operation marks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Mark {
    /// Where something begins, or is put in.
    From,
    /// Where it ends, or goes to.
    To,
}

/// One thing on a row.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Item {
    pub(crate) kind: ItemKind,
    pub(crate) text: String,
    /// Whether wire joins it to the item before it.
    pub(crate) joined: bool,
    /// Where it is in the file, unless it is new.
    pub(crate) at: TextRange,
}

impl Item {
    pub(crate) fn new(kind: ItemKind, text: impl Into<String>, joined: bool) -> Item {
        Item {
            kind,
            text: text.into(),
            joined,
            at: TextRange::empty(TextSize::new(0)),
        }
    }

    pub(crate) fn left_rail() -> Item {
        Item::new(ItemKind::LeftRail, "+", false)
    }

    pub(crate) fn right_rail() -> Item {
        Item::new(ItemKind::RightRail, "+", true)
    }

    pub(crate) fn down() -> Item {
        Item::new(ItemKind::Down, "\\", true)
    }

    pub(crate) fn up(joined: bool) -> Item {
        Item::new(ItemKind::Up, "/", joined)
    }

    pub(crate) fn block(text: impl Into<String>) -> Item {
        Item::new(ItemKind::Block(None), text, true)
    }

    pub(crate) fn is_block(&self) -> bool {
        matches!(self.kind, ItemKind::Block(_))
    }

    /// Whether it is not in the file, or was taken from its place there.
    pub(crate) fn is_new(&self) -> bool {
        self.at.is_empty()
    }

    /// Whether a branch ends there by itself.
    pub(crate) fn is_end(&self) -> bool {
        matches!(
            self.kind,
            ItemKind::RightRail | ItemKind::Stub | ItemKind::Bar | ItemKind::Open
        )
    }

    /// A comment that is not a piece of a wire. It joins nothing, and what is after it is not joined to it.
    pub(crate) fn is_loose(&self, next: Option<&Item>) -> bool {
        self.kind == ItemKind::Comment && !self.joined && next.is_none_or(|next| !next.joined)
    }
}

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
    line_end: &'static str,
    /// The text of the network in the file, without the last line end.
    range: TextRange,
}

impl Drawing {
    /// The drawing of a network. None where it holds an error, or cannot be laid out again.
    pub(crate) fn read(context: &Context, network: usize) -> Option<Drawing> {
        let facts = context.networks.at(network);
        (!facts.broken).then(|| Drawing::of_network(context, network).ok())?
    }

    /// The drawing of a network of which each connector has its partner.
    ///
    /// # Errors
    /// Why it has none.
    pub(crate) fn of_network(context: &Context, network: usize) -> Result<Drawing, Undrawn> {
        let facts = context.networks.at(network);
        Drawing::of(&context.parse, facts.first_line, &facts.wiring)
    }

    /// The drawing of a network of a text.
    pub(crate) fn of_text(parse: &Parse, network: &Network) -> Result<Drawing, Undrawn> {
        Drawing::of(parse, network.lines.start, &wiring(parse, network))
    }

    fn of(parse: &Parse, first_line: usize, wiring: &Wiring) -> Result<Drawing, Undrawn> {
        let mut rows = Vec::with_capacity(wiring.rungs.len());
        let mut block = 0;
        let mut range: Option<TextRange> = None;
        let lines = wiring.line_offsets.iter().map(|offset| first_line + offset);
        let lines: Vec<usize> = lines.collect();
        for (drawn, (rung, &line)) in wiring.rungs.iter().zip(lines.iter().enumerate()) {
            let text = line_text(parse, line);
            let start = parse.line_start(line);
            let items = items(drawn, &text, start, &mut block)?;
            let shown = text.trim_end_matches(['\r', '\n']);
            let place = TextRange::at(start, TextSize::of(shown));
            range = Some(range.map_or(place, |range| range.cover(place)));
            let next = lines.get(rung + 1).copied();
            let below = (line + 1..next.unwrap_or(line + 1)).map(|line| line_text(parse, line));
            rows.push(Row {
                items,
                at: place,
                below: below.collect(),
            });
        }
        let mut range = range.ok_or(Undrawn::Nothing)?;
        if range.start() == TextSize::new(0) && line_text(parse, 0).starts_with('\u{feff}') {
            range = TextRange::new(TextSize::of('\u{feff}'), range.end());
        }
        Ok(Drawing {
            rows,
            head: String::new(),
            line_end: line_end(parse),
            range,
        })
    }

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
            let comments = gone.items.into_iter().map(|item| Item {
                joined: false,
                ..item
            });
            if row > 0 {
                self.rows[row - 1].items.extend(comments);
                self.rows[row - 1].below.extend(gone.below);
            } else {
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

/// Why a network has no drawing that can be changed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Undrawn {
    /// A `+` is in the middle of a wire.
    StrayRail,
    /// A `|` is in the middle of a wire.
    StrayBar,
    /// A character means nothing.
    Junk,
    /// A comment between two things of a rung goes on on the next line.
    CommentOfLines,
    /// There is no rung.
    Nothing,
}

impl Undrawn {
    /// The sentence for a person.
    pub(crate) fn message(self) -> &'static str {
        match self {
            Undrawn::StrayRail => "a `+` is in the middle of a wire here: put that right in the text first",
            Undrawn::StrayBar => "a `|` is in the middle of a wire here: put that right in the text first",
            Undrawn::Junk => "a character here means nothing: put that right in the text first",
            Undrawn::CommentOfLines => {
                "a comment in a wire here has several lines: write it on one line in the text first"
            }
            Undrawn::Nothing => "there is no rung here",
        }
    }
}

fn items(drawn: &Rung, text: &str, start: TextSize, block: &mut usize) -> Result<Vec<Item>, Undrawn> {
    let parts = &drawn.parts;
    let mut items: Vec<Item> = Vec::new();
    let mut last_segment = None;
    let mut at_bar = false;
    for (index, part) in parts.iter().enumerate() {
        let after_bar = std::mem::take(&mut at_bar);
        let kind = match part.kind {
            PartKind::StrayRail => return Err(Undrawn::StrayRail),
            PartKind::StrayBar => return Err(Undrawn::StrayBar),
            PartKind::Junk => return Err(Undrawn::Junk),
            PartKind::Bar => match touched(parts, index) {
                Touched::Nothing => continue,
                Touched::Right if index == 0 => {
                    at_bar = true;
                    ItemKind::Bar
                }
                Touched::Left if is_last(parts, index) => ItemKind::Bar,
                _ => return Err(Undrawn::StrayBar),
            },
            PartKind::Wire => {
                let segment = part
                    .segment
                    .and_then(|number| drawn.segments.get(number as usize));
                let is_between = |ends: &Range<usize>| {
                    let left = ends.start < index || after_bar;
                    let right = index + 1 < ends.end
                        || (is_last(parts, index + 1)
                            && parts
                                .get(index + 1)
                                .is_some_and(|next| next.kind == PartKind::Bar && next.touches));
                    left && right
                };
                if segment.is_some_and(|segment| is_between(&segment.parts)) {
                    at_bar = after_bar;
                    last_segment = part.segment;
                    continue;
                }
                ItemKind::Stub
            }
            PartKind::LeftRail => ItemKind::LeftRail,
            PartKind::RightRail => ItemKind::RightRail,
            PartKind::Down => ItemKind::Down,
            PartKind::Up => ItemKind::Up,
            PartKind::Comment => ItemKind::Comment,
            PartKind::Block => {
                *block += 1;
                ItemKind::Block(Some(*block - 1))
            }
        };
        let mut shown = &text[part.range];
        // Between two things on its rung a comment with a line end keeps the formatter off the network.
        if kind == ItemKind::Comment && shown.contains(['\n', '\r']) {
            return Err(Undrawn::CommentOfLines);
        }
        if kind == ItemKind::Stub {
            shown = "--";
        }
        let joined = match kind {
            ItemKind::Bar => !at_bar,
            _ => after_bar || (part.segment.is_some() && part.segment == last_segment),
        };
        last_segment = part.segment;
        items.push(Item {
            kind,
            text: shown.to_owned(),
            joined,
            at: part.range + start,
        });
    }
    Ok(items)
}

/// On which side wire reaches to a `|`.
enum Touched {
    Nothing,
    Left,
    Right,
    Both,
}

fn touched(parts: &[RungPart], index: usize) -> Touched {
    let wire = |part: &RungPart| part.segment.is_some();
    let before = parts[index].touches && index > 0 && wire(&parts[index - 1]);
    let after = parts
        .get(index + 1)
        .is_some_and(|part| part.touches && wire(part));
    match (before, after) {
        (false, false) => Touched::Nothing,
        (true, false) => Touched::Left,
        (false, true) => Touched::Right,
        (true, true) => Touched::Both,
    }
}

/// Whether nothing but comments is behind a part.
fn is_last(parts: &[RungPart], index: usize) -> bool {
    let behind = parts.get(index + 1..).unwrap_or_default();
    behind
        .iter()
        .all(|part| part.kind == PartKind::Comment && part.segment.is_none())
}
