//! A program of a workspace, as it is read from its file.

use ladder_notations::Foreign;
use ladder_syntax::{LineColumn, LineIndex, TextRange};
use std::sync::Arc;

/// A program of a workspace: one in ladder text, or one that is translated where it is read.
#[derive(Debug, Clone)]
pub enum Member {
    /// The text of the file.
    Ladder(String),
    /// What is in a file of another notation, and what that becomes.
    Foreign(Arc<Foreign>),
}

impl Member {
    /// The text of the file.
    pub fn text(&self) -> &str {
        match self {
            Member::Ladder(text) => text,
            Member::Foreign(foreign) => foreign.text(),
        }
    }

    /// The same in ladder text, which is what is known of it.
    pub fn ladder(&self) -> &str {
        match self {
            Member::Ladder(text) => text,
            Member::Foreign(foreign) => foreign.ladder(),
        }
    }

    /// Where a part of the ladder text is in the file.
    pub fn range(&self, of_ladder: TextRange) -> TextRange {
        match self {
            Member::Ladder(_) => of_ladder,
            Member::Foreign(foreign) => foreign.range(of_ladder),
        }
    }

    /// Where a place of the ladder text is in a file of another notation.
    pub fn translated_place(&self, of_ladder: TextRange) -> Option<LineColumn> {
        let foreign = self.foreign()?;
        let start = foreign.range(of_ladder).start();
        Some(LineIndex::new(foreign.text()).line_column(foreign.text(), start))
    }

    /// The file, if it is of another notation.
    pub fn foreign(&self) -> Option<&Arc<Foreign>> {
        match self {
            Member::Ladder(_) => None,
            Member::Foreign(foreign) => Some(foreign),
        }
    }
}
