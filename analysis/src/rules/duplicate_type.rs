//! `duplicate-type`: a type is declared twice in a file, or in two other files of which this one uses it: which of them is
//! meant?

use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use ladder_syntax::TextRange;
use std::sync::Arc;

pub(crate) const RULE: Rule = Rule(&RuleFacts::new(
    RuleGroup::Names,
    "duplicate-type",
    Severity::Error,
));

pub(crate) fn twice(name: &str, at: TextRange, first_at: TextRange) -> Diagnostic {
    Diagnostic::new(RULE, at, format!("the type `{name}` is declared twice"))
        .help(
            "remove one of the declarations, or give one type another name; capitals do not tell names apart",
        )
        .related(first_at, "it is first declared here")
}

/// Several other files declare a type that this one uses, and not alike.
pub(crate) fn in_files(name: &str, at: TextRange, files: &[(Arc<str>, TextRange)]) -> Diagnostic {
    let message =
        format!("several files declare the type `{name}`, and not alike: which one is meant is open");
    let found = Diagnostic::new(RULE, at, message)
        .help("rename all but one of them, or declare the type in this file");
    let related = |found: Diagnostic, (file, at): &(Arc<str>, TextRange)| {
        found.related_in(file, *at, "it is declared here")
    };
    files.iter().fold(found, related)
}
