//! `bad-operand`: something is in an operand's place that cannot be there.

use super::form::Form;
use super::near_names::{self, Meant};
use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::findings::did_you_mean;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::networks::BlockAt;
use crate::networks::network::{Formal, Meaning};
use crate::program::ParameterKind;
use crate::values::compound::Enumeration;
use crate::written::facts::{OperandFacts, Word};
use ladder_instructions::StateType;
use ladder_instructions::{Direction, Presence, Profile, Profiles};
use ladder_syntax::{Many, OperandPlace, TextRange, TextSize};

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Blocks, "bad-operand", Severity::Error).about_types());

pub(super) fn check(form: &Form<'_>, out: &mut Vec<Diagnostic>) {
    for bound in form.network.blocks() {
        if bound.faulty {
            continue;
        }
        for (operand, formal) in bound.facts.operands.iter().zip(bound.formals.iter()) {
            let Some(name) = operand.name() else { continue };
            let is_read = match (*formal, bound.meaning) {
                (Formal::UnknownName, Meaning::User(block)) if form.user_blocks[block].doubtful => {
                    continue;
                }
                (Formal::UnknownName, _) => {
                    out.push(unknown_name(form, bound, operand, name));
                    continue;
                }
                (Formal::Operand(row), _) => {
                    if !row.profiles.contain(form.profile) {
                        out.push(of_another_profile(
                            form.profile,
                            row.profiles,
                            bound,
                            operand,
                            name,
                        ));
                        continue;
                    }
                    row.direction == Direction::In
                }
                (Formal::Parameter(index), Meaning::User(block)) => {
                    form.user_blocks[block].parameters[index].kind == ParameterKind::Input
                }
                _ => continue,
            };
            if operand.has_arrow() && is_read {
                out.push(arrow(bound, operand, name));
            }
        }
    }
}

/// An operand that only another profile than that of the file knows.
fn of_another_profile(
    profile: Profile,
    known: Profiles,
    bound: BlockAt<'_>,
    operand: &OperandFacts,
    name: &Word,
) -> Diagnostic {
    let known = Profile::ALL.into_iter().filter(|profile| known.contain(*profile));
    let known: Vec<String> = known
        .map(|profile| format!("# ladder: profile {profile} #"))
        .collect();
    wrong(
        bound.absolute(operand.range),
        format!(
            "{} has no operand `{}` in the profile `{profile}`",
            bound.head_text(),
            name.text
        ),
    )
    .help(format!(
        "leave it out, or say above the first network whose arithmetic the program has: {}",
        known.join(" or ")
    ))
}

/// `=>` before an operand that the block reads.
fn arrow(bound: BlockAt<'_>, operand: &OperandFacts, name: &Word) -> Diagnostic {
    let found = wrong(
        bound.absolute(operand.range),
        format!("`{}` is an operand that {} reads", name.text, bound.head_text()),
    )
    .help("`:=` gives an operand, `=>` takes a result");
    match operand.arrow_range() {
        // An output may be meant.
        Some(arrow) => found.fix(
            Applicability::Unsafe,
            "Replace `=>` with `:=`",
            bound.absolute(arrow),
            ":=",
        ),
        None => found,
    }
}

/// A name before `:=` that the block does not have.
fn unknown_name(form: &Form<'_>, bound: BlockAt<'_>, operand: &OperandFacts, name: &Word) -> Diagnostic {
    let head = bound.head_text();
    let (names, by_place): (Vec<&str>, bool) = match bound.meaning {
        Meaning::Instruction(row) => {
            let named = row
                .operands
                .iter()
                .filter(|o| o.presence == Presence::Named && o.profiles.contain(form.profile));
            let by_place = row
                .operands
                .iter()
                .any(|o| o.name.eq_ignore_ascii_case(&name.text));
            (named.map(|o| o.name).collect(), by_place)
        }
        Meaning::User(block) => {
            let parameters = form.user_blocks[block].parameters.iter();
            (parameters.map(|p| p.name.as_str()).collect(), false)
        }
        _ => (Vec::new(), false),
    };
    if by_place {
        let prefix = TextRange::new(operand.range.start(), operand.value.range.start());
        let applicability = if is_at_its_place(bound, operand, name) {
            Applicability::Safe
        } else {
            Applicability::Unsafe
        };
        return wrong(
            bound.absolute(name.range),
            format!("`{}` of {head} is given by its place, without a name", name.text),
        )
        .help("the first operands come in their order; only the optional ones are given by name")
        .fix(
            applicability,
            format!("Remove `{} :=`", name.text),
            bound.absolute(prefix),
            "",
        );
    }
    let found = wrong(
        bound.absolute(name.range),
        format!("{head} has no operand of the name `{}`", name.text),
    );
    if let Some(near) = did_you_mean::closest(&name.text, names.iter().copied()) {
        let meant = Meant::name(near, "Replace with", bound.absolute(name.range));
        return near_names::ask(found, &name.text, near, meant);
    }
    match names.as_slice() {
        [] => found.help("it has no operands that are given by name"),
        names => found.help(format!("by name it takes {}", names.join(", "))),
    }
}

/// Whether an operand is at the place that its name says, after operands that are given by place.
fn is_at_its_place(bound: BlockAt<'_>, operand: &OperandFacts, name: &Word) -> bool {
    let operands = &bound.facts.operands;
    let place = operands.iter().take_while(|other| other.name().is_none()).count();
    let row = bound.instruction().and_then(|row| row.positional(place));
    operands.get(place).is_some_and(|at| at.range == operand.range)
        && row.is_some_and(|row| row.name.eq_ignore_ascii_case(&name.text))
}

pub(crate) fn wrong(range: TextRange, message: impl Into<String>) -> Diagnostic {
    Diagnostic::new(RULE, range, message)
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
        format!("`{array}` begins at {first}: NEXT goes on after the index in the result, where -1 says that nothing was found"),
    )
    .help("let the array begin at 0 or 1")
}

/// What begins like a direct address and is none.
pub(crate) fn no_address(address: &str, range: TextRange) -> Diagnostic {
    wrong(
        range,
        format!("`{address}` is not an address: write one like %IX0.0, %QW1 or %MD2"),
    )
}

/// `g[1..2, 3]`
pub(crate) fn range_inside(range: TextRange) -> Diagnostic {
    wrong(
        range,
        "a range is in the last dimension, at the end: name one element here",
    )
}

/// `PI` where a tag is expected.
pub(crate) fn pi(range: TextRange) -> Diagnostic {
    wrong(range, "PI is a number for the expressions of [CALC], no tag")
        .help("compute with it there: [CALC]( result, PI * radius ), then use the result")
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

/// Parentheses after an element, a member, another call.
pub(crate) fn no_function(range: TextRange) -> Diagnostic {
    wrong(
        range,
        "parentheses belong after the name of a function only: this is none",
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
        OperandPlace::Operator => "a value is missing next to this operator",
        OperandPlace::Named => "the value of the named operand is missing here",
        OperandPlace::Index => "the index is missing here",
        OperandPlace::Range => "a bound of the range is missing here",
        OperandPlace::Parentheses => "a value is missing between the parentheses",
        OperandPlace::Member => "the member is missing after the point",
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

/// What other systems write as `Phase#RUN`: the type and the value, if that is what is around the `#` before an operand.
fn typed_value<'t>(before: &'t str, text: &'t str) -> Option<(&'t str, &'t str)> {
    let before = before.strip_suffix('#')?;
    let ty = &before[before
        .trim_end_matches(|c: char| c.is_alphanumeric() || c == '_')
        .len()..];
    let is_name = |name: &str| name.starts_with(|c: char| c.is_alphabetic() || c == '_');
    (is_name(ty) && is_name(text)).then_some((ty, text))
}

/// `before`: what is before it on its line.
pub(crate) fn missing_comma(range: TextRange, before: &str, text: &str) -> Diagnostic {
    let found = wrong(range, "a comma is missing before this operand");
    let Some((number, unit)) = duration(before, text) else {
        // One name may have been cut in two, or what is here belongs somewhere else.
        return found.help(match typed_value(before, text) {
            Some((ty, value)) => format!(
                "the `#` before it closed a comment; the value of an enumeration is written {ty}.{value}"
            ),
            None => "operands are separated by commas".to_owned(),
        });
    };
    let blanks = before.len() - before.trim_end().len();
    let start = range.start() - TextSize::new(blanks as u32);
    let written = format!("{number}{unit}");
    found
        .help(format!("a duration has no blank in it: write {written}"))
        .fix(
            Applicability::Unsafe,
            format!("Write {written}"),
            TextRange::new(start, range.end()),
            unit,
        )
}

/// `5 s`, `1.5 sec`: a number, and a unit of time after it.
fn duration<'t>(before: &'t str, unit: &str) -> Option<(&'t str, &'static str)> {
    const UNITS: [(&str, &[&str]); 7] = [
        ("d", &["d", "day", "days"]),
        ("h", &["h", "hr", "hour", "hours"]),
        ("m", &["m", "min", "minute", "minutes"]),
        ("s", &["s", "sec", "second", "seconds"]),
        ("ms", &["ms", "msec", "millisecond", "milliseconds"]),
        ("us", &["us", "usec", "microsecond", "microseconds"]),
        ("ns", &["ns"]),
    ];
    let before = before.trim_end_matches([' ', '\t']);
    let is_of_number = |c: char| c.is_ascii_digit() || c == '.' || c == '_';
    let number = before.trim_end_matches(is_of_number);
    let number = &before[number.len()..];
    let is_whole_word =
        !before[..before.len() - number.len()].ends_with(|c: char| c.is_alphanumeric() || c == '_');
    let named = |names: &[&str]| names.iter().any(|name| name.eq_ignore_ascii_case(unit));
    let (sign, _) = UNITS.iter().find(|(_, names)| named(names))?;
    (is_whole_word && number.starts_with(|c: char| c.is_ascii_digit())).then_some((number, sign))
}

/// The operands of a list after the last one that is read.
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

/// A name that is not a value of the enumeration that is asked for.
pub(crate) fn no_value(enumeration: &Enumeration, name: &str, range: TextRange) -> Diagnostic {
    let values = || enumeration.values.iter().map(|(name, _)| name.as_str());
    let found = wrong(range, format!("{} has no value `{name}`", enumeration.name));
    match did_you_mean::closest(name, values()) {
        Some(near) => found.help(format!("did you mean {near}?")),
        None => found.help(format!(
            "its values are {}",
            values().take(20).collect::<Vec<_>>().join(" ")
        )),
    }
}

/// The value of an enumeration where none is asked for.
pub(crate) fn value_not_asked(name: &str, range: TextRange) -> Diagnostic {
    wrong(
        range,
        format!("`{name}` is the value of an enumeration, which this place does not ask for"),
    )
    .help(format!(
        "write the type before it, as in Phase.{name}, or another operand"
    ))
}
