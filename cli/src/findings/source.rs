//! A program's text, and the places in it as people count them.

use ladder_analysis::Analysis;
use ladder_syntax::{LineColumn, LineIndex, TextRange, TextSize};
use std::borrow::Cow;
use std::sync::Arc;

/// A text that was checked.
pub(crate) struct Source {
    /// The file as it was named.
    pub(crate) file: String,
    /// The text, byte for byte where the program has its own.
    pub(crate) text: String,
    index: LineIndex,
}

impl Source {
    pub(crate) fn new(file: String, text: String) -> Source {
        let index = LineIndex::new(&text);
        Source { file, text, index }
    }

    pub(crate) fn analyze(&self) -> Analysis {
        ladder_analysis::analyze(&Arc::new(ladder_syntax::parse(&self.text)), &self.file)
    }

    pub(crate) fn place(&self, offset: TextSize) -> LineColumn {
        self.index.line_column(&self.text, offset)
    }

    /// The whole lines that a range touches, and the number of the first, from 1. A range that ends with a line
    /// end does not touch the line behind it.
    pub(crate) fn lines(&self, range: TextRange) -> Lines {
        let first = self.index.line(range.start());
        let last = self.index.line(range.end()).max(first);
        let behind_line_end = last > first && self.index.range(last).start() == range.end();
        Lines {
            first,
            last: if behind_line_end { last - 1 } else { last },
        }
    }

    /// The lines as they are shown, and where they begin in the text.
    pub(crate) fn excerpt(&self, lines: Lines) -> (Cow<'_, str>, TextSize) {
        let mut start = self.index.range(lines.first).start();
        let end = self.index.range(lines.last).end();
        // The byte order mark is no character of the first line.
        if start == TextSize::new(0) && self.text.starts_with('\u{feff}') {
            start = TextSize::of('\u{feff}');
        }
        (
            with_line_feeds(&self.text[TextRange::new(start, end.max(start))]),
            start,
        )
    }
}

/// Some lines of a text, counted from 0, both included.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Lines {
    pub(crate) first: usize,
    pub(crate) last: usize,
}

impl Lines {
    /// The lines of both, and those between.
    pub(crate) fn join(self, other: Lines) -> Lines {
        Lines {
            first: self.first.min(other.first),
            last: self.last.max(other.last),
        }
    }

    /// How many lines stand between the two; 0 if they touch or overlap.
    pub(crate) fn distance(self, other: Lines) -> usize {
        let between = |upper: usize, lower: usize| lower.saturating_sub(upper).saturating_sub(1);
        between(self.last, other.first).max(between(other.last, self.first))
    }
}

/// Terminals, and the drawing of excerpts, do not know a lone CR as a line end. One byte stands for one byte, so
/// that ranges stay true.
fn with_line_feeds(text: &str) -> Cow<'_, str> {
    let bytes = text.as_bytes();
    let lone = |at: usize| bytes[at] == b'\r' && bytes.get(at + 1) != Some(&b'\n');
    if !(0..bytes.len()).any(lone) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len());
    for (at, letter) in text.char_indices() {
        shown.push(if lone(at) { '\n' } else { letter });
    }
    Cow::Owned(shown)
}
