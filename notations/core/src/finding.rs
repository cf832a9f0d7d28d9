//! What a system says about a program in its own notation: its design-rule checks.

use super::LineColumn;
use ladder_analysis::Severity;

/// A finding in a foreign file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finding {
    /// Where.
    pub place: LineColumn,
    /// How bad it is. With an error the program is read, but not run.
    pub severity: Severity,
    /// Which check found it: `textbook-precedence`.
    pub check: &'static str,
    /// What is wrong and what to do.
    pub message: String,
}
