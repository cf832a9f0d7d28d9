//! From a text to its lines, its tree and its structure.

use crate::chunks;
use crate::line::Line;
use crate::lines::{Lines, read_lines};
use crate::structure::Structure;
use crate::tree_builder::TreeBuilder;
use crate::{SyntaxError, SyntaxErrorKind, SyntaxNode};
use rowan::{GreenNode, TextRange, TextSize};

/// The largest file that the tools read: 64 MiB. Offsets are 32 bit; larger texts are refused where they enter.
pub const MAX_FILE_BYTES: usize = 64 << 20;

/// The largest text that an editor's server reads: 24 MiB. What it knows of a text takes a hundred times as much memory;
/// larger texts are kept, so that the editor can go on, and nothing is said about them.
pub const MAX_OPEN_BYTES: usize = 24 << 20;

/// A text that an editor's server reads has at most so many lines. Each takes a kilobyte of memory, however short it is.
pub const MAX_OPEN_LINES: usize = 400_000;

/// A parsed text.
#[derive(Debug, Clone)]
pub struct Parse {
    root: GreenNode,
    pub(crate) lines: Lines,
}

/// Parses a text. Every text has a tree that gives it back; mistakes are in [`Parse::errors`].
pub fn parse(text: &str) -> Parse {
    let lines = read_lines(text, &mut TreeBuilder::new(text.len()));
    Parse::new(chunks::root(lines.lines()), lines)
}

impl Parse {
    pub(crate) fn new(root: GreenNode, lines: Lines) -> Parse {
        Parse { root, lines }
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
        self.lines.lines()
    }

    /// Where a line starts, in bytes.
    pub fn line_start(&self, line: usize) -> TextSize {
        self.lines.line_start(line)
    }

    /// The range of a line in the text, its line end included.
    pub fn line_range(&self, line: usize) -> TextRange {
        self.lines.line_range(line)
    }

    /// The line that holds an offset; the last one for the end of the text. None for an empty text.
    pub fn line_at(&self, offset: TextSize) -> Option<usize> {
        self.lines.line_at(offset)
    }

    /// Networks, sections and block definitions.
    pub fn structure(&self) -> &Structure {
        self.lines.structure()
    }

    /// The length of the text in bytes.
    pub fn text_len(&self) -> TextSize {
        self.lines.text_len()
    }

    /// Where a comment that is never closed is reported: the `#` of the first comment that holds a line of a
    /// drawing, else the last `#`. What stands behind it is not to be relied on.
    pub fn unclosed_comment(&self) -> Option<TextRange> {
        self.lines.unclosed_comment()
    }

    /// All mistakes that the parser found, in the order of their places, counted from the start of the text.
    /// Behind [`Parse::unclosed_comment`] there are none.
    pub fn errors(&self) -> Vec<SyntaxError> {
        let mut errors: Vec<SyntaxError> = self
            .lines()
            .iter()
            .enumerate()
            .filter(|(_, line)| !line.errors.is_empty())
            .flat_map(|(index, line)| {
                let start = self.line_start(index);
                line.errors.iter().map(move |e| e.shifted(start))
            })
            .collect();
        // An end that was not found may stand in a comment that is never closed.
        let told = |kind: SyntaxErrorKind| self.unclosed_comment().is_none() || !kind.lacks_end();
        let problems = self.structure().problems.iter().filter(|(_, kind)| told(*kind));
        errors.extend(problems.map(|&(line, kind)| {
            // The line without its white space and line end.
            let text = self.lines()[line].node.to_string();
            let before = text.len() - text.trim_start().len();
            let start = self.line_start(line) + TextSize::new(before as u32);
            SyntaxError::new(kind, TextRange::at(start, TextSize::of(text.trim())))
        }));
        if let Some(place) = self.unclosed_comment() {
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
