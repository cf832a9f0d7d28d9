//! `bad-operand`: something stands in an operand's place that cannot stand there.

use crate::diagnostic::Diagnostic;
use crate::rule::Rule;
use ladder_instructions::StateType;
use ladder_syntax::{OperandPlace, TextRange};

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

/// A value is missing; the parser says where.
pub(crate) fn missing(place: OperandPlace, range: TextRange) -> Diagnostic {
    let message = match place {
        OperandPlace::List => "an operand is missing here",
        OperandPlace::Operator => "a value is missing beside this operator",
        OperandPlace::Named => "the value of the named operand is missing here",
        OperandPlace::Index => "the index is missing here",
        OperandPlace::Range => "a bound of the range is missing here",
        OperandPlace::Parentheses => "a value is missing between the parentheses",
        OperandPlace::Member => "the member is missing behind the point",
    };
    let found = wrong(range, message);
    match place {
        OperandPlace::List => found.help("write the operand, or take the comma away"),
        OperandPlace::Named => found.help("a named operand is written R := reset"),
        OperandPlace::Range => found.help("a range is written a[3..9]"),
        OperandPlace::Member => found.help("a member is written t1.Q, a bit word.3"),
        _ => found,
    }
}

pub(crate) fn missing_comma(range: TextRange) -> Diagnostic {
    wrong(range, "a comma is missing before this operand")
        .help("operands are separated by commas")
        .fix("Insert `,`", TextRange::empty(range.start()), ", ")
}

pub(crate) fn too_complex(range: TextRange) -> Diagnostic {
    wrong(range, "this expression is too long or nested too deeply").help("compute it in several steps")
}
