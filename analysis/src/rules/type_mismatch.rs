//! `type-mismatch`: a value does not pass to the type that its place asks for.

use crate::findings::article::with_article;
use crate::findings::diagnostic::{Applicability, Diagnostic, Fix};
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::values::types::{Scalar, Type};
use ladder_format::Edit;
use ladder_instructions::{Op, StateType, TypeClass};
use ladder_syntax::TextRange;

pub(crate) const RULE: Rule = Rule(
    &RuleFacts::new(RuleGroup::Blocks, "type-mismatch", Severity::Error)
        .about_types()
        .fixed(Applicability::Unsafe),
);

pub(crate) fn wrong(range: TextRange, message: impl Into<String>) -> Diagnostic {
    Diagnostic::new(RULE, range, message)
}

/// Two places ask for two types of one undeclared tag.
pub(crate) fn two_answers(name: &str, first: (Type, TextRange), second: (Type, TextRange)) -> Diagnostic {
    let message = format!("`{name}` is used as {} here, and as {} before", second.0, first.0);
    let found = wrong(second.1, message).related(first.1, format!("here it is {}", first.0));
    match (first.0, second.0) {
        (Type::State(state), Type::Scalar(Scalar::Bool)) => found
            .help(format!(
                "for the output of the {} write `{name}.{}`",
                state.name(),
                state.output()
            ))
            .fix(
                Applicability::Unsafe,
                format!("Use the output of `{name}`"),
                TextRange::empty(second.1.end()),
                format!(".{}", state.output()),
            ),
        (Type::State(_), Type::State(_)) => found.help("give each of the two blocks a tag of its own"),
        _ => found.help("declare it with the type it should have, and use another tag for the other"),
    }
}

/// The tag of a timer is where a value belongs.
pub(crate) fn state_as_value(name: &str, state: StateType, range: TextRange) -> Diagnostic {
    let message = format!(
        "`{name}` is the state of {}, a value is expected here",
        with_article(state.name())
    );
    let member = match state {
        StateType::Sr | StateType::Rs => format!("`{name}.Q1` is its output"),
        state if state.is_counter() => format!("`{name}.Q` is its output, `{name}.CV` its count"),
        _ => format!("`{name}.Q` is its output, `{name}.ET` its elapsed time"),
    };
    wrong(range, message).help(member)
}

/// A structure or an array is where a value belongs; `open` are the dimensions of an array that have no index.
pub(crate) fn part_as_value(
    name: &str,
    ty: Type,
    open: Option<Vec<(i64, i64)>>,
    range: TextRange,
) -> Diagnostic {
    match (ty, open) {
        (Type::State(state), _) => state_as_value(name, state, range),
        (_, Some(open)) => {
            let indices: Vec<String> = open.iter().map(|(first, _)| first.to_string()).collect();
            let element = match name.strip_suffix(']') {
                Some(begun) => format!("{begun}, {}]", indices.join(", ")),
                None => format!("{name}[{}]", indices.join(", ")),
            };
            wrong(
                range,
                format!("`{name}` is an array: name an element such as {element}"),
            )
        }
        (ty, None) => wrong(
            range,
            format!("`{name}` is {}, a value is expected here", with_article(ty)),
        )
        .help("name one of its members"),
    }
}

/// Two operands in each other's place: for a rule about operands.
pub(crate) fn swapped(
    rule: Rule,
    first: (TextRange, &str),
    second: (TextRange, &str),
    order: String,
) -> Diagnostic {
    let edits = [(first.0, second.1), (second.0, first.1)].map(|(range, text)| Edit {
        range,
        text: text.to_owned(),
    });
    let title = format!("Swap `{}` and `{}`", first.1, second.1);
    let message = format!("`{}` and `{}` are swapped", first.1, second.1);
    Diagnostic::new(rule, first.0.cover(second.0), message)
        .help(order)
        .with(Fix::new(Applicability::Unsafe, title, edits.into()))
}

/// What a block writes does not pass to the tag that takes it.
pub(crate) fn does_not_take(
    given: &str,
    tag: Scalar,
    writes: (&str, Scalar),
    range: TextRange,
) -> Diagnostic {
    let (what, written) = writes;
    wrong(range, format!("{given} is {tag}, and {what} is {written}")).help(format!(
        "give a tag of type {written}, and convert it with [TYP]( result, value ) afterwards"
    ))
}

/// A value that does not pass to the type that its place asks for.
pub(crate) fn does_not_pass(from: Scalar, to: Scalar, range: TextRange) -> Diagnostic {
    unfit(format!("this is {from}, {to} is expected here"), from, to, range)
}

/// The same of what is given for an operand of a block.
pub(crate) fn does_not_pass_for(
    given: &str,
    (operand, block): (&str, &str),
    from: Scalar,
    to: Scalar,
    range: TextRange,
) -> Diagnostic {
    let message = format!("`{given}` is {from}, and `{operand}` of {block} takes {to}");
    unfit(message, from, to, range)
}

fn unfit(message: String, from: Scalar, to: Scalar, range: TextRange) -> Diagnostic {
    let found = wrong(range, message);
    let bits = |ty: Scalar| ty.is_bits() || ty.is_integer();
    if from == Scalar::Bool && bits(to) {
        return found
            .help("a contact turns a BOOL into power: put it before the block; or convert it with [TYP]");
    }
    if to == Scalar::Bool && bits(from) {
        return found.help("compare it ([NE]( tag, 0 )), or name one of its bits (tag.0)");
    }
    found.help(format!(
        "convert it with [TYP]( result, value ) into {} first",
        with_article(to)
    ))
}

/// A tag where a value of an enumeration is asked for that has the same name.
pub(crate) fn hidden_value(
    tag: &str,
    found: Scalar,
    (enumeration, value): (&str, &str),
    range: TextRange,
) -> Diagnostic {
    let whole = format!("{enumeration}.{value}");
    let message = format!("`{tag}` is the tag of this name here, {}", with_article(found));
    wrong(range, message)
        .help(format!("for the value of {enumeration} write `{whole}`"))
        .fix(
            Applicability::Unsafe,
            format!("Replace with `{whole}`"),
            range,
            whole,
        )
}

/// An operator does not work in the type of the result.
pub(crate) fn operator(range: TextRange, ty: Scalar) -> Diagnostic {
    wrong(
        range,
        format!("this operator does not work in {ty}, the type of the result"),
    )
}

/// Times, points in time and numbers that do not fit together.
pub(crate) fn times(op: Op, ty: Scalar, range: TextRange) -> Diagnostic {
    let (message, help) = match (op, ty) {
        (Op::Add, Scalar::Dt) => (
            "a DT is the sum of a DT and TIMEs",
            "the DT comes first: [ADD]( dt, dt, time )",
        ),
        (_, Scalar::Dt) => (
            "only [ADD] gives a DT: from a DT and a TIME",
            "for an earlier one add a negative TIME: [ADD]( dt, dt, T#-1h )",
        ),
        (Op::Sub, _) => (
            "a TIME is the difference of two TIMEs, two DTs or two TODs",
            "both sides are of one type: [SUB]( time, later, earlier )",
        ),
        (Op::Mul, _) => (
            "a TIME is multiplied by numbers",
            "one operand is the TIME, the others are numbers: [MUL]( time, time, 3 )",
        ),
        (Op::Div, _) => (
            "a TIME is divided by numbers",
            "the TIME comes first: [DIV]( time, time, 2 )",
        ),
        _ => (
            "all operands must be TIMEs, as the result is",
            "convert a number of milliseconds with [TYP]( time, number ) first",
        ),
    };
    wrong(range, message).help(help)
}

pub(crate) fn cannot_compare(a: Scalar, b: Scalar, range: TextRange) -> Diagnostic {
    wrong(range, format!("{a} and {b} cannot be compared")).help("convert one of them with [TYP] first")
}

pub(crate) fn no_order(ty: Scalar, range: TextRange) -> Diagnostic {
    if ty.is_enumeration() {
        return wrong(
            range,
            format!("values of {ty} are equal or not: none is greater than another"),
        )
        .help("use [EQ] and [NE], or convert them to numbers with [TYP] first");
    }
    wrong(
        range,
        "BOOL values are equal or not: none is greater than another",
    )
    .help("use contacts, or [EQ] and [NE]")
}

/// `[TYP]` between a duration and a point in time, or a day and a time of day.
pub(crate) fn does_not_convert(from: Scalar, to: Scalar, range: TextRange) -> Diagnostic {
    let message = format!("{from} cannot be converted into {to}");
    wrong(range, message).help(
        "a DT converts to its DATE and its TOD, a DATE to a DT; a TIME is the difference of two TODs or two DTs, \
         [SUB]( time, later, earlier )",
    )
}

/// `[WRAP]` has a value that has no bits to cut.
pub(crate) fn does_not_wrap(from: Scalar, range: TextRange) -> Diagnostic {
    wrong(
        range,
        format!("[WRAP] takes an integer or a bit string, this is {from}"),
    )
    .help("[TYP] converts any type; a value that does not fit is a fault there")
}

/// The result's type is none that the instruction gives.
pub(crate) fn result(ty: Scalar, class: TypeClass, range: TextRange) -> Diagnostic {
    let expected = match class {
        TypeClass::Number => "a number",
        TypeClass::NumberOrTime => "a number or a TIME",
        TypeClass::Real => "REAL or LREAL",
        TypeClass::BitsOrInteger => "a bit string (BYTE to LWORD) or an integer",
        TypeClass::BoolBitsOrInteger => "BOOL, a bit string or an integer",
        TypeClass::Integer => "an integer",
        TypeClass::String => "a STRING",
        TypeClass::Any => "an elementary type",
    };
    wrong(range, format!("the result is {ty}, this block gives {expected}"))
}

/// A timer's or counter's block is on a tag of another type.
pub(crate) fn wrong_state(name: &str, found: Type, expected: StateType, range: TextRange) -> Diagnostic {
    wrong(
        range,
        format!(
            "`{name}` is {found}, this block keeps its state in {}",
            with_article(expected.name())
        ),
    )
    .help(format!(
        "give it a tag of its own: `{name} : {};`",
        expected.name()
    ))
}
