//! The text of a revision: its lines, words and positions.

use super::Revision;
use crate::position::{self, Position, Range};
use crate::positions::Positions;
use ladder_format::Edit;
use ladder_syntax::{TextRange, TextSize};
use ropey::Rope;

impl Revision {
    /// The text.
    pub fn text(&self) -> String {
        self.rope.to_string()
    }

    /// The length of the text in bytes.
    #[allow(clippy::len_without_is_empty)]
    pub fn len(&self) -> usize {
        self.rope.len_bytes()
    }

    /// The offset of a position, clamped into the text. For a text that has an analysis.
    pub fn offset(&self, position: Position) -> TextSize {
        TextSize::new(position::offset(&self.rope, self.encoding, position) as u32)
    }

    /// The text after some edits of it, sorted and disjoint.
    pub fn after(&self, edits: &[Edit]) -> Rope {
        let mut new = self.rope.clone();
        for edit in edits.iter().rev() {
            let [start, end] =
                [edit.range.start(), edit.range.end()].map(|at| new.byte_to_char(usize::from(at)));
            new.remove(start..end);
            new.insert(start, &edit.text);
        }
        new
    }

    /// For many ranges of the text.
    pub fn positions(&self) -> Positions {
        Positions::new(self.text(), self.encoding)
    }

    /// The range of a stretch of the text.
    pub fn range(&self, range: TextRange) -> Range {
        position::range(&self.rope, self.encoding, range.into())
    }

    /// Where a line begins, counted from 0; past the last one the end of the text.
    pub fn line_start(&self, line: u32) -> TextSize {
        let line = (line as usize).min(self.rope.len_lines());
        TextSize::try_from(self.rope.line_to_byte(line)).unwrap_or(TextSize::from(u32::MAX))
    }

    /// The line of an offset, counted from 0.
    pub fn line_of(&self, offset: TextSize) -> u32 {
        self.rope
            .byte_to_line(usize::from(offset).min(self.rope.len_bytes())) as u32
    }

    /// The word at an offset: letters, digits and `_`.
    pub fn word_at(&self, offset: TextSize) -> String {
        let is_part = |it: &char| it.is_alphanumeric() || *it == '_';
        let at = self
            .rope
            .byte_to_char(usize::from(offset).min(self.rope.len_bytes()));
        let mut before = self.rope.chars_at(at);
        before.reverse();
        let before: Vec<char> = before.take_while(is_part).collect();
        let after = self.rope.chars_at(at).take_while(is_part);
        before.iter().rev().copied().chain(after).collect()
    }

    /// Whether nothing is in it but white space.
    pub fn is_blank(&self) -> bool {
        self.rope.chars().all(char::is_whitespace)
    }

    /// The number of the last line, counted from 0.
    pub fn last_line(&self) -> u32 {
        self.rope.len_lines().saturating_sub(1) as u32
    }

    /// What is after an offset on its line.
    pub fn rest_of_line(&self, offset: TextSize) -> String {
        let rest = self.rope.byte_slice(usize::from(offset).min(self.len())..);
        rest.chars().take_while(|it| !matches!(it, '\n' | '\r')).collect()
    }

    /// A stretch of the text.
    pub fn stretch(&self, bytes: std::ops::Range<usize>) -> String {
        self.rope.byte_slice(bytes).to_string()
    }
}
