//! What a finding is: its rule, its places, its sentences and fixes, and what comments say about it. No file here knows a
//! rule's; who asks the rules is `checking`.

pub(crate) mod article;
pub mod diagnostic;
pub(crate) mod did_you_mean;
pub(crate) mod excerpt;
pub mod fix;
pub(crate) mod foreign_comment;
pub mod rule;
pub mod rule_settings;

use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, Severity};
use ladder_syntax::{TextRange, TextSize};
use std::sync::Arc;

/// A finding as it is shown. It is small: the sentences are put into place when they are read.
#[derive(Debug, Clone)]
pub struct Finding {
    /// The rule that found it.
    pub rule: Rule,
    /// How much it matters.
    pub severity: Severity,
    /// Where, in bytes from the start of the file.
    pub range: TextRange,
    /// Where its places count from: the start of the network that it is about, or of the file.
    start: TextSize,
    found: Arc<Diagnostic>,
}

impl Finding {
    /// Whether it names a place in a file, another one than its own.
    pub fn relates_to(&self, file: &str) -> bool {
        let mut related = self.found.related.iter();
        related.any(|related| related.file.as_deref() == Some(file))
    }

    /// One whose places count from `start`.
    pub(crate) fn new(found: &Arc<Diagnostic>, start: TextSize) -> Finding {
        Finding {
            rule: found.rule,
            severity: found.severity,
            range: found.range + start,
            start,
            found: Arc::clone(found),
        }
    }

    /// Whether one of its fixes may be made unasked.
    pub fn has_safe_fix(&self) -> bool {
        self.found.fixes.iter().any(diagnostic::Fix::is_safe)
    }

    /// All of it.
    pub fn diagnostic(&self) -> Diagnostic {
        let mut found = Diagnostic::clone(&self.found);
        found.move_by(i64::from(u32::from(self.start)));
        found.severity = self.severity;
        found
    }
}

impl From<Diagnostic> for Finding {
    fn from(found: Diagnostic) -> Finding {
        Finding::new(&Arc::new(found.finished()), TextSize::default())
    }
}
