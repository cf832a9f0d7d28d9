//! The limits of `INT(0..100)`: which values a part of a tag is meant to have. Constants are checked by them, computed values are
//! not (LANGUAGE §4).

use super::named_types::NamedTypes;
use crate::findings::article::with_article;
use crate::values::literal::Literal;
use crate::values::types::Scalar;
use crate::written::constant::ConstantProblem;
use crate::written::facts::{Node, NodeKind, Operator};
use crate::written::type_spec::{Limits, SpecKind, TypeSpec};
use ladder_syntax::Name;
use std::sync::Arc;

/// A type with limits.
pub(crate) type Limited = (Scalar, Limits);

/// What a declaration says, and the file that it is in, if that is another one.
pub(super) type Said<'t> = (&'t TypeSpec, Option<&'t Arc<str>>);

/// Names of types that stand for each other may go in a circle: no more of them are followed.
const MOST_NAMES: usize = 50;

/// The declaration after all names that only stand for another one.
pub(super) fn resolved<'t>(types: &'t NamedTypes, mut told: Said<'t>) -> Option<Said<'t>> {
    for _ in 0..MOST_NAMES {
        match &told.0.kind {
            SpecKind::Named(name) => told = types.declaration(name, told.1)?,
            _ => return Some(told),
        }
    }
    None
}

/// What is reported of a member.
pub(super) fn member<'t>(types: &'t NamedTypes, told: Said<'t>, name: &str) -> Option<Said<'t>> {
    let (spec, file) = resolved(types, told)?;
    let SpecKind::Structure(members) = &spec.kind else {
        return None;
    };
    let key = Name::new(name);
    let found = members.iter().find(|member| Name::new(&member.name) == key)?;
    Some((&found.declared.spec, file))
}

/// What is reported of the elements.
pub(super) fn element<'t>(types: &'t NamedTypes, told: Said<'t>) -> Option<Said<'t>> {
    let (spec, file) = resolved(types, told)?;
    match &spec.kind {
        SpecKind::Array(_, element) => Some((element, file)),
        _ => None,
    }
}

pub(super) fn limits(types: &NamedTypes, told: Said<'_>) -> Option<Limited> {
    match resolved(types, told)?.0.kind {
        SpecKind::Subrange(scalar, limits) => Some((scalar, limits)),
        _ => None,
    }
}

/// What is wrong with a number in a place with limits.
pub(crate) fn message(number: i128, (scalar, (low, high)): Limited) -> Option<String> {
    let is_within = (low..=high).contains(&number);
    (!is_within).then(|| {
        format!(
            "{number} is none of the values {low}..{high} that {} here may have",
            with_article(scalar)
        )
    })
}

/// Checks the numbers of an initial value of the file's own, which fits its type.
// A value nests no deeper than it was parsed.
pub(super) fn check_initial(
    types: &NamedTypes,
    spec: &TypeSpec,
    node: &Node,
    out: &mut impl FnMut(ConstantProblem),
) {
    check_value(types, (spec, None), node, out);
}

fn check_value(types: &NamedTypes, told: Said<'_>, node: &Node, out: &mut impl FnMut(ConstantProblem)) {
    match &node.kind {
        NodeKind::Members(given) => {
            for (word, node) in given {
                if let Some(told) = member(types, told, &word.text) {
                    check_value(types, told, node, out);
                }
            }
        }
        NodeKind::Array(nodes) => {
            if let Some(told) = element(types, told) {
                nodes.iter().for_each(|node| check_value(types, told, node, out));
            }
        }
        NodeKind::Repeat(_, nodes) => nodes.iter().for_each(|node| check_value(types, told, node, out)),
        _ => {
            if let (Some(number), Some(limited)) = (number(node), limits(types, told))
                && let Some(message) = message(number, limited)
            {
                out(ConstantProblem::out_of_range(node.range, message));
            }
        }
    }
}

fn number(node: &Node) -> Option<i128> {
    match &node.kind {
        NodeKind::Unary(Operator::Sub, inner) => number(inner).map(|number| -number),
        NodeKind::Paren(inner) => number(inner),
        _ => match node.literal()? {
            Literal::Int(number) => Some(*number),
            Literal::Typed(_, inner) => match **inner {
                Literal::Int(number) => Some(number),
                _ => None,
            },
            _ => None,
        },
    }
}
