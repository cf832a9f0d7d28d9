//! Writing a file: what is between its networks, sections and comments (LANGUAGE §8 rule 7).
//!
//! ```text
//! text --LineReader--> a part --Networks::read--> columns --File::item--> what changes
//!            ^                                                  |
//!            +------------------- the next part <---------------+
//! ```

use crate::Options;
use crate::draw::Rails;
use crate::edit::Sink;
use crate::flat::{Flat, Source};
use crate::network::Drawing;
use crate::networks::{Networks, Placed, rail_column};
use crate::pen::Pen;
use crate::ranges::{Asked, keep_all_but};
use crate::section;
use crate::stays::{Stays, item_lines};
use crate::width::display_width;
use ladder_syntax::SyntaxKind::{COMMENT, RAIL_CONNECTOR};
use ladder_syntax::{Item, LineKind, LineReader, TextRange, TextSize};
use std::ops::Range;

/// So much of a text is read, placed and written before what follows, in bytes: what is known of it fits into the
/// processor's cache, and a large file takes little more memory than its text.
const PART: usize = 48 << 10;

/// Formats a text: all of it, or what one of the ranges of `only` reaches into.
pub(crate) fn format<S: Sink>(text: &str, options: &Options, only: Option<&[TextRange]>, sink: S) -> S {
    let only = only.map(|ranges| Asked::new(ranges, TextSize::of(text)));
    let only = only.as_ref();
    let mut file = File {
        text,
        options,
        pen: Pen::new(text, sink),
        above: None,
        between: Vec::new(),
        begun: false,
    };
    let mut networks = Networks::default();
    if file.parts(&mut networks, only, PART).is_err() {
        file.pen.begin_again();
        file.between.clear();
        file.begun = false;
        file.above = None;
        // In one part there is no earlier one.
        let _ = file.parts(&mut networks, only, usize::MAX);
    }
    file.pen.finish()
}

/// A comment is never closed: what is not to be relied on may begin in a part that is written already.
struct NeverClosed;

/// What is written of a file.
struct File<'f, S> {
    text: &'f str,
    options: &'f Options,
    pen: Pen<'f, S>,
    /// The rails of the network above.
    above: Option<Rails>,
    /// Blank and rail lines after the last thing of the part.
    between: Vec<usize>,
    /// Something was written.
    begun: bool,
}

/// A part of a file, as far as it is known before it is written.
struct PendingPart<'p> {
    source: Source<'p>,
    stays: Stays,
    networks: &'p mut Networks,
}

impl<S: Sink> File<'_, S> {
    /// Reads and writes part by part, each of `least` bytes or somewhat more.
    fn parts(
        &mut self,
        networks: &mut Networks,
        only: Option<&Asked>,
        least: usize,
    ) -> Result<(), NeverClosed> {
        let mut reader = LineReader::new(self.text);
        let mut flat = Flat::default();
        let mut off = false;
        networks.begin_file();
        while reader.at() < self.text.len() {
            let is_first = reader.at() == 0;
            flat.read(&mut reader, least);
            let source = Source::new(self.text, &flat);
            if source.lines.unclosed_comment().is_some() && !is_first {
                return Err(NeverClosed);
            }
            let mut stays = Stays::find(source, &mut off);
            networks.read(source, self.options, &mut stays);
            if let Some(asked) = only {
                keep_all_but(source, asked, &mut stays);
            }
            if is_first && self.text.starts_with('\u{feff}') {
                self.pen.keep(0, '\u{feff}'.len_utf8());
            }
            let mut part = PendingPart {
                source,
                stays,
                networks,
            };
            for item in &source.lines.structure().items {
                self.item(&mut part, *item);
            }
        }
        Ok(())
    }

    fn item(&mut self, part: &mut PendingPart<'_>, item: Item) {
        let lines = item_lines(part.source.lines, item);
        let line = lines.start;
        if !self.begun && self.text[part.source.range(line).start..].starts_with('\u{feff}') {
            // At the start of the text this stray character would become a byte order mark.
            self.between.clear();
            self.keep(part, 0..line);
        }
        if part.stays.line(line) {
            self.begin(part);
            self.above = match item {
                Item::Network(_) => Some(rails_as_drawn(part.source, lines.clone())),
                Item::Decoration(_) => self.above,
                _ => None,
            };
            self.keep(part, lines);
            return;
        }
        match item {
            Item::Decoration(_) if !part.source.has_comment(line) => self.between.push(line),
            Item::Decoration(_) => {
                self.begin(part);
                section::comment_line(part.source, line, &mut self.pen);
                self.keep_line_end(part, line);
            }
            Item::Network(number) => {
                self.begin(part);
                self.network(part, number);
            }
            Item::Section(_) => {
                self.begin(part);
                self.above = None;
                section::write(part.source, lines, &mut self.pen);
            }
            Item::BlockHeader(_) | Item::BlockEnd(_) => {
                self.begin(part);
                self.above = None;
                if !part.source.has_error(line) && !has_leading_comment(part.source, line) {
                    section::words(part.source, line, &mut self.pen);
                    self.keep_line_end(part, line);
                } else {
                    self.keep(part, lines);
                }
            }
            Item::Stray(_) => {
                self.begin(part);
                self.keep(part, lines);
            }
        }
    }

    fn network(&mut self, part: &mut PendingPart<'_>, number: usize) {
        let Some(Placed { rungs, outline }) = part.networks.placed[number].clone() else {
            return;
        };
        let right = outline
            .railed_right
            .then(|| rail_column(outline.rail, self.options));
        let rails = Rails {
            left: outline.railed_left,
            right,
        };
        self.above = Some(rails);
        if let Some(rail) = right {
            part.networks.placer.place_right(
                &part.networks.reader.sketch,
                rungs.clone(),
                self.options.spacing,
                rail,
                &mut part.networks.columns,
            );
        }
        Drawing {
            source: part.source,
            network: &part.source.lines.structure().networks[number],
            reader: &part.networks.reader,
            columns: &part.networks.columns,
            first_rung: rungs.start,
            rails,
            spacing: self.options.spacing,
        }
        .write(&mut self.pen);
    }

    /// Writes what belongs between the last thing and the one that comes: a blank line if one was blank, the rails of
    /// the network above if only rail lines were there, else nothing. Before the first thing is nothing.
    fn begin(&mut self, part: &PendingPart<'_>) {
        let begun = std::mem::replace(&mut self.begun, true);
        let Some(&first) = self.between.first().filter(|_| begun) else {
            self.between.clear();
            return;
        };
        let is_blank = |line: &usize| part.source.kind(*line) == LineKind::Blank;
        let blank = self.between.iter().copied().find(is_blank);
        if let Some(Rails { left, right }) = self.above.filter(|_| blank.is_none()) {
            if left {
                self.pen.bar();
            }
            if let Some(column) = right {
                self.pen.blanks(column - u32::from(left));
                self.pen.bar();
            }
        }
        self.keep_line_end(part, blank.unwrap_or(first));
        self.between.clear();
    }

    /// Keeps lines to the letter.
    fn keep(&mut self, part: &PendingPart<'_>, lines: Range<usize>) {
        if let Some(last) = lines.clone().next_back() {
            self.pen
                .keep(part.source.range(lines.start).start, part.source.range(last).end);
        }
    }

    fn keep_line_end(&mut self, part: &PendingPart<'_>, line: usize) {
        if let Some(line_end) = part.source.line_end(line) {
            self.pen.keep(line_end, part.source.range(line).end);
        }
    }
}

/// The rails of a network that stays as it is.
fn rails_as_drawn(source: Source<'_>, lines: Range<usize>) -> Rails {
    let mut rails = Rails {
        left: false,
        right: None,
    };
    for line in lines.filter(|line| source.kind(*line) == LineKind::Rung) {
        let drawn = source.line(line).children();
        let drawn = drawn.filter(|child| !child.kind().is_trivia());
        for (number, connector) in drawn
            .enumerate()
            .filter(|(_, child)| child.kind() == RAIL_CONNECTOR)
        {
            if number == 0 {
                rails.left = true;
                continue;
            }
            let before = &source.text[source.range(line).start..connector.start()];
            let before = before.rsplit(['\n', '\r']).next().unwrap_or(before);
            rails.right = rails.right.max(Some(display_width(before)));
        }
    }
    rails
}

/// Whether a comment is first on a line.
fn has_leading_comment(source: Source<'_>, line: usize) -> bool {
    let mut words = source.line(line).children();
    let first = words.find(|child| !child.kind().is_trivia() || child.kind() == COMMENT);
    first.is_some_and(|child| child.kind() == COMMENT)
}
