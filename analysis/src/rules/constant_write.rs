//! `constant-write`: a block writes a tag that must not be written.

use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use ladder_syntax::TextRange;
use std::sync::Arc;

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Blocks, "constant-write", Severity::Error).about_types());

/// `file` is the one that declares it, if that is another.
pub(crate) fn constant(
    name: &str,
    range: TextRange,
    file: Option<&Arc<str>>,
    declared: TextRange,
) -> Diagnostic {
    Diagnostic::new(
        RULE,
        range,
        format!("`{name}` is a constant: no block may write it"),
    )
    .help("declare it in a VAR section without CONSTANT, or write another tag")
    .related_at(file, declared, format!("`{name}` is declared CONSTANT here"))
}

pub(crate) fn system(range: TextRange) -> Diagnostic {
    Diagnostic::new(
        RULE,
        range,
        "the tags of SYS are read only: the controller sets them",
    )
}

/// What a block alone writes, by the tag of its state: anything but its inputs.
pub(crate) fn of_instance(name: &str, range: TextRange) -> Diagnostic {
    Diagnostic::new(RULE, range, format!("`{name}` is written by its block alone"))
        .help("write a tag of your own; of a block only the inputs are written from outside")
}
