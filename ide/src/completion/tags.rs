//! Tags, by the type and the direction that the operand needs.

use super::item::{CompletionKind, Topic};
use super::likeness::Likeness;
use super::proposals::{MOST, Order, Proposals};
use crate::typing::{Operand, Typing};
use crate::wanted::{Kind, Wanted, rank, scalar_rank};
use itertools::Itertools;
use ladder_analysis::names::scope::{Origin, SectionKind, TagFacts};
use ladder_analysis::program::Access;
use ladder_analysis::program::{Role, SystemTag};
use ladder_analysis::values::types::{Scalar, Type};
use ladder_instructions::Semantics;
use ladder_syntax::Name;

/// Inputs come last where something is written: the outside writes them.
const INPUTS: u8 = 4;
/// After the tags that fit as they are, those that pass, and those of which a member fits.
const SYSTEM: u8 = 4;
/// Literals are after everything that has a name,
const LITERALS: u8 = 5;
/// and a timer, counter or bistable after all that its own block may get.
const ITSELF: u8 = 6;
/// A duration is written out more often than it is a count of milliseconds or a member of another timer.
const WRITTEN: (u8, u8) = (0, 9);

/// A tag, how its name is like what is written, how well it fits, and what else speaks for it.
type Ranked<'c> = (&'c TagFacts, (Likeness, Order));

pub(super) fn propose(typing: &Typing<'_>, operand: &Operand, wanted: &Wanted, out: &mut Proposals<'_>) {
    // What is in the list already is less likely meant.
    let given = |tag: &TagFacts| {
        let mut before = operand
            .before
            .iter()
            .map(|range| typing.text[range.clone()].trim());
        before.any(|text| text.eq_ignore_ascii_case(&tag.name))
    };
    let scope = &typing.context.scopes[typing.scope];
    let semantics = typing.context.profile.semantics();
    let ranked = |tag| {
        let known = typing.context.shared(tag);
        if is_being_written(typing, tag) || known.constant && wanted.writes {
            return None;
        }
        let given = given(known);
        let fits = match rank(semantics, wanted, known.ty?)? {
            _ if wanted.writes && known.role == Role::Input => INPUTS,
            _ if given && matches!(known.ty, Some(Type::State(_))) => ITSELF,
            fits => fits,
        };
        let second = if given { 3 } else { second_thought(known, wanted) };
        Some((known, (fits, second)))
    };
    // A large program has more tags than anybody reads. One more than is shown says that there are others.
    let tags = best(&scope.tags, MOST + 1, |tag, enough_begin| {
        let likeness = out.likeness(&tag.name)?;
        if enough_begin && likeness > Likeness::Beginning {
            return None;
        }
        let (tag, order) = ranked(tag)?;
        Some((tag, (likeness, order)))
    });
    for (tag, (_, order)) in tags {
        propose_tag(typing, tag, order, out);
    }
    globals(typing, wanted, out);
    if wanted.reads && !wanted.writes {
        system(wanted, out);
        literals(wanted, out);
    }
}

/// Tags that keep the state of a user-defined block, or that have parts that do.
///
/// Those that fit what is `wanted` otherwise are proposed for that.
pub(super) fn states(typing: &Typing<'_>, block: &str, wanted: Option<&Wanted>, out: &mut Proposals<'_>) {
    let key = Name::new(block);
    let is_state = |ty: Type| match ty {
        Type::Compound(id) => id.block().is_some_and(|block| Name::new(&block) == key),
        _ => false,
    };
    let tags = typing.context.scopes[typing.scope].tags.iter();
    for tag in tags.map(|tag| typing.context.shared(tag)) {
        let Some(ty) = tag.ty.filter(|ty| ty.keeps_state()) else {
            continue;
        };
        let semantics = typing.context.profile.semantics();
        if wanted.is_some_and(|wanted| rank(semantics, wanted, ty).is_some()) {
            continue;
        }
        let fits = match () {
            () if is_state(ty) => 0,
            () if ty.column_list().iter().any(|column| is_state(column.ty)) => 2,
            () => continue,
        };
        propose_tag(typing, tag, (fits, 0), out);
    }
}

/// This many of the tags that have a rank, in their order. `ranked` is asked with whether there are as many that begin as is
/// written: then no others are needed.
fn best<'c>(
    tags: &'c [TagFacts],
    most: usize,
    ranked: impl Fn(&'c TagFacts, bool) -> Option<Ranked<'c>>,
) -> Vec<Ranked<'c>> {
    let order =
        |(a, rank): &Ranked<'_>, (b, other): &Ranked<'_>| rank.cmp(other).then_with(|| a.name.cmp(&b.name));
    let mut begin = 0;
    let ranked = tags.iter().filter_map(|tag| {
        let found = ranked(tag, begin >= most)?;
        let (_, (likeness, _)) = found;
        begin += usize::from(likeness <= Likeness::Beginning);
        Some(found)
    });
    ranked.k_smallest_by(most, order).collect()
}

/// Whether all that is known of a tag is the half of a name that is at the cursor.
fn is_being_written(typing: &Typing<'_>, tag: &TagFacts) -> bool {
    // Asked of each tag that begins so: where places are is looked up for none of another length.
    if tag.origin != Origin::Undeclared || tag.name.len() != typing.word.len() {
        return false;
    }
    let word = typing.absolute(typing.word.clone());
    typing.context.uses(tag).all(|place| place.range == word)
}

/// Outputs first for what is written; a timer that has its block is unlikely to get another.
fn second_thought(tag: &TagFacts, wanted: &Wanted) -> u8 {
    let owned = matches!(wanted.kind, Kind::State(_))
        && tag.uses.accesses().any(|access| access == Access::ReadWrite);
    match tag.role {
        _ if owned => 2,
        Role::Output if wanted.writes => 0,
        Role::Internal if wanted.writes => 1,
        _ if tag.origin == Origin::Implicit => 2,
        // What is declared is meant to be used.
        _ if tag.origin == Origin::Undeclared => 1,
        _ => 0,
    }
}

fn propose_tag(typing: &Typing<'_>, tag: &TagFacts, order: Order, out: &mut Proposals<'_>) {
    let ty = tag.ty.map(|ty| ty.to_string()).unwrap_or_default();
    let from = match tag.origin {
        Origin::Declared(section) if tag.constant => format!("{ty}, {} CONSTANT", section.keyword()),
        Origin::Declared(section) => format!("{ty}, {}", section.keyword()),
        _ => ty,
    };
    let kind = if tag.constant {
        CompletionKind::Constant
    } else {
        CompletionKind::Tag
    };
    out.word(
        order,
        kind,
        &tag.name,
        &from,
        Topic::Tag(typing.scope, tag.name.to_string()),
    );
}

/// VAR_GLOBAL tags of other files that this one does not use yet.
fn globals(typing: &Typing<'_>, wanted: &Wanted, out: &mut Proposals<'_>) {
    let scope = &typing.context.scopes[typing.scope];
    for (file, global) in typing.context.others.all_globals() {
        let known = scope
            .find(&Name::new(&global.name))
            .is_some_and(|tag| !is_being_written(typing, &scope.tags[tag]));
        let Some(fits) = global
            .ty
            .and_then(|ty| rank(typing.context.profile.semantics(), wanted, ty))
        else {
            continue;
        };
        if known || global.constant && wanted.writes || out.likeness(&global.name).is_none() {
            continue;
        }
        let ty = global.ty.map(|ty| ty.to_string()).unwrap_or_default();
        let detail = format!("{ty}, {} in {}", SectionKind::Global.keyword(), file.file);
        out.word(
            (fits, 2),
            CompletionKind::Tag,
            &global.name,
            &detail,
            Topic::Nothing,
        );
    }
}

fn system(wanted: &Wanted, out: &mut Proposals<'_>) {
    for tag in SystemTag::ALL {
        let ty = tag.ty();
        let fits = match wanted.kind {
            Kind::Duration => ty == Scalar::Time,
            _ => rank(&Semantics::IEC, wanted, Type::Scalar(ty)).is_some_and(|fits| fits < 2),
        };
        if fits {
            let label = format!("SYS.{}", tag.name());
            out.word(
                (SYSTEM, 0),
                CompletionKind::Constant,
                &label,
                ty.name(),
                Topic::Words(tag.about()),
            );
        }
    }
}

fn literals(wanted: &Wanted, out: &mut Proposals<'_>) {
    let value = |out: &mut Proposals<'_>, order: (u8, u8), text: &str, words: &'static str| {
        out.word(order, CompletionKind::Value, text, "literal", Topic::Words(words));
    };
    if let Kind::To(Scalar::Enum(id)) | Kind::With(Scalar::Enum(id)) = wanted.kind
        && wanted.reads
    {
        super::members::values(&id.get(), 0, out);
    }
    // A contact on TRUE is a wire; where a value is asked for, both are at home.
    let bool_value = matches!(wanted.kind, Kind::To(Scalar::Bool) | Kind::With(Scalar::Bool));
    if bool_value || wanted.expression && scalar_rank(wanted, Scalar::Bool).is_some() {
        value(out, (LITERALS, 0), "TRUE", "High.");
        value(out, (LITERALS, 0), "FALSE", "Low.");
    }
    let time = matches!(
        wanted.kind,
        Kind::Duration | Kind::To(Scalar::Time) | Kind::With(Scalar::Time)
    );
    if time {
        let order = if wanted.kind == Kind::Duration {
            WRITTEN
        } else {
            (LITERALS, 0)
        };
        value(out, order, "T#1s", "A duration: T#250ms, T#5s, T#1h30m.");
    }
}
