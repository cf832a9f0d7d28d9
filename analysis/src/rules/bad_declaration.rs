//! `bad-declaration`: a section, a declaration or a block definition that cannot be read.

use crate::diagnostic::Diagnostic;
use crate::rule::Rule;
use ladder_syntax::TextRange;

/// A declaration that is well formed but means nothing.
pub(crate) fn wrong(range: TextRange, message: impl Into<String>) -> Diagnostic {
    Diagnostic::new(Rule::BadDeclaration, range, message)
}
