//! The messages of the commands that have to do with typing.

use serde::{Deserialize, Serialize};

/// The argument of `ladder.cursor`: where a client's cursor is.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Cursor {
    /// The document.
    pub uri: String,
    /// The line, from 0; none if nobody types in the document.
    pub line: Option<u32>,
}
