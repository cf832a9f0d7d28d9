//! The logical lines of a text, and what is read off them.

use crate::builder::Builder;
use crate::grammar::{self, Entry};
use crate::line::{LineKind, ReadLine};
use crate::structure::{self, Structure};
use crate::unclosed_comment::unclosed_comment;
use rowan::{TextRange, TextSize};

/// Logical lines that can be asked for by their numbers.
pub trait LineList {
    /// What a [`Builder`] made of a line.
    type Node;

    /// How many there are.
    fn count(&self) -> usize;

    /// A line. Panics if there is none of this number.
    fn line(&self, line: usize) -> &ReadLine<Self::Node>;

    /// Where it starts, in bytes from the start of the text.
    fn start(&self, line: usize) -> u32;

    /// If it is known without a look at each line that nothing but declarations, comments and blank lines is from a line on
    /// to another: that other one, and the one after the last declaration.
    fn declarations_from(&self, line: usize) -> Option<(usize, Option<usize>)> {
        let _ = line;
        None
    }
}

impl<N> LineList for Lines<N> {
    type Node = N;

    fn count(&self) -> usize {
        self.all.len()
    }

    fn line(&self, line: usize) -> &ReadLine<N> {
        &self.all[line]
    }

    fn start(&self, line: usize) -> u32 {
        self.starts[line]
    }
}

/// The lines of a text with what a [`Builder`] made of them, and the networks, sections and block definitions that
/// they form.
#[derive(Debug, Clone)]
pub struct Lines<N> {
    pub(crate) all: Vec<ReadLine<N>>,
    /// Where each line starts, and at the end the length of the text.
    pub(crate) starts: Vec<u32>,
    structure: Structure,
    unclosed_comment: Option<TextRange>,
}

/// Reads all lines of a text, and reports to the builder what is on them. [`parse`](crate::parse()) does this with the
/// builder of the tree.
pub fn read_lines<B: Builder>(text: &str, builder: &mut B) -> Lines<B::Line> {
    let mut lines = Lines::with_capacity(text.len());
    LineReader::new(text).read(usize::MAX, builder, &mut lines);
    lines
}

/// The lines alone, each read when it is asked for: those of a large text need not be in memory twice.
pub(crate) fn read_each<'t, B: Builder>(
    text: &'t str,
    builder: &'t mut B,
) -> impl Iterator<Item = ReadLine<B::Line>> + use<'t, B> {
    let (mut at, mut entry) = (0, Entry::START);
    std::iter::from_fn(move || {
        if at == text.len() {
            return None;
        }
        let line = line_at(text, at, entry, builder);
        at += line.len as usize;
        entry = entry_after(&line);
        Some(line)
    })
}

/// Reads a text part by part, so that a large one need not be in memory line by line.
#[derive(Debug)]
pub struct LineReader<'t> {
    text: &'t str,
    at: usize,
    entry: Entry,
    /// Whether a block definition is open.
    in_block: bool,
}

impl<'t> LineReader<'t> {
    /// A reader that is at the start of a text.
    pub fn new(text: &'t str) -> LineReader<'t> {
        LineReader {
            text,
            at: 0,
            entry: Entry::START,
            in_block: false,
        }
    }

    /// Where the next part begins, in bytes.
    pub fn at(&self) -> usize {
        self.at
    }

    /// Reads the next part: at least this many bytes, then to a place where no network, section or block definition
    /// is open, or to the end of the text. The part's lines take the place of those in `lines`; offsets count from
    /// the start of the text. What they form is what they form in the whole text; only
    /// [`Lines::unclosed_comment`], which shows in the last part, may belong into an earlier one.
    pub fn read<B: Builder>(&mut self, least: usize, builder: &mut B, lines: &mut Lines<B::Line>) {
        lines.all.clear();
        lines.starts.clear();
        let enough = self.at.saturating_add(least);
        while self.at < self.text.len() {
            let line = line_at(self.text, self.at, self.entry, builder);
            lines.starts.push(self.at as u32);
            self.at += line.len as usize;
            self.entry = entry_after(&line);
            match line.kind {
                LineKind::BlockHeader => self.in_block = true,
                LineKind::BlockEnd => self.in_block = false,
                _ => {}
            }
            let ends_item = match line.kind {
                LineKind::Rung => line.downs == 0,
                LineKind::SectionEnd | LineKind::BlockEnd => true,
                _ => false,
            };
            lines.all.push(line);
            if ends_item && self.at >= enough && self.entry == Entry::START && !self.in_block {
                break;
            }
        }
        lines.starts.push(self.at as u32);
        lines.regroup(self.text);
    }
}

/// Reads the line that begins at `at`.
pub(crate) fn line_at<B: Builder>(text: &str, at: usize, entry: Entry, builder: &mut B) -> ReadLine<B::Line> {
    let line = grammar::line(text, at, entry, builder);
    debug_assert!(line.len > 0, "a line takes at least one character");
    line
}

/// The state after a line.
pub(crate) fn entry_after<N>(line: &ReadLine<N>) -> Entry {
    Entry {
        mode: line.mode_after,
        mid_line: !line.has_line_end,
        open: line.open_after,
    }
}

impl<N> Default for Lines<N> {
    fn default() -> Self {
        Lines {
            all: Vec::new(),
            starts: Vec::new(),
            structure: Structure::default(),
            unclosed_comment: None,
        }
    }
}

impl<N> Lines<N> {
    /// No lines yet, with room for those of a text of this many bytes.
    fn with_capacity(bytes: usize) -> Lines<N> {
        Lines {
            all: Vec::with_capacity(bytes / 48 + 1),
            starts: Vec::with_capacity(bytes / 48 + 2),
            ..Lines::default()
        }
    }

    fn regroup(&mut self, text: &str) {
        self.structure = structure::structure(self);
        self.unclosed_comment = unclosed_comment(|| text, self);
    }

    /// The logical lines.
    pub fn lines(&self) -> &[ReadLine<N>] {
        &self.all
    }

    /// Where a line starts, in bytes.
    pub fn line_start(&self, line: usize) -> TextSize {
        TextSize::new(self.starts[line])
    }

    /// The range of a line in the text, its line end included.
    pub fn line_range(&self, line: usize) -> TextRange {
        TextRange::new(
            TextSize::new(self.starts[line]),
            TextSize::new(self.starts[line + 1]),
        )
    }

    /// The line that holds an offset; the last one for the end of the text. None for an empty text.
    pub fn line_at(&self, offset: TextSize) -> Option<usize> {
        let after = self.starts[..self.all.len()].partition_point(|&start| start <= u32::from(offset));
        after.checked_sub(1)
    }

    /// Networks, sections and block definitions.
    pub fn structure(&self) -> &Structure {
        &self.structure
    }

    /// The length of the text in bytes.
    pub fn text_len(&self) -> TextSize {
        TextSize::new(self.starts[self.all.len()])
    }

    /// Where a comment that is never closed is reported; see [`Parse`](crate::Parse::unclosed_comment).
    pub fn unclosed_comment(&self) -> Option<TextRange> {
        self.unclosed_comment
    }
}
