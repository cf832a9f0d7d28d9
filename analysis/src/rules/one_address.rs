//! `duplicate-declaration`: two names of one direct address do not agree on what it holds.

use crate::findings::diagnostic::Diagnostic;
use crate::names::context::Context;
use crate::names::scope::TagFacts;
use crate::program::Tag;
use crate::values::types::{Scalar, Type};
use crate::values::value::{Value, wrap};
use ladder_syntax::Name;
use rustc_hash::FxHashMap;

/// Looks at the tags that have an address.
pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let mut together: FxHashMap<Name, Names<'_>> = FxHashMap::default();
    // What is declared says more of an address than the address itself.
    let (declared, others): (Vec<&TagFacts>, Vec<&TagFacts>) =
        context.addressed().partition(|tag| tag.is_declared());
    for tag in declared.into_iter().chain(others).filter(|tag| !tag.mistyped) {
        let Some(address) = tag.cold.address.as_deref() else {
            continue;
        };
        let Some(names) = together.get_mut(&Name::new(address)) else {
            let names = Names {
                first: tag,
                with_value: tag,
            };
            together.insert(Name::new(address), names);
            continue;
        };
        let all = [names.first, names.with_value].into_iter();
        let mut found = all.filter_map(|first| otherwise(context, first, tag, address));
        if let Some(found) = found.next() {
            out.push(found);
        } else if names.with_value.cold.initial.is_empty() {
            names.with_value = tag;
        }
    }
}

/// The names of an address above one.
struct Names<'c> {
    first: &'c TagFacts,
    /// The first that says what it starts with, if one does.
    with_value: &'c TagFacts,
}

fn otherwise(context: &Context, first: &TagFacts, second: &TagFacts, address: &str) -> Option<Diagnostic> {
    let mut told = Said::from(second);
    if !second.is_declared() && second.uses.writers().next().is_none() {
        // It is only read: what is CONSTANT may be.
        told.constant = first.constant;
    }
    let message = disagreement(first.into(), told, address)?;
    let found = Diagnostic::new(
        super::duplicate_declaration::RULE,
        context.place_of(second),
        message,
    )
    .help(HELP);
    Some(found.related(
        context.place_of(first),
        format!("`{}` is declared here", first.name),
    ))
}

/// What one name says of its address.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Said<'t> {
    pub(crate) name: &'t str,
    pub(crate) ty: Option<Type>,
    pub(crate) constant: bool,
    pub(crate) initial: &'t [Value],
}

impl<'t> From<&'t TagFacts> for Said<'t> {
    fn from(tag: &'t TagFacts) -> Self {
        Said {
            name: &tag.name,
            ty: tag.ty,
            constant: tag.constant,
            initial: &tag.cold.initial,
        }
    }
}

impl<'t> From<&'t Tag> for Said<'t> {
    fn from(tag: &'t Tag) -> Self {
        Said {
            name: &tag.name,
            ty: Some(tag.ty),
            constant: tag.constant,
            initial: &tag.initial,
        }
    }
}

/// Whether a value of one type is one of the other with the same bits: integers and bit strings of one width.
pub(crate) fn has_same_bits(one: Type, other: Type) -> bool {
    let (Some(one), Some(other)) = (one.scalar(), other.scalar()) else {
        return one == other;
    };
    let is_whole = |ty: Scalar| ty.is_bits() || ty.is_integer();
    one == other || (is_whole(one) && is_whole(other) && one.width() == other.width())
}

/// Initial values in another type with the same bits.
pub(crate) fn with_same_bits(initial: &[Value], ty: Type) -> Vec<Value> {
    let value = |value: &Value| match (value, ty.scalar()) {
        (Value::Int(number), Some(ty)) => Value::Int(wrap(*number, ty)),
        _ => value.clone(),
    };
    initial.iter().map(value).collect()
}

/// What the second of two names of an address says otherwise than the first. None if they agree, as they do where one of
/// them says nothing of it.
pub(crate) fn disagreement(first: Said<'_>, second: Said<'_>, address: &str) -> Option<String> {
    let (one, other) = (first.name, second.name);
    let (Some(ty), Some(other_ty)) = (first.ty, second.ty) else {
        return None;
    };
    if !has_same_bits(ty, other_ty) {
        return Some(if other.eq_ignore_ascii_case(address) {
            format!("`{other}` is {other_ty} here, and `{one}` at this address is {ty}")
        } else {
            format!("`{other}` is {other_ty}, and `{one}` at the same address {address} is {ty}")
        });
    }
    let begins = |initial: &[Value]| with_same_bits(initial, ty);
    if !first.initial.is_empty()
        && !second.initial.is_empty()
        && begins(first.initial) != begins(second.initial)
    {
        return Some(format!(
            "`{other}` starts with another value than `{one}` at the same address {address}"
        ));
    }
    let (constant, tag) = match (first.constant, second.constant) {
        (true, false) => (one, other),
        (false, true) => (other, one),
        _ => return None,
    };
    Some(format!(
        "`{constant}` is CONSTANT, and `{tag}` at the same address {address} is not"
    ))
}

/// What to do about it.
pub(crate) const HELP: &str =
    "an address is one tag, whatever its names: they agree in type, initial value and CONSTANT";
