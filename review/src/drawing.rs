//! An entry as text, with marks at what is not in the other form of it.

use crate::canonical;
use crate::outline::{Entry, Kind, Outline};
use ladder_analysis::context;
use ladder_analysis::context::Context;
use ladder_analysis::networks::{BlockAt, NetworkAt};
use ladder_format::{Options, display_width, format_text};
use ladder_syntax::SyntaxKind::{BOM, COMMENT, NEWLINE, STRING, WHITESPACE};
use ladder_syntax::wiring::{self, PartKind};
use ladder_syntax::{LineKind, Name, NodeOrToken, TextRange, TextSize, parse};
use similar::{Algorithm, DiffTag, capture_diff_slices};
use std::ops::Range;
use std::sync::Arc;

/// An entry as lines of text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Drawn {
    /// The lines from top to bottom.
    pub lines: Vec<DrawnLine>,
}

/// A line, and which of its columns are marked.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DrawnLine {
    /// What is on it.
    pub text: String,
    /// Ranges of bytes in it, from left to right, that differ from the other form.
    pub marks: Vec<Range<usize>>,
}

/// Draws an entry in this width. Nothing in it is marked.
pub fn draw(outline: &Outline, entry: &Entry, width: u32) -> Drawn {
    Sheet::new(outline, entry, width).drawn(&[])
}

/// Draws both forms of an entry, each with marks at what the other has not.
pub fn draw_both(old: (&Outline, &Entry), new: (&Outline, &Entry), width: u32) -> (Drawn, Drawn) {
    let (old, new) = (Sheet::new(old.0, old.1, width), Sheet::new(new.0, new.1, width));
    let (mut gone, mut added) = (vec![false; old.pieces.len()], vec![false; new.pieces.len()]);
    let keys =
        |sheet: &Sheet| -> Vec<String> { sheet.pieces.iter().map(|piece| piece.key.clone()).collect() };
    for op in capture_diff_slices(Algorithm::Myers, &keys(&old), &keys(&new)) {
        if op.tag() != DiffTag::Equal {
            gone[op.old_range()].fill(true);
            added[op.new_range()].fill(true);
        }
    }
    (old.drawn(&gone), new.drawn(&added))
}

/// Parts of the two forms of a network: the rung, and which part of it.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct ChangedParts {
    /// What only the old one has.
    pub gone: Vec<(usize, usize)>,
    /// What only the new one has.
    pub added: Vec<(usize, usize)>,
}

/// The parts of two networks that the other has not.
pub fn changed_parts(old: (&Outline, &Entry), new: (&Outline, &Entry)) -> ChangedParts {
    let (old, new) = (parts(old.0, old.1), parts(new.0, new.1));
    let keys = |parts: &[Part]| -> Vec<String> { parts.iter().map(|(key, _)| key.clone()).collect() };
    let mut changed = ChangedParts::default();
    for op in capture_diff_slices(Algorithm::Myers, &keys(&old), &keys(&new)) {
        if op.tag() != DiffTag::Equal {
            let parts = |parts: &[Part]| -> Vec<_> { parts.iter().filter_map(|(_, part)| *part).collect() };
            changed.gone.extend(parts(&old[op.old_range()]));
            changed.added.extend(parts(&new[op.new_range()]));
        }
    }
    changed
}

/// What a part of a network says, and which it is; between rungs one that is none.
type Part = (String, Option<(usize, usize)>);

fn parts(outline: &Outline, entry: &Entry) -> Vec<Part> {
    let mut parts = Vec::new();
    let Some(network) = entry.network.map(|index| outline.context.networks.at(index)) else {
        return parts;
    };
    let mut blocks = network.blocks().peekable();
    for (rung, drawn) in network.wiring.rungs.iter().enumerate() {
        parts.push(("\n".to_owned(), None));
        for (number, part) in drawn.parts.iter().enumerate() {
            let is_here = |block: &BlockAt<'_>| (block.facts.rung, block.facts.part) == (rung, number);
            let key = match part.kind {
                PartKind::Wire | PartKind::Bar => continue,
                PartKind::Block => blocks.next_if(is_here).map(canonical::block).unwrap_or_default(),
                kind => format!("{kind:?}"),
            };
            parts.push((key, Some((rung, number))));
        }
    }
    parts
}

/// The text of an entry, and the pieces that can differ.
struct Sheet {
    text: String,
    pieces: Vec<Piece>,
}

/// Something on a line.
struct Piece {
    /// What it says.
    key: String,
    /// Where it is. Empty: nothing that can be marked.
    range: TextRange,
}

impl Sheet {
    fn new(outline: &Outline, entry: &Entry, width: u32) -> Sheet {
        let text = outline.text(entry.shown);
        let text = text.trim_start_matches('\u{feff}').trim_end();
        if entry.kind != Kind::Network {
            let text = dedented(text);
            let pieces = words(&text);
            return Sheet { text, pieces };
        }
        let options = Options {
            width,
            ..Options::default()
        };
        let text = format_text(text, &options);
        let context = context(&Arc::new(parse(&text)), "");
        let pieces = elements(&context);
        Sheet { text, pieces }
    }

    fn drawn(&self, marked: &[bool]) -> Drawn {
        let mut marks = self.pieces.iter().zip(marked).filter(|(_, marked)| **marked);
        let mut next = marks.next();
        let mut at = 0;
        let mut lines = Vec::new();
        for line in self.text.split_inclusive(['\n', '\r']) {
            let end = at + line.len();
            let shown = line.trim_end();
            let mut on_line = Vec::new();
            while let Some((piece, _)) = next {
                let range = Range::<usize>::from(piece.range);
                if range.start >= end {
                    break;
                }
                let cut = range.start.max(at) - at..range.end.min(at + shown.len()).max(at) - at;
                if cut.start < cut.end {
                    on_line.push(cut);
                }
                if range.end > end {
                    break;
                }
                next = marks.next();
            }
            at = end;
            // CR LF is one line end.
            if line != "\n" || !self.text[..end].ends_with("\r\n") {
                lines.push(DrawnLine {
                    text: shown.to_owned(),
                    marks: on_line,
                });
            }
        }
        Drawn { lines }
    }
}

impl DrawnLine {
    /// A line of `sign` below what is marked, if anything is.
    pub fn underline(&self, sign: char) -> Option<String> {
        let mut line = String::new();
        let mut columns = 0;
        for mark in &self.marks {
            let start = display_width(&self.text[..mark.start]);
            let end = display_width(&self.text[..mark.end]);
            line.extend(std::iter::repeat_n(' ', start.saturating_sub(columns) as usize));
            line.extend(std::iter::repeat_n(sign, end.saturating_sub(start) as usize));
            columns = end.max(columns);
        }
        (!line.is_empty()).then_some(line)
    }
}

/// A text whose lines begin as far left as they can.
fn dedented(text: &str) -> String {
    let blanks = |line: &str| line.len() - line.trim_start_matches([' ', '\t']).len();
    let lines = text.lines().filter(|line| !line.trim().is_empty());
    let least = lines.map(blanks).min().unwrap_or(0);
    let lines = text.lines().map(|line| line.get(least..).unwrap_or_default());
    lines.collect::<Vec<_>>().join("\n")
}

/// The words of a declaration or comment.
fn words(text: &str) -> Vec<Piece> {
    // In a section they are read as what they are there.
    const BEFORE: &str = "VAR\n";
    let read = parse(&format!("{BEFORE}{text}\n"));
    let tokens = read.syntax().descendants_with_tokens();
    let tokens = tokens.filter_map(NodeOrToken::into_token);
    let before = TextSize::of(BEFORE);
    let mut words = Vec::new();
    for token in tokens {
        let range = token.text_range();
        if range.start() < before || range.end() > before + TextSize::of(text) {
            continue;
        }
        let range = range - before;
        let key = match token.kind() {
            WHITESPACE | NEWLINE | BOM => continue,
            COMMENT => {
                words.extend(words_of_comment(token.text(), range.start()));
                continue;
            }
            STRING => token.text().to_owned(),
            _ => Name::new(token.text()).as_str().to_owned(),
        };
        words.push(Piece { key, range });
    }
    words
}

/// The words of a comment that begins here.
fn words_of_comment(text: &str, start: TextSize) -> impl Iterator<Item = Piece> {
    text.split_whitespace().map(move |word| {
        let at = word.as_ptr() as usize - text.as_ptr() as usize;
        Piece {
            key: word.to_owned(),
            range: TextRange::at(start + TextSize::of(&text[..at]), TextSize::of(word)),
        }
    })
}

/// What is on the rungs of a text, and the comments in it.
fn elements(context: &Context) -> Vec<Piece> {
    let parse = &context.parse;
    let mut pieces = Vec::new();
    for (number, line) in parse.lines().iter().enumerate() {
        let start = parse.line_start(number);
        if line.kind != LineKind::Rung {
            let tokens = line.syntax().descendants_with_tokens();
            let tokens = tokens.filter_map(NodeOrToken::into_token);
            for comment in tokens.filter(|token| token.kind() == COMMENT) {
                let at = comment.text_range().start() + start;
                pieces.extend(words_of_comment(comment.text(), at));
            }
            continue;
        }
        // A rung that begins is a difference that has no place of its own.
        pieces.push(Piece {
            key: "\n".to_owned(),
            range: TextRange::empty(start),
        });
        let mut blocks = context
            .networks
            .on_line(number)
            .into_iter()
            .flat_map(NetworkAt::blocks)
            .filter(|block| block.base == start);
        for part in wiring::rung(&line.tree()).parts {
            let text = line
                .text()
                .get(Range::<usize>::from(part.range))
                .unwrap_or_default();
            let key = match part.kind {
                PartKind::Wire | PartKind::Bar => continue,
                PartKind::Block => blocks.next().map_or_else(|| text.to_owned(), canonical::block),
                _ => text.to_owned(),
            };
            pieces.push(Piece {
                key,
                range: part.range + start,
            });
        }
    }
    pieces
}
