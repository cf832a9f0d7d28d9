//! What the columns of a sheet were found to be.

use std::ops::Range;

/// What a column of a line is part of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum Mark {
    /// What its character says.
    #[default]
    None,
    /// A contact, coil or other element on a rung.
    Symbol(usize),
    /// A box.
    Frame(usize),
    /// Wire, whatever is written there.
    Wire,
    /// Something that was read already and leads to nothing.
    Read,
}

/// The marks of a sheet.
#[derive(Debug)]
pub(crate) struct Marks(Vec<Vec<Mark>>);

impl Marks {
    pub(crate) fn new(lines: usize) -> Marks {
        Marks(vec![Vec::new(); lines])
    }

    pub(crate) fn at(&self, line: usize, column: usize) -> Mark {
        let line = self.0.get(line);
        line.and_then(|line| line.get(column))
            .copied()
            .unwrap_or_default()
    }

    pub(crate) fn set(&mut self, line: usize, columns: Range<usize>, mark: Mark) {
        let line = &mut self.0[line];
        if line.len() < columns.end {
            line.resize(columns.end, Mark::None);
        }
        line[columns].fill(mark);
    }

    /// Whether a box reaches over a line, and whether something is on a rung there.
    pub(crate) fn has_frame(&self, line: usize) -> bool {
        self.0[line].iter().any(|mark| matches!(mark, Mark::Frame(_)))
    }

    pub(crate) fn has_symbol(&self, line: usize) -> bool {
        self.0[line].iter().any(|mark| matches!(mark, Mark::Symbol(_)))
    }
}
