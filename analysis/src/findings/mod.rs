//! What is found in a file, and how it is kept from one text to the next.
//!
//! ```text
//! Context --ledger--> findings by owner: a network, a tag, the file; each looked for where something changed
//!         --shown---> those that are shown, with their severities, in the order of their places: a list of Finding
//! ```
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
mod at_tags;
mod ledger;
mod part_notes;
mod shelf;
mod shown;

pub(crate) use anchored::Anchored;
pub(crate) use ledger::Ledger;
pub use ledger::Work;
pub(crate) use shown::Shown;
pub use shown::keep_nearest;

use crate::context::Context;
use crate::diagnostic::Diagnostic;
use crate::mistakes;
use crate::rule::{Rule, Severity};
use crate::rule_settings::RuleSettings;
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
    fn new(anchored: &Arc<Anchored>, own: TextSize, context: &Context) -> Finding {
        Finding {
            rule: anchored.rule(),
            severity: anchored.severity(),
            range: anchored.range(own, context),
            own,
            anchored: Arc::clone(anchored),
        }
    }

    /// Stands for what it says: where two findings of a document have the same number and both are kept, they say the
    /// same, at places that count from the same networks.
    pub fn identity(&self) -> usize {
        Arc::as_ptr(&self.anchored).addr()
    }

    /// Where the networks and lines of declarations start that its places count from; none if these are true for one text only.
    pub fn counts_from(&self, context: &Context) -> Option<Vec<TextSize>> {
        self.anchored.counts_from(self.own, context)
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

/// What is found in a text.
#[derive(Debug)]
pub(crate) struct Found {
    pub(crate) shown: Shown,
    /// Errors that settings or comments hide, or count as less.
    pub(crate) hidden_errors: Vec<Diagnostic>,
    /// What was looked at for it.
    pub(crate) work: Work,
    /// To be handed on to the next text.
    pub(crate) ledger: Ledger,
}

/// Looks for what is wrong in a file. `before` is what was found in an earlier text of it.
pub(crate) fn find(before: Option<Ledger>, context: &Context, settings: &RuleSettings) -> Found {
    let (ledger, of_file) = Ledger::look(before, context, settings);
    let (mut shown, hidden_errors) = shown::shown(context, &ledger, of_file, settings);
    if let Some(block) = ledger.unresolved(context)
        && hidden_errors.is_empty()
        && !shown.has_errors()
    {
        shown.add(Finding::from(mistakes::bad_operand::meaningless(block)));
    }
    Found {
        shown,
        hidden_errors,
        work: ledger.work(),
        ledger,
    }
}
