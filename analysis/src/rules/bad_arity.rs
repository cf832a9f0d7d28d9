//! `bad-arity`: a block has too few or too many operands.

use crate::diagnostic::Diagnostic;
use crate::rule::Rule;
use ladder_syntax::TextRange;

pub(crate) fn twice(block: &str, range: TextRange) -> Diagnostic {
    Diagnostic::new(
        Rule::BadArity,
        range,
        format!("this operand of {block} is given twice"),
    )
}

pub(crate) fn parameter_missing(block: &str, parameter: &str, range: TextRange) -> Diagnostic {
    Diagnostic::new(
        Rule::BadArity,
        range,
        format!("the operand `{parameter}` of {block} is missing"),
    )
}
