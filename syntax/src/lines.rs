//! The logical lines of a text, and what is read off them.

use crate::builder::Builder;
use crate::grammar::{self, Entry};
use crate::line::Line;
use crate::structure::{self, Structure};
use crate::unclosed_comment::unclosed_comment;
use rowan::{GreenNode, TextRange, TextSize};

/// The lines of a text with what a [`Builder`] made of them, and the networks, sections and block definitions that
/// they form.
#[derive(Debug, Clone)]
pub struct Lines<N = GreenNode> {
    pub(crate) lines: Vec<Line<N>>,
    /// Where each line starts, and at the end the length of the text.
    pub(crate) starts: Vec<u32>,
    structure: Structure,
    unclosed_comment: Option<TextRange>,
}

/// Reads all lines of a text, and tells the builder what stands on them. [`parse`](crate::parse()) does this with the
/// builder of the tree.
pub fn read_lines<B: Builder>(text: &str, builder: &mut B) -> Lines<B::Line> {
    let mut lines = Vec::with_capacity(text.len() / 48 + 1);
    let mut starts = Vec::with_capacity(text.len() / 48 + 2);
    let mut entry = Entry::START;
    let mut at = 0;
    while at < text.len() {
        let line = line_at(text, at, entry, builder);
        starts.push(at as u32);
        at += line.len as usize;
        entry = entry_behind(&line);
        lines.push(line);
    }
    starts.push(text.len() as u32);
    Lines::new(text, lines, starts)
}

/// Reads the line that begins at `at`.
pub(crate) fn line_at<B: Builder>(text: &str, at: usize, entry: Entry, builder: &mut B) -> Line<B::Line> {
    let line = grammar::line(text, at, entry, builder);
    debug_assert!(line.len > 0, "a line takes at least one character");
    line
}

/// The state behind a line.
pub(crate) fn entry_behind<N>(line: &Line<N>) -> Entry {
    Entry {
        mode: line.mode_after,
        mid_line: !line.has_line_end,
    }
}

impl<N> Lines<N> {
    /// Puts together what is read off the lines.
    pub(crate) fn new(text: &str, lines: Vec<Line<N>>, starts: Vec<u32>) -> Lines<N> {
        let structure = structure::structure(&lines);
        let unclosed_comment = unclosed_comment(text, &lines, &starts);
        Lines {
            lines,
            starts,
            structure,
            unclosed_comment,
        }
    }

    /// The logical lines.
    pub fn lines(&self) -> &[Line<N>] {
        &self.lines
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
        let behind = self.starts[..self.lines.len()].partition_point(|&start| start <= u32::from(offset));
        behind.checked_sub(1)
    }

    /// Networks, sections and block definitions.
    pub fn structure(&self) -> &Structure {
        &self.structure
    }

    /// The length of the text in bytes.
    pub fn text_len(&self) -> TextSize {
        TextSize::new(self.starts[self.lines.len()])
    }

    /// Where a comment that is never closed is reported; see [`Parse`](crate::Parse::unclosed_comment).
    pub fn unclosed_comment(&self) -> Option<TextRange> {
        self.unclosed_comment
    }
}
