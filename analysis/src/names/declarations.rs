//! Where the lines of declarations are.
//!
//! Places in a declaration count from the start of its line, so that an edit of another line moves a plain number.

use ladder_syntax::{TextRange, TextSize};

/// The lines of a file that declare tags, from top to bottom.
#[derive(Debug, Clone, Default)]
pub(crate) struct Declarations {
    /// Where each of them starts, in bytes.
    starts: Vec<u32>,
}

/// A place on a line of declarations, or anywhere.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct DeclaredAt {
    /// The line, if it is one of declarations.
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
        self.starts.len() as u32 - 1
    }

    /// Where a line starts.
    pub(crate) fn start_of(&self, line: u32) -> TextSize {
        TextSize::new(self.starts[line as usize])
    }

    /// A place as it counts in the file.
    pub(crate) fn range(&self, at: DeclaredAt) -> TextRange {
        at.range + at.line.map_or(TextSize::default(), |line| self.start_of(line))
    }

    /// The line that starts at a place.
    pub(crate) fn starting_at(&self, start: TextSize) -> Option<u32> {
        let found = self.starts.binary_search(&start.into()).ok()?;
        Some(found as u32)
    }

    /// The last line that starts at a place or before it.
    pub(crate) fn last_before(&self, place: TextSize) -> Option<u32> {
        let behind = self.starts.partition_point(|start| *start <= place.into());
        behind.checked_sub(1).map(|line| line as u32)
    }

    /// A line starts elsewhere.
    pub(crate) fn set(&mut self, line: u32, start: TextSize) {
        self.starts[line as usize] = start.into();
    }

    /// What starts at a place or behind it is so many bytes further down.
    pub(crate) fn shift(&mut self, from: TextSize, bytes: i64) {
        let first = self.starts.partition_point(|start| *start < from.into());
        for start in &mut self.starts[first..] {
            *start = start.wrapping_add_signed(bytes as i32);
        }
    }
}
