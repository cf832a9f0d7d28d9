//! `constant-write`: a block writes a tag that must not be written.

use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::Rule;
use ladder_syntax::TextRange;
use std::sync::Arc;

/// `file` is the one that declares it, if that is another.
pub(crate) fn constant(
    name: &str,
    range: TextRange,
    file: Option<&Arc<str>>,
    declared: TextRange,
) -> Diagnostic {
    Diagnostic::new(
        Rule::ConstantWrite,
        range,
        format!("`{name}` is a constant: no block may write it"),
    )
    .help("declare it in a VAR section without CONSTANT, or write another tag")
    .related_at(file, declared, format!("`{name}` is declared CONSTANT here"))
}

pub(crate) fn system(range: TextRange) -> Diagnostic {
    Diagnostic::new(
        Rule::ConstantWrite,
        range,
        "the tags of SYS are read only: the controller sets them",
    )
}
