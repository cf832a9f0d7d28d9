//! `bad-operand`: something is in an operand's place that cannot be there. `rules/bad_operand.rs` looks at
//! operands that are given by name.

use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::findings::rule::Rule;
use ladder_instructions::StateType;
use ladder_syntax::{Many, OperandPlace, TextRange};

pub(crate) fn wrong(range: TextRange, message: impl Into<String>) -> Diagnostic {
    Diagnostic::new(Rule::BadOperand, range, message)
}

/// An expression where a tag or literal must be.
pub(crate) fn expression(range: TextRange) -> Diagnostic {
    wrong(
        range,
        "an expression belongs in [CALC] only: a tag or a literal is expected here",
    )
    .help("compute it first: [CALC]( result, expression ), then use the result")
}

/// NEXT of a search in an array that has an element -1, or could have.
pub(crate) fn next_below_zero(array: &str, first: i64, range: TextRange) -> Diagnostic {
    wrong(
        range,
        format!("`{array}` begins at {first}: NEXT goes on behind the index in the result, where -1 says that nothing was found"),
    )
    .help("let the array begin at 0 or 1")
}

/// What begins like a direct address and is none.
pub(crate) fn no_address(address: &str, range: TextRange) -> Diagnostic {
    wrong(
        range,
        format!("`{address}` is no address: write one like %IX0.0, %QW1 or %MD2"),
    )
}

/// `PI` where a tag is expected.
pub(crate) fn pi(range: TextRange) -> Diagnostic {
    wrong(range, "PI is a number for the expressions of [CALC], no tag")
        .help("compute with it there: [CALC]( result, PI * radius ), then use the result")
}

/// An expression between the brackets of an index.
pub(crate) fn expression_as_index(range: TextRange) -> Diagnostic {
    wrong(range, "an index is one tag or one number, no expression")
        .help("compute it first: [CALC]( i, expression ), then use i")
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

/// Parentheses behind an element, a member, another call.
pub(crate) fn no_function(range: TextRange) -> Diagnostic {
    wrong(
        range,
        "parentheses belong behind the name of a function only: this is none",
    )
}

/// What is in an operand's place means nothing, and no other rule says why. Never wanted, but better than a
/// program that runs without the operand.
pub(crate) fn meaningless(block: TextRange) -> Diagnostic {
    wrong(block, "an operand of this block means nothing here")
}

pub(crate) fn unknown_function(name: &str, range: TextRange) -> Diagnostic {
    let found = wrong(range, format!("there is no function `{name}` for expressions"));
    match ladder_instructions::closest(ladder_instructions::Shape::Logical, name) {
        Some(row) if crate::values::callable::is_callable(row) => {
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
        // One name may have been cut in two.
        .fix(
            Applicability::Unsafe,
            "Insert `,`",
            TextRange::empty(range.start()),
            ", ",
        )
}

/// The operands of a list behind the last one that is read.
pub(crate) fn too_many(range: TextRange) -> Diagnostic {
    let most = Many::Operands.most();
    wrong(
        range,
        format!("a block takes at most {most} operands: these and what follows are not read"),
    )
    .help("do it in several blocks")
}

pub(crate) fn too_complex(range: TextRange) -> Diagnostic {
    wrong(range, "this expression is too long or nested too deeply").help("compute it in several steps")
}
