//! `bad-operand`: something is in an operand's place that cannot be there.

use super::form::Form;
use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::mistakes::bad_operand::wrong;
use crate::names::did_you_mean;
use crate::networks::BlockAt;
use crate::networks::facts::{OperandFacts, Word};
use crate::networks::network::{Formal, Meaning};
use crate::program::ParameterKind;
use ladder_instructions::{Direction, Presence, Profile, Profiles};
use ladder_syntax::TextRange;

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
        return found.help(format!("did you mean `{near}`?")).fix(
            Applicability::Unsafe,
            format!("Replace with `{near}`"),
            bound.absolute(name.range),
            near,
        );
    }
    match names.as_slice() {
        [] => found.help("it has no operands that are given by name"),
        names => found.help(format!("by name it takes {}", names.join(", "))),
    }
}

/// Whether an operand is at the place that its name says, behind operands that are given by place.
fn is_at_its_place(bound: BlockAt<'_>, operand: &OperandFacts, name: &Word) -> bool {
    let operands = &bound.facts.operands;
    let place = operands.iter().take_while(|other| other.name().is_none()).count();
    let row = bound.instruction().and_then(|row| row.positional(place));
    operands.get(place).is_some_and(|at| at.range == operand.range)
        && row.is_some_and(|row| row.name.eq_ignore_ascii_case(&name.text))
}
