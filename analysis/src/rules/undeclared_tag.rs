//! `undeclared-tag`: a tag is used that no declaration names.

use crate::diagnostic::Diagnostic;
use crate::rule::{Rule, Severity};
use ladder_syntax::TextRange;

/// An array must be declared: its bounds are nowhere else.
pub(crate) fn array(name: &str, range: TextRange) -> Diagnostic {
    let mut found = Diagnostic::new(
        Rule::UndeclaredTag,
        range,
        format!("the array `{name}` is not declared"),
    );
    found.severity = Severity::Error;
    found.help(format!("declare it: VAR {name} : ARRAY[1..10] OF DINT; END_VAR"))
}
