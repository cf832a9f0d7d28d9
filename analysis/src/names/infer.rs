//! The types of undeclared tags (LANGUAGE §4): from the places they are in, tried in a fixed order.
//!
//! 1. a place that asks for one type gives it;
//! 2. a literal or tag written into it, or compared with it, that is a TIME, STRING, date or real gives its
//!    type (real: LREAL), as does being the result of a function on reals;
//! 3. DINT.

use crate::cancel::Cancel;
use crate::names::context::Context;
use crate::names::named_types::NamedTypes;
use crate::names::path_type::path_type;
use crate::names::scope::{Entry, Origin, Scope, TagFacts};
use crate::networks::BlockAt;
use crate::networks::network::{Formal, Meaning};
use crate::networks::use_place::Use;
use crate::program::{Member, Role, SystemTag};
use crate::values::types::{Scalar, Type};
use crate::written::constant::{natural_type, signed_literal};
use crate::written::facts::{Node, NodeKind, Operator};
use ladder_instructions::{Accepts, Semantics, StateType, States, Timing, TypeClass};
use ladder_syntax::{Name, TextRange};

/// Infers the type of every tag. None if that is cancelled.
pub(crate) fn infer(context: &mut Context, cancel: &Cancel) -> Option<()> {
    let untyped = by_place(context, cancel)?;
    by_other_values(context, &untyped);
    let integer = Type::Scalar(Scalar::integer_of(context.profile.semantics()));
    for (scope, tag) in untyped {
        context.scopes[scope].tags[tag].ty.get_or_insert(integer);
    }
    internal_unless_value(context);
    Some(())
}

/// Of tags without a declaration only an elementary one is an input, and only a BOOL an output.
fn internal_unless_value(context: &mut Context) {
    for scope in &mut context.scopes {
        for tag in &mut scope.tags[scope.declared..] {
            let may_be = match tag.role {
                Role::Input => matches!(tag.ty, Some(Type::Scalar(_))),
                Role::Output => tag.ty == Some(Type::BOOL),
                Role::Internal => true,
            };
            if tag.origin == Origin::Undeclared && !may_be {
                tag.role = Role::Internal;
            }
        }
    }
}

/// The one type that an operand's place asks for.
fn asked(context: &Context, bound: BlockAt<'_>, formal: Formal) -> Option<Type> {
    let semantics = context.profile.semantics();
    let counted = Type::Scalar(Scalar::integer_of(semantics));
    match formal {
        Formal::Operand(operand) => match operand.accepts {
            Accepts::Bool | Accepts::BoolOrRange => Some(Type::BOOL),
            Accepts::State(state) => Some(Type::State(state)),
            Accepts::Duration if matches!(semantics.timing, Timing::Ticks | Timing::Units) => Some(counted),
            Accepts::Duration | Accepts::Time => Some(Type::Scalar(Scalar::Time)),
            Accepts::Count => Some(counted),
            Accepts::String | Accepts::Result(TypeClass::String) => {
                Some(Type::Scalar(Scalar::String(crate::values::types::DEFAULT_STRING)))
            }
            _ => None,
        },
        Formal::Parameter(index) => {
            let Meaning::User(block) = bound.meaning else {
                return None;
            };
            context.user_blocks[block].parameters[index].ty
        }
        _ => None,
    }
}

/// Rule 1. Only the places of tags without a type count. Returns the tags that have none after it; nothing if that is not
/// cancelled.
fn by_place(context: &mut Context, cancel: &Cancel) -> Option<Vec<Entry>> {
    let mut answers: Vec<(Entry, Type)> = Vec::new();
    let mut untyped: Vec<Entry> = Vec::new();
    for (scope, facts) in context.scopes.iter().enumerate() {
        for (index, tag) in facts.unusual() {
            if tag.ty.is_none() {
                cancel.one_more()?;
                match answer(context, tag) {
                    Some(ty) => answers.push(((scope, index), ty)),
                    None => untyped.push((scope, index)),
                }
            }
        }
    }
    for ((scope, tag), ty) in answers {
        context.scopes[scope].tags[tag].ty = Some(ty);
    }
    Some(untyped)
}

/// The type that a tag's places give it. One that is only in blocks that could not be read has neither places nor
/// other values that give one.
fn answer(context: &Context, tag: &TagFacts) -> Option<Type> {
    let readable = |place: Use| !context.networks.at(place.network).block(place.block).faulty;
    let unread = || !context.uses(tag).any(readable);
    let unknown = Type::Scalar(Scalar::integer_of(context.profile.semantics()));
    let asked = asked_by_places(context, tag).next().map(|(ty, _)| ty);
    asked
        .or_else(|| is_reset(context, tag).then_some(Type::BOOL))
        .or_else(|| unread().then_some(unknown))
}

/// The places of a tag that ask for one type, with that type.
fn asked_by_places<'c>(
    context: &'c Context,
    tag: &'c TagFacts,
) -> impl Iterator<Item = (Type, TextRange)> + use<'c> {
    let whole = whole_operands(context, tag);
    whole.filter_map(|(bound, formal, at)| Some((asked(context, bound, formal)?, at)))
}

/// `(R)` also takes timers and counters: it makes a tag BOOL only where no other place has a say.
fn is_reset(context: &Context, tag: &TagFacts) -> bool {
    whole_operands(context, tag)
        .any(|(_, formal, _)| matches!(formal, Formal::Operand(o) if o.accepts == Accepts::BoolRangeOrState))
}

/// The places where a tag is an operand, and not a part of one, in blocks that could be read.
fn whole_operands<'c>(
    context: &'c Context,
    tag: &'c TagFacts,
) -> impl Iterator<Item = (BlockAt<'c>, Formal, TextRange)> + use<'c> {
    context.uses(tag).filter_map(|place| {
        let bound = context.networks.at(place.network).block(place.block);
        let value = &bound.facts.operands[place.operand].value;
        let is_whole = !bound.faulty && matches!(value.kind, NodeKind::Name(_) | NodeKind::Address(_));
        is_whole.then(|| (bound, bound.formals[place.operand], place.range))
    })
}

/// The first place of an undeclared tag that asks for a type, and each of those that ask for another one.
pub(crate) fn disagreeing(context: &Context, tag: &TagFacts) -> Vec<((Type, TextRange), (Type, TextRange))> {
    let mut asked = asked_by_places(context, tag);
    let Some(first) = asked.next() else {
        return Vec::new();
    };
    let semantics = context.profile.semantics();
    let others = asked.filter(|(ty, _)| !agree(semantics, first.0, *ty));
    others.map(|other| (first, other)).collect()
}

/// Whether a tag can be what two places ask for.
fn agree(semantics: &Semantics, first: Type, second: Type) -> bool {
    match (first, second) {
        (Type::State(first), Type::State(second)) if semantics.states == States::Shared => {
            first.is_of_one_sort_with(second)
        }
        _ => first == second,
    }
}

/// The tag that an operand names as a whole, if its type is not known yet.
fn untyped(scope: &Scope, node: &Node) -> Option<usize> {
    let (NodeKind::Name(name) | NodeKind::Address(name)) = &node.kind else {
        return None;
    };
    let tag = scope.find(&Name::new(name))?;
    scope.tags[tag].ty.is_none().then_some(tag)
}

/// Rule 2, until no type changes: a type that is found here may give another. After the first round only blocks
/// that name a tag whose type has just been found can say more.
fn by_other_values(context: &mut Context, untyped: &[Entry]) {
    let semantics = context.profile.semantics();
    let tags = untyped
        .iter()
        .map(|&(scope, tag)| &context.scopes[scope].tags[tag]);
    let mut blocks: Vec<(usize, usize)> = tags
        .flat_map(|tag| context.uses(tag).map(|place| (place.network, place.block)))
        .collect();
    blocks.sort_unstable();
    blocks.dedup();
    while !blocks.is_empty() {
        let mut found: Vec<(usize, usize, Scalar)> = Vec::new();
        for &(network, block) in &blocks {
            let network = context.networks.at(network);
            let scope = &context.scopes[network.scope];
            of_block(
                (semantics, &context.types),
                scope,
                network.block(block),
                |tag, ty| {
                    found.push((network.scope, tag, ty));
                },
            );
        }
        blocks.clear();
        for (scope, tag, ty) in found {
            let facts = &mut context.scopes[scope].tags[tag];
            if facts.ty.is_none() {
                facts.ty = Some(Type::Scalar(ty));
                let uses = context.uses(&context.scopes[scope].tags[tag]);
                blocks.extend(uses.map(|place| (place.network, place.block)));
            }
        }
        blocks.sort_unstable();
        blocks.dedup();
    }
}

/// The types that the operands of a block give each other.
fn of_block(
    (semantics, types): (&Semantics, &NamedTypes),
    scope: &Scope,
    bound: BlockAt<'_>,
    mut give: impl FnMut(usize, Scalar),
) {
    if bound.faulty {
        return;
    }
    let operands = || bound.facts.operands.iter().zip(bound.formals.iter());
    let type_among = |asked: fn(Accepts) -> bool| {
        operands()
            .filter(|(_, formal)| matches!(formal, Formal::Operand(o) if asked(o.accepts)))
            .find_map(|(other, _)| {
                let value = &other.value;
                let named = value_named_with_type(types, scope, value);
                named.or_else(|| type_given_by(semantics, scope, value))
            })
    };
    // All compared operands are compared with the same values: those are asked once.
    let mut compared = None;
    for (operand, formal) in operands() {
        let Formal::Operand(row) = formal else { continue };
        if !matches!(row.accepts, Accepts::Result(_) | Accepts::Compared) {
            continue;
        }
        let Some(tag) = untyped(scope, &operand.value) else {
            continue;
        };
        let given = match row.accepts {
            Accepts::Result(TypeClass::Real) => Some(Scalar::real_of(semantics)),
            Accepts::Result(_) => {
                type_among(|accepts| matches!(accepts, Accepts::Value | Accepts::Expression))
            }
            _ => *compared.get_or_insert_with(|| type_among(|accepts| accepts == Accepts::Compared)),
        };
        if let Some(ty) = given {
            give(tag, ty);
        }
    }
}

/// The enumeration of a value that is named with its type, as in `Phase.IDLE`.
fn value_named_with_type(types: &NamedTypes, scope: &Scope, node: &Node) -> Option<Scalar> {
    let NodeKind::Member(base, _) = &node.kind else {
        return None;
    };
    let name = base
        .name()
        .filter(|name| scope.find(&Name::new(name)).is_none())?;
    types.enumeration(name).map(Scalar::Enum)
}

/// The type that a value gives the others of its block, if it gives one: TIME, STRING, a date, a real.
fn type_given_by(semantics: &Semantics, scope: &Scope, node: &Node) -> Option<Scalar> {
    if let Some((literal, negative)) = signed_literal(node) {
        return literal
            .as_ref()
            .ok()
            .map(|l| natural_type(l, negative))
            .and_then(|ty| given_type(semantics, ty));
    }
    match &node.kind {
        NodeKind::Name(_) | NodeKind::Address(_) | NodeKind::Member(..) | NodeKind::Index(..) => {
            node_type(semantics, scope, node).and_then(|ty| given_type(semantics, ty))
        }
        NodeKind::Paren(inner) | NodeKind::Unary(_, inner) => type_given_by(semantics, scope, inner),
        // A comparison gives BOOL, whatever it compares.
        NodeKind::Binary(
            Operator::Equal
            | Operator::NotEqual
            | Operator::Less
            | Operator::LessEqual
            | Operator::Greater
            | Operator::GreaterEqual,
            ..,
        ) => None,
        NodeKind::Binary(_, left, right) => {
            type_given_by(semantics, scope, left).or_else(|| type_given_by(semantics, scope, right))
        }
        NodeKind::Call(_, arguments) => arguments
            .iter()
            .find_map(|argument| type_given_by(semantics, scope, argument)),
        _ => None,
    }
}

fn given_type(semantics: &Semantics, ty: Scalar) -> Option<Scalar> {
    match ty {
        Scalar::Real | Scalar::Lreal => Some(Scalar::real_of(semantics)),
        Scalar::String(_) => Some(Scalar::String(crate::values::types::DEFAULT_STRING)),
        Scalar::Time => Some(ty),
        ty if ty.is_date() || ty.is_enumeration() => Some(ty),
        _ => None,
    }
}

/// The type of a place, as far as it is known.
fn node_type(semantics: &Semantics, scope: &Scope, node: &Node) -> Option<Scalar> {
    if let NodeKind::Member(base, word) = &node.kind
        && base.name().is_some_and(|name| name.eq_ignore_ascii_case("SYS"))
    {
        return SystemTag::from_name(&word.text).map(SystemTag::ty);
    }
    let (ty, _) = path_type(node, semantics, &mut |root: &Node| {
        scope.tags[scope.find(&Name::new(root.name()?))?].ty
    })?;
    ty.scalar()
}

/// The member that a word after the point of a state tag means (LANGUAGE §4, Members), if it has it.
pub fn member(state: StateType, word: &str) -> Option<Member> {
    let upper = word.to_ascii_uppercase();
    if state.is_timer() {
        return Some(match upper.as_str() {
            "IN" | "EN" => Member::In,
            "PT" | "PRE" => Member::Pt,
            "Q" | "DN" => Member::Q,
            "ET" | "AC" | "ACC" => Member::Et,
            "R" => Member::R,
            "TT" => Member::Timing,
            _ => return None,
        });
    }
    if state.is_counter() {
        return Some(match upper.as_str() {
            "CU" | "EN" => Member::Cu,
            "CD" => Member::Cd,
            "R" => Member::R,
            "LD" => Member::Ld,
            "PV" | "PRE" => Member::Pv,
            "CV" | "AC" | "ACC" => Member::Cv,
            "Q" | "DN" => Member::Q,
            "QU" if state == StateType::Ctud => Member::Qu,
            "QD" if state == StateType::Ctud => Member::Qd,
            "CC" => Member::Changed,
            _ => return None,
        });
    }
    match upper.as_str() {
        "Q1" => Some(Member::Q1),
        _ => None,
    }
}
