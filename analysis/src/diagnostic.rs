//! A finding: what is wrong, where, what to do.

use crate::rule::{Rule, Severity};
use ladder_format::Edit;
use ladder_syntax::TextRange;
use std::sync::Arc;

/// A finding of a rule. Ranges count bytes from the start of the file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    /// The rule that found it.
    pub rule: Rule,
    /// How much it matters.
    pub severity: Severity,
    /// Where.
    pub range: TextRange,
    /// What is wrong, naming the thing.
    pub message: String,
    /// What to do about it.
    pub help: Option<String>,
    /// Other places that have to do with it.
    pub related: Vec<Related>,
    /// Ways to mend it; the best first.
    pub fixes: Vec<Fix>,
}

/// Another place that a finding has to do with.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Related {
    /// The file, if it is another one of the workspace.
    pub file: Option<Arc<str>>,
    /// Where.
    pub range: TextRange,
    /// What is there.
    pub message: String,
}

/// A way to mend a finding.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fix {
    /// What it does, in a few words: "Insert `]`".
    pub title: String,
    /// The edits, sorted and disjoint.
    pub edits: Vec<Edit>,
}

impl Diagnostic {
    /// A finding with the rule's own severity.
    pub fn new(rule: Rule, range: TextRange, message: impl Into<String>) -> Diagnostic {
        Diagnostic {
            rule,
            severity: rule.default_severity(),
            range,
            message: message.into(),
            help: None,
            related: Vec::new(),
            fixes: Vec::new(),
        }
    }

    /// Adds what to do.
    #[must_use]
    pub fn help(mut self, help: impl Into<String>) -> Diagnostic {
        self.help = Some(help.into());
        self
    }

    /// Adds a related place.
    #[must_use]
    pub fn related(mut self, range: TextRange, message: impl Into<String>) -> Diagnostic {
        self.related.push(Related {
            file: None,
            range,
            message: message.into(),
        });
        self
    }

    /// Adds a related place in another file.
    #[must_use]
    pub fn related_in(mut self, file: &Arc<str>, range: TextRange, message: impl Into<String>) -> Diagnostic {
        self.related.push(Related {
            file: Some(Arc::clone(file)),
            range,
            message: message.into(),
        });
        self
    }

    /// Adds a related place in another file, or in this one where there is none.
    #[must_use]
    pub(crate) fn related_at(
        self,
        file: Option<&Arc<str>>,
        range: TextRange,
        message: impl Into<String>,
    ) -> Diagnostic {
        match file {
            Some(file) => self.related_in(file, range, message),
            None => self.related(range, message),
        }
    }

    /// Adds a fix, if there is one.
    #[must_use]
    pub fn with(mut self, fix: Option<Fix>) -> Diagnostic {
        self.fixes.extend(fix);
        self
    }

    /// Adds a fix of one edit.
    #[must_use]
    pub fn fix(mut self, title: impl Into<String>, range: TextRange, text: impl Into<String>) -> Diagnostic {
        self.fixes.push(Fix {
            title: title.into(),
            edits: vec![Edit {
                range,
                text: text.into(),
            }],
        });
        self
    }
}
