//! The limits of `INT(0..100)`: which values a part of a tag is meant to have. Constants are checked by them, computed values are
//! not (LANGUAGE §4).

use super::named_types::NamedTypes;
use super::type_spec::{Limits, SpecKind, TypeSpec};
use crate::context::Context;
use crate::findings::article::with_article;
use crate::names::operand_value::tag;
use crate::networks::facts::{Node, NodeKind, Operator};
use crate::values::constant::ConstantProblem;
use crate::values::literal::Literal;
use crate::values::types::Scalar;
use ladder_syntax::Name;
use std::sync::Arc;

/// A type with limits.
pub(crate) type Limited = (Scalar, Limits);

/// What a declaration says, and the file that it is in, if that is another one.
type Said<'t> = (&'t TypeSpec, Option<&'t Arc<str>>);

/// Names of types lead to each other no more often than this: they may go in a circle.
const MOST_NAMES: usize = 50;

/// The declaration after all names that only lead to another one.
fn behind_names<'t>(types: &'t NamedTypes, mut said: Said<'t>) -> Option<Said<'t>> {
    for _ in 0..MOST_NAMES {
        match &said.0.kind {
            SpecKind::Named(name) => said = types.declaration(name, said.1)?,
            _ => return Some(said),
        }
    }
    None
}

/// What is said of a member.
fn member<'t>(types: &'t NamedTypes, said: Said<'t>, name: &str) -> Option<Said<'t>> {
    let (spec, file) = behind_names(types, said)?;
    let SpecKind::Structure(members) = &spec.kind else {
        return None;
    };
    let key = Name::new(name);
    let found = members.iter().find(|member| Name::new(&member.name) == key)?;
    Some((&found.declared.spec, file))
}

/// What is said of the elements.
fn element<'t>(types: &'t NamedTypes, said: Said<'t>) -> Option<Said<'t>> {
    let (spec, file) = behind_names(types, said)?;
    match &spec.kind {
        SpecKind::Array(_, element) => Some((element, file)),
        _ => None,
    }
}

fn limits(types: &NamedTypes, said: Said<'_>) -> Option<Limited> {
    match behind_names(types, said)?.0.kind {
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

impl Context {
    /// The limits of what a path of a scope means.
    pub(crate) fn limits(&self, scope: usize, path: &Node) -> Option<Limited> {
        limits(&self.types, self.said(scope, path)?.0)
    }

    /// The limits that the declaration of a parameter says.
    pub(crate) fn limits_of<'c>(&'c self, spec: &'c TypeSpec, file: Option<&'c Arc<str>>) -> Option<Limited> {
        limits(&self.types, (spec, file))
    }

    /// What is said of a path, and how many dimensions of an array are open in it.
    fn said<'c>(&'c self, scope: usize, path: &Node) -> Option<(Said<'c>, usize)> {
        let types = &self.types;
        match &path.kind {
            NodeKind::Name(name) => {
                let (_, facts) = tag(self, scope, name)?;
                let declared = facts.cold.declared.as_deref()?;
                Some(((&declared.spec, facts.cold.foreign.as_ref()), 0))
            }
            NodeKind::Paren(inner) => self.said(scope, inner),
            NodeKind::Member(base, word) => {
                let (said, open) = self.said(scope, base)?;
                (open == 0).then_some((member(types, said, &word.text)?, 0))
            }
            NodeKind::Index(base, _) => {
                let (said, open) = self.said(scope, base)?;
                let SpecKind::Array(dimensions, _) = &behind_names(types, said)?.0.kind else {
                    return None;
                };
                if open + 1 < dimensions.len() {
                    return Some((said, open + 1));
                }
                Some((element(types, said)?, 0))
            }
            NodeKind::Range(base, ..) => Some((element(types, self.said(scope, base)?.0)?, 0)),
            _ => None,
        }
    }
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

fn check_value(types: &NamedTypes, said: Said<'_>, node: &Node, out: &mut impl FnMut(ConstantProblem)) {
    match &node.kind {
        NodeKind::Members(given) => {
            for (word, node) in given {
                if let Some(said) = member(types, said, &word.text) {
                    check_value(types, said, node, out);
                }
            }
        }
        NodeKind::Array(nodes) => {
            if let Some(said) = element(types, said) {
                nodes.iter().for_each(|node| check_value(types, said, node, out));
            }
        }
        NodeKind::Repeat(_, nodes) => nodes.iter().for_each(|node| check_value(types, said, node, out)),
        _ => {
            if let (Some(number), Some(limited)) = (number(node), limits(types, said))
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
