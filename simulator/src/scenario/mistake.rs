//! What is wrong in a scenario file.

use ladder_syntax::TextRange;

/// A mistake in a scenario file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mistake {
    /// Where, in bytes.
    pub range: TextRange,
    /// What is wrong.
    pub message: String,
    /// What to do, where the message does not say it.
    pub help: Option<String>,
}

impl Mistake {
    pub(super) fn new(range: TextRange, message: impl Into<String>, help: impl Into<String>) -> Mistake {
        Mistake {
            range,
            message: message.into(),
            help: Some(help.into()),
        }
    }
}
