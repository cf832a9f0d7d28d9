//! How a file refers to something in another one.

use std::sync::Arc;

/// Something in another file: its name, and the index in that file's own context.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Import {
    /// The file.
    pub file: Arc<str>,
    /// The function or block.
    pub item: usize,
}
