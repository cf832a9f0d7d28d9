//! Where the lines of declarations are.
//!
//! Places in a declaration count from the start of its line, so that an edit of another line moves a plain number. A line
//! keeps its number while others come and go.

use crate::numbering::Numbering;
use ladder_syntax::{TextRange, TextSize};
use std::ops::Range;

/// The lines of a file that declare tags, from top to bottom.
#[derive(Debug, Clone, Default)]
pub(crate) struct Declarations {
    /// Where each of them starts, in bytes.
    starts: Vec<u32>,
    numbering: Numbering,
}

/// A place on a line of declarations, or anywhere.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct DeclaredAt {
    /// The number of the line, if it is one of declarations.
    pub(crate) line: Option<u32>,
    /// From the start of the line, or of the file.
    pub(crate) range: TextRange,
}

impl DeclaredAt {
    /// A place that is not on a line of declarations.
    pub(crate) const fn in_file(range: TextRange) -> DeclaredAt {
        DeclaredAt { line: None, range }
    }
}

impl Declarations {
    /// Adds a line below the others. Gives its number.
    pub(crate) fn push(&mut self, start: TextSize) -> u32 {
        self.starts.push(start.into());
        self.numbering.push()
    }

    /// How many lines there are.
    pub(crate) fn len(&self) -> usize {
        self.starts.len()
    }

    /// How many numbers there are, with those that no line has.
    pub(crate) fn numbers(&self) -> usize {
        self.numbering.count()
    }

    /// The number of a line.
    pub(crate) fn number(&self, index: usize) -> u32 {
        self.numbering.number(index)
    }

    /// Which line has a number; none if it is gone.
    pub(crate) fn index(&self, number: u32) -> Option<usize> {
        self.numbering.index(number)
    }

    /// Where a line starts.
    pub(crate) fn start(&self, index: usize) -> TextSize {
        TextSize::new(self.starts[index])
    }

    /// Where the line of a number starts; the start of the file for one that is gone.
    pub(crate) fn start_of(&self, number: u32) -> TextSize {
        let start = self.index(number).map(|index| self.starts[index]);
        TextSize::new(start.unwrap_or_default())
    }

    /// A place as it counts in the file.
    pub(crate) fn range(&self, at: DeclaredAt) -> TextRange {
        at.range + at.line.map_or(TextSize::default(), |line| self.start_of(line))
    }

    /// How many lines start before a place.
    pub(crate) fn count_before(&self, place: TextSize) -> usize {
        self.starts.partition_point(|start| *start < place.into())
    }

    /// The last line that starts at a place or before it.
    pub(crate) fn last_before(&self, place: TextSize) -> Option<usize> {
        let behind = self.starts.partition_point(|start| *start <= place.into());
        behind.checked_sub(1)
    }

    /// Puts lines that start here in the place of some; what is below is this many bytes further down.
    pub(crate) fn exchange(&mut self, old: Range<usize>, starts: Vec<u32>, bytes: i64) {
        for start in &mut self.starts[old.end..] {
            *start = start.wrapping_add_signed(bytes as i32);
        }
        self.numbering.exchange(old.clone(), starts.len());
        self.starts.splice(old, starts);
    }
}
