//! A place that an editor is sent to.

use ladder_syntax::TextRange;
use std::sync::Arc;

/// A place in a file of the workspace.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Target {
    /// The file.
    pub file: Arc<str>,
    /// All that belongs to the place: a declaration, a body.
    pub range: TextRange,
    /// Where the cursor goes: the name.
    pub focus: TextRange,
}
