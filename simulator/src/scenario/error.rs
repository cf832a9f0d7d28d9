//! What is wrong in a scenario file.

use ladder_syntax::TextRange;

/// An error in a scenario file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ScenarioError {
    /// Where, in bytes.
    pub range: TextRange,
    /// What is wrong.
    pub message: String,
    /// What to do, where the message does not say it.
    pub help: Option<String>,
}

impl ScenarioError {
    pub(super) fn new(
        range: TextRange,
        message: impl Into<String>,
        help: impl Into<String>,
    ) -> ScenarioError {
        ScenarioError {
            range,
            message: message.into(),
            help: Some(help.into()),
        }
    }
}
