//! From a text to its lines, its tree and its structure.

use crate::chunks;
use crate::grammar::{self, Entry};
use crate::line::Line;
use crate::structure::{self, Structure};
use crate::tree_builder::TreeBuilder;
use crate::unclosed_comment::unclosed_comment;
use crate::{SyntaxError, SyntaxErrorKind, SyntaxNode};
use rowan::{GreenNode, TextRange, TextSize};

/// The largest file that the tools read: 64 MiB. Offsets are 32 bit; larger texts are refused where they enter.
pub const MAX_FILE_BYTES: usize = 64 << 20;

/// A parsed text.
#[derive(Debug, Clone)]
pub struct Parse {
    root: GreenNode,
    pub(crate) lines: Vec<Line>,
    /// Where each line starts, and at the end the length of the text.
    pub(crate) starts: Vec<u32>,
    structure: Structure,
    unclosed_comment: Option<TextRange>,
}

/// Parses a text. Every text has a tree that gives it back; mistakes are in [`Parse::errors`].
pub fn parse(text: &str) -> Parse {
    let mut builder = TreeBuilder::new(text.len());
    let mut lines: Vec<Line> = Vec::with_capacity(text.len() / 48 + 1);
    let mut starts = Vec::with_capacity(text.len() / 48 + 2);
    let mut entry = Entry::START;
    let mut at = 0;
    while at < text.len() {
        let line = line_at(text, at, entry, &mut builder);
        starts.push(at as u32);
        at += line.len as usize;
        entry = entry_behind(&line);
        lines.push(line);
    }
    starts.push(text.len() as u32);
    Parse::new(text, chunks::root(&lines), lines, starts)
}

/// Parses the line that begins at `at`.
pub(crate) fn line_at(text: &str, at: usize, entry: Entry, builder: &mut TreeBuilder) -> Line {
    let line = grammar::line(text, at, entry, builder);
    debug_assert!(line.len > 0, "a line takes at least one character");
    line
}

/// The state behind a line.
pub(crate) fn entry_behind(line: &Line) -> Entry {
    Entry {
        mode: line.mode_after,
        mid_line: !line.has_line_end,
    }
}

impl Parse {
    /// Puts together what is read off the lines.
    pub(crate) fn new(text: &str, root: GreenNode, lines: Vec<Line>, starts: Vec<u32>) -> Parse {
        let structure = structure::structure(&lines);
        let unclosed_comment = unclosed_comment(text, &lines, &starts);
        Parse {
            root,
            lines,
            starts,
            structure,
            unclosed_comment,
        }
    }

    /// The tree: `SOURCE_FILE`, in it `CHUNK`s, in them the logical lines.
    pub fn syntax(&self) -> SyntaxNode {
        SyntaxNode::new_root(self.root.clone())
    }

    /// The root's green node.
    pub fn green(&self) -> &GreenNode {
        &self.root
    }

    /// The logical lines.
    pub fn lines(&self) -> &[Line] {
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

    /// Where a comment that is never closed is reported: the `#` of the first comment that holds a line of a
    /// drawing, else the last `#`. What stands behind it is not to be relied on.
    pub fn unclosed_comment(&self) -> Option<TextRange> {
        self.unclosed_comment
    }

    /// All mistakes that the parser found, in the order of their places, counted from the start of the text.
    /// Behind [`Parse::unclosed_comment`] there are none.
    pub fn errors(&self) -> Vec<SyntaxError> {
        let mut errors: Vec<SyntaxError> = self
            .lines
            .iter()
            .enumerate()
            .filter(|(_, line)| !line.errors.is_empty())
            .flat_map(|(index, line)| {
                let start = self.line_start(index);
                line.errors.iter().map(move |e| e.shifted(start))
            })
            .collect();
        // An end that was not found may stand in a comment that is never closed.
        let told = |kind: SyntaxErrorKind| self.unclosed_comment.is_none() || !kind.lacks_end();
        let problems = self.structure.problems.iter().filter(|(_, kind)| told(*kind));
        errors.extend(problems.map(|&(line, kind)| {
            // The line without its white space and line end.
            let text = self.lines[line].green.to_string();
            let before = text.len() - text.trim_start().len();
            let start = self.line_start(line) + TextSize::new(before as u32);
            SyntaxError::new(kind, TextRange::at(start, TextSize::of(text.trim())))
        }));
        if let Some(place) = self.unclosed_comment {
            errors.retain(|e| e.range.start() < place.start());
            errors.push(SyntaxError::new(SyntaxErrorKind::UnclosedComment, place));
        }
        errors.sort_by_key(|e| (e.range.start(), e.range.end()));
        errors
    }
}

impl std::fmt::Display for Parse {
    /// The text, to the letter.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}", self.root)
    }
}
