//! What is after a point: members of timers, counters and bistables, system tags, bits.

use super::item::{CompletionKind, Topic};
use super::proposals::Proposals;
use crate::hover::block_named;
use crate::typing::{Operand, Typing};
use crate::wanted::{Wanted, rank, scalar_rank, wanted, whole_type};
use ladder_analysis::program::{ParameterKind, SystemTag};
use ladder_analysis::state_member;
use ladder_analysis::values::compound::{Compound, Enumeration};
use ladder_analysis::values::types::{Scalar, Type};
use ladder_instructions::{Semantics, StateType};
use ladder_syntax::Name;

/// The members by their names in IEC 61131-3, then the other names that controllers have for them.
const MEMBERS: [(&str, &str); 20] = [
    ("Q", "The output."),
    ("ET", "The time run so far."),
    ("PT", "The preset time."),
    ("IN", "The power that entered the block."),
    ("CV", "The count."),
    ("PV", "The preset value."),
    ("QU", "The output of counting up: CV has reached PV."),
    ("QD", "The output of counting down: CV is 0 or less."),
    ("CU", "The power that entered the block."),
    ("CD", "The input of counting down."),
    ("LD", "The input that loads PV."),
    ("R", "The reset."),
    ("Q1", "The output."),
    (
        "TT",
        "The timer is timing: it has power, and its time is not over.",
    ),
    ("CC", "The counter changed in this evaluation."),
    ("DN", "The same as Q."),
    ("EN", "The same as IN or CU."),
    ("ACC", "The same as ET or CV."),
    ("PRE", "The same as PT or PV."),
    ("AC", "The same as ET or CV."),
];

/// From here on the names are second ones.
const SECOND_NAMES: usize = 15;

pub(super) fn propose(typing: &Typing<'_>, operand: &Operand, out: &mut Proposals<'_>) {
    let Some(base) = &operand.member_of else { return };
    let base = typing.text[base.clone()].trim();
    let wanted = wanted(typing, operand);
    if base.eq_ignore_ascii_case("SYS") {
        return system(wanted.as_ref(), out);
    }
    match whole_type(typing.context, typing.scope, base) {
        Some(Type::State(state)) => members(typing.context.profile.semantics(), state, wanted.as_ref(), out),
        Some(Type::Scalar(ty)) if ty.is_integer() || ty.is_bits() => bits(ty, out),
        Some(Type::Compound(id)) => {
            let semantics = typing.context.profile.semantics();
            match id.get() {
                Compound::Structure(structure) => {
                    let members = structure.members.iter().map(|member| (&*member.name, member.ty));
                    typed(semantics, members, wanted.as_ref(), out);
                }
                Compound::Block(name) => {
                    let Some(block) = block_named(typing.context, &Name::new(&name)) else {
                        return;
                    };
                    let shown = block
                        .parameters
                        .iter()
                        .filter(|it| it.kind != ParameterKind::InOut);
                    let members = shown.filter_map(|it| Some((it.name.as_str(), it.ty?)));
                    typed(semantics, members, wanted.as_ref(), out);
                }
                Compound::Array(_) => {}
            }
        }
        None => {
            if let Some(id) = typing.context.types.enumeration(base) {
                values(&id.get(), 0, out);
            }
        }
        _ => {}
    }
}

/// Members of a structure, or inputs and outputs of a block, with their types.
fn typed<'m>(
    semantics: &Semantics,
    members: impl Iterator<Item = (&'m str, Type)>,
    wanted: Option<&Wanted>,
    out: &mut Proposals<'_>,
) {
    for (name, ty) in members {
        let fits = wanted.map_or(Some(0), |wanted| rank(semantics, wanted, ty));
        let order = (fits.unwrap_or(u8::MAX), 0);
        out.word(
            order,
            CompletionKind::Member,
            name,
            &ty.to_string(),
            Topic::Nothing,
        );
    }
}

/// The values of an enumeration.
pub(super) fn values(enumeration: &Enumeration, fits: u8, out: &mut Proposals<'_>) {
    for (name, number) in &enumeration.values {
        let detail = format!("{}, {number}", enumeration.name);
        out.word((fits, 0), CompletionKind::Value, name, &detail, Topic::Nothing);
    }
}

/// Members that fit come first: 0, others 1.
fn fits(wanted: Option<&Wanted>, ty: Scalar) -> u8 {
    u8::from(wanted.is_some_and(|wanted| scalar_rank(wanted, ty).is_none()))
}

fn system(wanted: Option<&Wanted>, out: &mut Proposals<'_>) {
    for tag in SystemTag::ALL {
        let order = (fits(wanted, tag.ty()), 0);
        out.word(
            order,
            CompletionKind::Constant,
            tag.name(),
            tag.ty().name(),
            Topic::Words(tag.about()),
        );
    }
}

fn members(semantics: &Semantics, state: StateType, wanted: Option<&Wanted>, out: &mut Proposals<'_>) {
    for (index, (name, doc)) in MEMBERS.iter().enumerate() {
        if let Some(member) = state_member(state, name) {
            let order = (
                fits(wanted, member.ty(semantics)),
                u8::from(index >= SECOND_NAMES),
            );
            out.word(
                order,
                CompletionKind::Member,
                name,
                member.ty(semantics).name(),
                Topic::Words(doc),
            );
        }
    }
}

fn bits(ty: Scalar, out: &mut Proposals<'_>) {
    for bit in 0..ty.width() {
        let detail = format!("bit {bit} of {}", ty.width());
        out.word(
            (0, 0),
            CompletionKind::Member,
            &bit.to_string(),
            &detail,
            Topic::Nothing,
        );
    }
}
