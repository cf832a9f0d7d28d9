//! From a text to its lines, its tree and its structure.

use crate::conflict::{Conflict, Conflicts, OpenConflicts};
use crate::error::{SyntaxError, SyntaxErrorKind};
use crate::file_lines::FileLines;
use crate::grammar::Entry;
use crate::kind::{SyntaxKind, SyntaxNode};
use crate::line_tree::with_text;
use crate::lines::read_each;
use crate::part::Part;
use crate::structure::{Frame, Structure, frame_of_parts, structure_of_parts};
use crate::summary::Summary;
use crate::tree_builder::{Names, TreeBuilder};
use crate::unclosed_comment::unclosed_comment;
use rowan::{GreenNode, NodeOrToken, TextRange, TextSize};
use std::borrow::Cow;
use std::sync::OnceLock;

/// The largest file that the tools read: 64 MiB. Offsets are 32 bit; larger texts are refused where they enter.
pub const MAX_FILE_BYTES: usize = 64 << 20;

/// The largest text that an editor's server reads: 24 MiB. What it knows of a text takes some thirty times as much memory;
/// larger texts are kept, so that the editor can go on, and nothing is reported about them.
pub const MAX_OPEN_BYTES: usize = 24 << 20;

/// A text that an editor's server reads has at most this many lines: a program of 100,000 rungs has up to 500,000. However short
/// a line is, it takes a kilobyte of memory, two where something is wrong with each.
pub const MAX_OPEN_LINES: usize = 600_000;

/// A parsed text.
#[derive(Debug, Clone)]
pub struct Parse {
    pub(crate) lines: FileLines,
    unclosed_comment: Option<TextRange>,
    /// How many bytes of the text were read for it.
    bytes_read: usize,
    /// Made when it is asked for.
    root: OnceLock<GreenNode>,
    structure: OnceLock<Structure>,
    frame: OnceLock<Frame>,
}

/// Parses a text. Every text has a tree that gives it back; errors are in [`Parse::errors`].
pub fn parse(text: &str) -> Parse {
    let mut builder = Summary;
    let lines = read_each(text, &mut builder);
    let lines = FileLines::new(with_text(text, 0, Entry::START, lines));
    let unclosed_comment = unclosed_comment(|| text, &lines);
    Parse::new(lines, unclosed_comment, text.len())
}

/// The tree of a text, by itself: `SOURCE_FILE`, in it the logical lines.
pub fn tree(text: &str) -> GreenNode {
    let mut builder = TreeBuilder::new(text.len(), Names::Shared);
    let lines = read_each(text, &mut builder);
    let nodes: Vec<_> = lines.map(|line| NodeOrToken::Node(line.node)).collect();
    GreenNode::new(SyntaxKind::SOURCE_FILE.into(), nodes)
}

impl Parse {
    pub(crate) fn new(lines: FileLines, unclosed_comment: Option<TextRange>, bytes_read: usize) -> Parse {
        Parse {
            unclosed_comment,
            lines,
            bytes_read,
            root: OnceLock::new(),
            structure: OnceLock::new(),
            frame: OnceLock::new(),
        }
    }

    /// The tree: `SOURCE_FILE`, in it the logical lines. It is made when it is first asked for.
    pub fn syntax(&self) -> SyntaxNode {
        SyntaxNode::new_root(self.green().clone())
    }

    /// The root's green node.
    pub fn green(&self) -> &GreenNode {
        self.root.get_or_init(|| tree(&self.to_string()))
    }

    /// The logical lines.
    pub fn lines(&self) -> &FileLines {
        &self.lines
    }

    /// Where a line starts, in bytes.
    pub fn line_start(&self, line: usize) -> TextSize {
        TextSize::new(self.lines.line_start(line))
    }

    /// The range of a line in the text, its line end included.
    pub fn line_range(&self, line: usize) -> TextRange {
        let start = self.line_start(line);
        TextRange::at(start, TextSize::new(self.lines[line].len))
    }

    /// What is written in a range. It is copied only where the range reaches over several logical lines. Empty for a range
    /// that is not in the text.
    pub fn text_in(&self, range: TextRange) -> Cow<'_, str> {
        if range.end() > self.text_len() || range.is_empty() {
            return Cow::Borrowed("");
        }
        let first = self.line_at(range.start()).unwrap_or_default();
        let start = self.line_start(first);
        let within = std::ops::Range::<usize>::from(range - start);
        if let Some(text) = self.lines[first].text().get(within.clone()) {
            return Cow::Borrowed(text);
        }
        let mut text = String::new();
        for line in self.lines.from(first) {
            if text.len() >= within.end {
                break;
            }
            text.push_str(line.text());
        }
        Cow::Owned(text.get(within).unwrap_or_default().to_owned())
    }

    /// The line that holds an offset; the last one for the end of the text. None for an empty text.
    pub fn line_at(&self, offset: TextSize) -> Option<usize> {
        let after = u32::from(offset).saturating_add(1);
        self.lines.count_before(after).checked_sub(1)
    }

    /// Networks, sections and block definitions.
    pub fn structure(&self) -> &Structure {
        self.structure.get_or_init(|| structure_of_parts(&self.lines))
    }

    /// The same for those who need it once: it is not kept. Of a large text it is as long as the text, while most questions
    /// do without it.
    pub fn structure_once(&self) -> Cow<'_, Structure> {
        match self.structure.get() {
            Some(known) => Cow::Borrowed(known),
            None => Cow::Owned(structure_of_parts(&self.lines)),
        }
    }

    /// Sections and block definitions. Who needs no more than these asks here: it takes no look at the networks.
    pub fn frame(&self) -> &Frame {
        self.frame.get_or_init(|| frame_of_parts(&self.lines))
    }

    /// The length of the text in bytes.
    pub fn text_len(&self) -> TextSize {
        TextSize::new(self.lines.text_len())
    }

    /// How many bytes of the text were read for it: of one that came from another by an edit, those around the edit.
    pub fn bytes_read(&self) -> usize {
        self.bytes_read
    }

    /// Where a comment that is never closed is reported: the `#` of the first comment that holds a line of a
    /// drawing, else the last `#`. What is after it is not to be relied on.
    pub fn unclosed_comment(&self) -> Option<TextRange> {
        self.unclosed_comment
    }

    /// The conflicts that merges left, from top to bottom; those inside of others are not asked about.
    pub fn conflicts(&self) -> Vec<Conflict> {
        let mut conflicts = Conflicts::default();
        let lines = self.lines.of_parts_that(Part::is_in_conflict);
        for (number, line) in lines.filter(|(_, line)| line.in_conflict) {
            let before = number.checked_sub(1);
            let open = before.map_or(OpenConflicts::default(), |before| self.lines[before].open_after);
            conflicts.line(line.text(), line.kind, self.line_start(number), open);
        }
        conflicts.finish()
    }

    /// All errors that the parser found, in the order of their places, counted from the start of the text.
    /// After [`Parse::unclosed_comment`] there are none.
    pub fn errors(&self) -> Vec<SyntaxError> {
        let mut errors: Vec<SyntaxError> = self
            .lines()
            .of_parts_that(Part::is_faulty)
            .filter(|(_, line)| !line.errors.is_empty())
            .flat_map(|(index, line)| {
                let start = self.line_start(index);
                line.errors.iter().map(move |e| e.shifted(start))
            })
            .collect();
        // An end that was not found may be in a comment that is never closed.
        let reported = |kind: SyntaxErrorKind| self.unclosed_comment().is_none() || !kind.lacks_end();
        let problems = self.frame().problems.iter();
        let problems = problems.filter(|(_, kind)| reported(*kind));
        errors.extend(problems.map(|&(line, kind)| {
            // The line without its white space and line end.
            let text = self.lines()[line].text();
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
        self.lines.iter().try_for_each(|line| f.write_str(line.text()))
    }
}

#[cfg(test)]
mod tests {
    use super::parse;
    use rowan::TextRange;

    #[test]
    fn any_range_has_its_text() {
        let text = "VAR a : BOOL; b : BOOL; END_VAR\r\n# é\nü #\n\n+--[ ]( a )--( )( b )--+\n";
        let parsed = parse(text);
        for start in 0..text.len() {
            for end in start..text.len() + 2 {
                let range = TextRange::new((start as u32).into(), (end as u32).into());
                assert_eq!(
                    parsed.text_in(range),
                    text.get(start..end).unwrap_or_default(),
                    "{range:?}"
                );
            }
        }
    }
}
