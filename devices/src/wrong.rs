//! What settings ask for and a program has not.

use ladder_workspace::Misfit;
use std::ops::Range;

/// Something that was written and cannot be.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Wrong {
    /// Where it is written; nowhere if it was not in a file.
    pub at: Range<usize>,
    /// What is wrong, and what to do.
    pub message: String,
}

impl From<Wrong> for Misfit {
    fn from(wrong: Wrong) -> Misfit {
        (wrong.at, wrong.message)
    }
}

#[cfg(all(test, feature = "modbus"))]
impl Wrong {
    /// What is wrong, a line each, with where it is written.
    pub(crate) fn lines(wrong: &[Wrong]) -> Vec<String> {
        let lines = wrong.iter();
        lines
            .map(|wrong| format!("{}: {}", wrong.at.start, wrong.message))
            .collect()
    }
}
