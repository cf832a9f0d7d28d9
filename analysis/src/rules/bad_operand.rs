//! `bad-operand`: something stands in an operand's place that cannot stand there.

use crate::diagnostic::Diagnostic;
use crate::rule::Rule;
use ladder_instructions::StateType;
use ladder_syntax::TextRange;

pub(crate) fn wrong(range: TextRange, message: impl Into<String>) -> Diagnostic {
    Diagnostic::new(Rule::BadOperand, range, message)
}

/// An expression where a tag or literal must stand.
pub(crate) fn expression(range: TextRange) -> Diagnostic {
    wrong(
        range,
        "an expression stands in [CALC] only: a tag or a literal is expected here",
    )
    .help("compute it first: [CALC]( result, expression ), then use the result")
}

pub(crate) fn literal_as_target(range: TextRange) -> Diagnostic {
    wrong(range, "a tag is expected here: the block writes its result to it").help("the result comes first")
}

pub(crate) fn state_expected(state: StateType, range: TextRange) -> Diagnostic {
    let message = format!(
        "a tag is expected here that keeps the state of the {}",
        state.name()
    );
    wrong(range, message).help(format!(
        "give it a name of its own; it may be declared: name : {};",
        state.name()
    ))
}

pub(crate) fn unknown_function(name: &str, range: TextRange) -> Diagnostic {
    let found = wrong(range, format!("there is no function `{name}` for expressions"));
    match ladder_instructions::closest(ladder_instructions::Shape::Logical, name) {
        Some(row) if crate::resolve::is_function(row) => {
            found.help(format!("did you mean {}?", row.mnemonic))
        }
        _ => found,
    }
}
