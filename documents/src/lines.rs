//! Lines as messages name them.

use serde::{Deserialize, Serialize};

/// Lines that follow one another.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Lines {
    /// The first of them, from 0.
    pub first: u32,
    /// The last of them, which belongs to them.
    pub last: u32,
}
