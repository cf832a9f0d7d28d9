//! What a finding is: its rule, its places, its sentences and fixes, and what comments say about it. No file here knows a
//! rule's; who asks the rules, and keeps what they find, is [`checking`](crate::checking).
//!
//! What networks and tags own is kept with [`Anchored`] places, which stay true when text comes or goes elsewhere. A
//! [`Finding`] is small: rule, severity and place are there, the sentences are put into place when somebody reads them.

pub(crate) mod article;
pub mod diagnostic;
pub(crate) mod excerpt;
pub mod fix;
pub(crate) mod foreign_comment;
pub(crate) mod lint;
pub mod rule;
pub mod rule_settings;
pub(crate) mod stamp;
pub(crate) mod verdict;

mod anchored;

pub(crate) use anchored::{Anchored, Home};

use crate::context::Context;
use crate::diagnostic::Diagnostic;
use crate::rule::{Rule, Severity};
use ladder_syntax::{TextRange, TextSize};
use std::sync::Arc;

/// A finding as it is shown.
#[derive(Debug, Clone)]
pub struct Finding {
    /// The rule that found it.
    pub rule: Rule,
    /// How much it matters.
    pub severity: Severity,
    /// Where, in bytes from the start of the file.
    pub range: TextRange,
    /// Where the network starts that it is about.
    own: TextSize,
    anchored: Arc<Anchored>,
}

impl Finding {
    /// One about a network that starts at `own`, if it is about one.
    pub(crate) fn new(anchored: &Arc<Anchored>, own: TextSize, context: &Context) -> Finding {
        Finding::at(anchored.range(own, context), anchored.severity(), (anchored, own))
    }

    /// The same where its range is known.
    fn at(range: TextRange, severity: Severity, (anchored, own): (&Arc<Anchored>, TextSize)) -> Finding {
        Finding {
            rule: anchored.rule(),
            severity,
            range,
            own,
            anchored: Arc::clone(anchored),
        }
    }

    /// One whose places all count from `own`.
    pub(crate) fn counted_from(anchored: &Arc<Anchored>, own: TextSize) -> Finding {
        let range = anchored.anchored_range() + own;
        Finding::at(range, anchored.severity(), (anchored, own))
    }

    /// The finding with the severity that settings give it.
    pub(crate) fn counted_as(self, severity: Severity) -> Finding {
        Finding { severity, ..self }
    }

    /// Stands for what it says: where two findings of a document have the same number and both are kept, they say the
    /// same, at places that count from the same networks.
    pub fn identity(&self) -> usize {
        Arc::as_ptr(&self.anchored).addr()
    }

    /// Adds the physical lines, counted from 0, on which the networks and lines of declarations start that its places in this file
    /// count from: one for all of them, or one for each in the order of range, related places, edits. False if the places are
    /// true for one text only.
    pub fn first_lines(&self, context: &Context, lines: &mut Vec<u32>) -> bool {
        self.anchored.first_lines(self.own, context, lines)
    }

    /// Whether one of its fixes may be made unasked.
    pub fn has_safe_fix(&self) -> bool {
        self.anchored.has_safe_fix()
    }

    /// All of it. `context` is that of the text in which it was found.
    pub fn diagnostic(&self, context: &Context) -> Diagnostic {
        let mut found = self.anchored.placed(self.own, context);
        found.severity = self.severity;
        found
    }
}

impl From<Diagnostic> for Finding {
    /// One that is true for one text only: its places count from the start of the file.
    fn from(found: Diagnostic) -> Finding {
        Finding {
            rule: found.rule,
            severity: found.severity,
            range: found.range,
            own: TextSize::default(),
            anchored: Arc::new(Anchored::in_file(found)),
        }
    }
}
