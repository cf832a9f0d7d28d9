//! One finding on the shelf, and how many there are.

use crate::findings::{Anchored, Finding};
use crate::rule::{Rule, Severity};
use ladder_syntax::{TextRange, TextSize};
use std::ops::AddAssign;
use std::sync::Arc;

/// Who finds something. Of two findings of one rule at one place the first of these is shown: what is found while
/// types are inferred comes before what follows from it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Source {
    Context,
    /// The types that the places of tags ask for.
    Types,
    Network,
    Names,
    Tag,
    Program,
    Text,
}

impl Source {
    /// Who finds something that a tag owns.
    pub(crate) fn of_tag(found: &Anchored) -> Source {
        if found.rule() == Rule::TypeMismatch {
            Source::Types
        } else {
            Source::Tag
        }
    }

    pub(super) fn is_tag(self) -> bool {
        matches!(self, Source::Types | Source::Tag)
    }
}

/// One finding.
#[derive(Debug, Clone)]
pub(super) struct Item {
    /// From the start of its network or line of declarations.
    pub(super) range: TextRange,
    pub(super) rule: Rule,
    pub(super) source: Source,
    /// As the rule says.
    pub(super) severity: Severity,
    /// As the settings ask for; none if they hide it, or a comment.
    pub(super) level: Option<Severity>,
    /// The one before it says the same.
    pub(super) repeats: bool,
    pub(super) anchored: Arc<Anchored>,
}

/// How many findings there are.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Count {
    /// All of them.
    pub(crate) found: usize,
    /// Those that are shown.
    pub(crate) shown: usize,
    /// Those that are shown as errors.
    pub(crate) errors: usize,
    /// Errors, as the rules say.
    pub(crate) found_errors: usize,
    /// Those of them that are hidden, or count as less.
    pub(crate) hidden_errors: usize,
}

impl AddAssign for Count {
    fn add_assign(&mut self, other: Count) {
        self.found += other.found;
        self.shown += other.shown;
        self.errors += other.errors;
        self.found_errors += other.found_errors;
        self.hidden_errors += other.hidden_errors;
    }
}

impl Item {
    pub(super) fn new(anchored: &Arc<Anchored>, source: Source) -> Item {
        let (rule, severity) = (anchored.rule(), anchored.severity());
        Item {
            range: anchored.anchored_range(),
            rule,
            source,
            severity,
            level: None,
            repeats: false,
            anchored: Arc::clone(anchored),
        }
    }

    pub(super) fn count(&self) -> Count {
        if self.repeats {
            return Count::default();
        }
        let found = self.severity == Severity::Error;
        let shown = self.level == Some(Severity::Error);
        Count {
            found: 1,
            shown: usize::from(self.level.is_some()),
            errors: usize::from(shown),
            found_errors: usize::from(found),
            hidden_errors: usize::from(self.is_hidden_error()),
        }
    }

    /// Whether it is an error that is hidden, or counts as less.
    pub(super) fn is_hidden_error(&self) -> bool {
        self.severity == Severity::Error && self.level != Some(Severity::Error)
    }

    /// As the rule says it, of a network or line that starts at `own`.
    pub(super) fn finding(&self, own: TextSize) -> Finding {
        Finding::counted_from(&self.anchored, own)
    }
}

/// Puts findings into their order.
pub(super) fn arrange(items: &mut [Item]) {
    let place = |item: &Item| (item.range.start(), item.range.end(), item.rule);
    items.sort_by_key(|item| (place(item), item.source));
    let mut before = None;
    for item in items {
        let place = Some(place(item));
        item.repeats = std::mem::replace(&mut before, place) == place;
    }
}
