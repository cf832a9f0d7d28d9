//! The types of undeclared tags (LANGUAGE §4): from the places they are in, tried in a fixed order.
//!
//! 1. a place that asks for one type gives it;
//! 2. a literal or tag written into it, or compared with it, that is a TIME, STRING, date or real gives its
//!    type (real: LREAL), as does being the result of a function on reals;
//! 3. DINT.

use crate::constant::{natural_type, signed_literal};
use crate::context::Context;
use crate::diagnostic::Diagnostic;
use crate::facts::{Node, NodeKind, Operator};
use crate::mistakes::type_mismatch;
use crate::network::{Formal, Meaning};
use crate::networks::BlockAt;
use crate::program::{Member, Role, SystemTag};
use crate::scope::{Origin, Scope, TagFacts, Use};
use crate::types::{Scalar, Type};
use ladder_instructions::{Accepts, Law, StateType, States, Timing, TypeClass};
use ladder_syntax::{Name, TextRange};

/// Gives every tag its type, and says whether its places alone have given it.
pub(crate) fn infer(context: &mut Context, out: &mut Vec<Diagnostic>) -> bool {
    let law = context.profile.law();
    by_place(context, out);
    let mut tags = context.scopes.iter().flat_map(|scope| &scope.tags);
    if tags.all(|tag| tag.ty.is_some()) {
        internal_unless_bool(context);
        return true;
    }
    by_company(context);
    for scope in &mut context.scopes {
        for tag in 0..scope.tags.len() {
            if scope.tags[tag].ty.is_none() {
                scope.tags[tag].ty = Some(Type::Scalar(Scalar::integer_of(law)));
            }
        }
    }
    internal_unless_bool(context);
    false
}

/// Only a BOOL without a declaration is an input or output.
fn internal_unless_bool(context: &mut Context) {
    for scope in &mut context.scopes {
        for tag in scope.declared..scope.tags.len() {
            if scope.tags[tag].origin == Origin::Undeclared && scope.tags[tag].ty != Some(Type::BOOL) {
                scope.tags[tag].role = Role::Internal;
            }
        }
    }
}

/// The one type that an operand's place asks for.
fn asked(context: &Context, bound: BlockAt<'_>, formal: Formal) -> Option<Type> {
    let law = context.profile.law();
    let counted = Type::Scalar(Scalar::integer_of(law));
    match formal {
        Formal::Operand(operand) => match operand.accepts {
            Accepts::Bool | Accepts::BoolOrRange => Some(Type::BOOL),
            Accepts::State(state) => Some(Type::State(state)),
            Accepts::Duration if matches!(law.timing, Timing::Ticks | Timing::Units) => Some(counted),
            Accepts::Duration | Accepts::Time => Some(Type::Scalar(Scalar::Time)),
            Accepts::Count => Some(counted),
            Accepts::String | Accepts::Result(TypeClass::String) => {
                Some(Type::Scalar(Scalar::String(crate::types::DEFAULT_STRING)))
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

/// Rule 1. Only the places of tags without a type have a say.
fn by_place(context: &mut Context, out: &mut Vec<Diagnostic>) {
    // Of each tag its first answer.
    let mut answers: Vec<(usize, usize, Type)> = Vec::new();
    for (scope, facts) in context.scopes.iter().enumerate() {
        for (index, tag) in facts.tags.iter().enumerate() {
            if tag.ty.is_none()
                && let Some(ty) = answer(context, tag, out)
            {
                answers.push((scope, index, ty));
            }
        }
    }
    for (scope, tag, ty) in answers {
        context.scopes[scope].tags[tag].ty = Some(ty);
    }
}

/// The type that a tag's places give it. One that is only in blocks that could not be read has neither places nor
/// company that say anything.
pub(crate) fn answer(context: &Context, tag: &TagFacts, out: &mut Vec<Diagnostic>) -> Option<Type> {
    let readable = |place: Use| !context.networks.at(place.network).block(place.block).faulty;
    let unread = || !context.uses(tag).any(readable);
    let unknown = Type::Scalar(Scalar::integer_of(context.profile.law()));
    asked_by_places(context, tag, out).or_else(|| unread().then_some(unknown))
}

fn asked_by_places(context: &Context, tag: &TagFacts, out: &mut Vec<Diagnostic>) -> Option<Type> {
    let mut first: Option<(Type, TextRange)> = None;
    // `(R)` also takes timers and counters: it makes a tag BOOL only where no other place has a say.
    let mut reset = false;
    for place in context.uses(tag) {
        let bound = context.networks.at(place.network).block(place.block);
        let value = &bound.facts.operands[place.operand].value;
        if bound.faulty || !matches!(value.kind, NodeKind::Name(_) | NodeKind::Address(_)) {
            continue;
        }
        let formal = bound.formals[place.operand];
        if matches!(formal, Formal::Operand(o) if o.accepts == Accepts::BoolRangeOrState) {
            reset = true;
            continue;
        }
        let Some(ty) = asked(context, bound, formal) else {
            continue;
        };
        match first {
            None => first = Some((ty, place.range)),
            Some((before, at)) if !agree(context.profile.law(), before, ty) && !tag.mistyped => {
                out.push(type_mismatch::two_answers(
                    &tag.name,
                    (before, at),
                    (ty, place.range),
                ));
            }
            Some(_) => {}
        }
    }
    first.map(|(ty, _)| ty).or(reset.then_some(Type::BOOL))
}

/// Whether a tag can be what two places ask for.
fn agree(law: &Law, first: Type, second: Type) -> bool {
    match (first, second) {
        (Type::State(first), Type::State(second)) if law.states == States::Shared => {
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
fn by_company(context: &mut Context) {
    let law = context.profile.law();
    let tags = context.scopes.iter().flat_map(|scope| &scope.tags);
    let mut blocks: Vec<(usize, usize)> = tags
        .filter(|tag| tag.ty.is_none())
        .flat_map(|tag| context.uses(tag).map(|place| (place.network, place.block)))
        .collect();
    blocks.sort_unstable();
    blocks.dedup();
    while !blocks.is_empty() {
        let mut found: Vec<(usize, usize, Scalar)> = Vec::new();
        for &(network, block) in &blocks {
            let network = context.networks.at(network);
            let scope = &context.scopes[network.scope];
            company(law, scope, network.block(block), |tag, ty| {
                found.push((network.scope, tag, ty));
            });
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

fn company(law: &Law, scope: &Scope, bound: BlockAt<'_>, mut give: impl FnMut(usize, Scalar)) {
    if bound.faulty {
        return;
    }
    let operands = || bound.facts.operands.iter().zip(bound.formals.iter());
    let type_among = |asked: fn(Accepts) -> bool| {
        operands()
            .filter(|(_, formal)| matches!(formal, Formal::Operand(o) if asked(o.accepts)))
            .find_map(|(other, _)| telling(law, scope, &other.value))
    };
    // All compared operands have one company: it is asked for once.
    let mut compared = None;
    for (operand, formal) in operands() {
        let Formal::Operand(row) = formal else { continue };
        if !matches!(row.accepts, Accepts::Result(_) | Accepts::Compared) {
            continue;
        }
        let Some(tag) = untyped(scope, &operand.value) else {
            continue;
        };
        let company = match row.accepts {
            Accepts::Result(TypeClass::Real) => Some(Scalar::real_of(law)),
            Accepts::Result(_) => {
                type_among(|accepts| matches!(accepts, Accepts::Value | Accepts::Expression))
            }
            _ => *compared.get_or_insert_with(|| type_among(|accepts| accepts == Accepts::Compared)),
        };
        if let Some(ty) = company {
            give(tag, ty);
        }
    }
}

/// The type that a value tells its company, if it is one that tells: TIME, STRING, a date, a real.
fn telling(law: &Law, scope: &Scope, node: &Node) -> Option<Scalar> {
    if let Some((literal, negative)) = signed_literal(node) {
        return literal
            .as_ref()
            .ok()
            .map(|l| natural_type(l, negative))
            .and_then(|ty| tells(law, ty));
    }
    match &node.kind {
        NodeKind::Name(_) | NodeKind::Address(_) | NodeKind::Member(..) | NodeKind::Index(..) => {
            node_type(law, scope, node).and_then(|ty| tells(law, ty))
        }
        NodeKind::Paren(inner) | NodeKind::Unary(_, inner) => telling(law, scope, inner),
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
        NodeKind::Binary(_, left, right) => telling(law, scope, left).or_else(|| telling(law, scope, right)),
        NodeKind::Call(_, arguments) => arguments
            .iter()
            .find_map(|argument| telling(law, scope, argument)),
        _ => None,
    }
}

fn tells(law: &Law, ty: Scalar) -> Option<Scalar> {
    match ty {
        Scalar::Real | Scalar::Lreal => Some(Scalar::real_of(law)),
        Scalar::String(_) => Some(Scalar::String(crate::types::DEFAULT_STRING)),
        Scalar::Time => Some(ty),
        ty if ty.is_date() => Some(ty),
        _ => None,
    }
}

/// The type of a place, as far as it is known.
fn node_type(law: &Law, scope: &Scope, node: &Node) -> Option<Scalar> {
    match &node.kind {
        NodeKind::Name(name) | NodeKind::Address(name) => scope.tags[scope.find(&Name::new(name))?]
            .ty
            .and_then(Type::scalar),
        NodeKind::Member(base, word) => {
            if let NodeKind::Name(name) = &base.kind {
                if name.eq_ignore_ascii_case("SYS") {
                    return SystemTag::from_name(&word.text).map(SystemTag::ty);
                }
                if let Some(Type::State(state)) = scope.tags[scope.find(&Name::new(name))?].ty {
                    return member(state, &word.text).map(|member| member.ty(law));
                }
            }
            Some(Scalar::Bool)
        }
        NodeKind::Index(base, _) => {
            let NodeKind::Name(name) = &base.kind else {
                return None;
            };
            match scope.tags[scope.find(&Name::new(name))?].ty? {
                Type::Array { element, .. } => Some(element),
                _ => None,
            }
        }
        _ => None,
    }
}

/// The member that a word behind the point of a state tag means (LANGUAGE §4, Members), if it has it.
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
