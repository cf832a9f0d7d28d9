//! What is wrong with a scene, or worth knowing.

use ladder_analysis::Severity;
use ladder_syntax::TextRange;

/// One thing, where it is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finding {
    /// How bad it is: an error keeps a value from being shown, a warning is about what was left out of the drawing.
    pub severity: Severity,
    /// Where.
    pub range: TextRange,
    /// What.
    pub message: String,
    /// What to do.
    pub help: &'static str,
}

impl Finding {
    /// What is in the place of a rule's name.
    pub const NAME: &'static str = "bad-scene";

    /// What to do where the program that a scene names is missing.
    pub const NO_PROGRAM: &'static str = "name the program in the element `svg`, as it is seen from the folder of this file: l:program=\"motor.clad\"";

    pub(super) fn error(range: TextRange, message: impl Into<String>, help: &'static str) -> Finding {
        Finding::new(Severity::Error, range, message, help)
    }

    pub(super) fn warning(range: TextRange, message: impl Into<String>, help: &'static str) -> Finding {
        Finding::new(Severity::Warning, range, message, help)
    }

    pub(super) fn info(range: TextRange, message: impl Into<String>, help: &'static str) -> Finding {
        Finding::new(Severity::Info, range, message, help)
    }

    fn new(severity: Severity, range: TextRange, message: impl Into<String>, help: &'static str) -> Finding {
        Finding {
            severity,
            range,
            message: message.into(),
            help,
        }
    }
}
