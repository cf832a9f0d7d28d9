//! What is known of an operand's value and type without running the program: literals, constants, declared types.

use crate::names::context::Context;
use crate::names::scope::TagFacts;
use crate::values::literal::Literal;
use crate::values::types::{Scalar, Type};
use crate::values::value::Value;
use crate::written::facts::{Node, NodeKind, Operator};
use ladder_syntax::Name;

/// A number that is in the text.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Number {
    /// A whole number, or a duration or date in nanoseconds.
    Int(i128),
    Real(f64),
}

impl Number {
    /// As a real.
    pub(crate) fn real(self) -> f64 {
        match self {
            Number::Int(n) => n as f64,
            Number::Real(r) => r,
        }
    }

    pub(crate) fn is_zero(self) -> bool {
        match self {
            Number::Int(n) => n == 0,
            Number::Real(r) => r == 0.0,
        }
    }
}

/// The tag of a name in a scope, or the one that it leads to.
pub(crate) fn tag<'c>(
    context: &'c Context,
    scope: usize,
    name: &str,
) -> Option<((usize, usize), &'c TagFacts)> {
    let index = context.scopes[scope].find(&Name::new(name))?;
    let facts = &context.scopes[scope].tags[index];
    let place = context.alias_of(facts).unwrap_or((scope, index));
    Some((place, &context.scopes[place.0].tags[place.1]))
}

/// The number that a node is: a literal, one after a minus, or a constant of the program.
pub(crate) fn number(context: &Context, scope: usize, node: &Node) -> Option<Number> {
    match &node.kind {
        NodeKind::Literal(_) => of_literal(node.literal()?),
        NodeKind::Paren(inner) => number(context, scope, inner),
        NodeKind::Unary(Operator::Sub, inner) => Some(match number(context, scope, inner)? {
            Number::Int(n) => Number::Int(-n),
            Number::Real(r) => Number::Real(-r),
        }),
        NodeKind::Name(name) => {
            let (_, facts) = tag(context, scope, name)?;
            match &*facts.cold.initial {
                [Value::Int(n)] if facts.constant => match facts.ty {
                    Some(Type::Scalar(Scalar::Ulint | Scalar::Lword)) => {
                        Some(Number::Int(i128::from(*n as u64)))
                    }
                    _ => Some(Number::Int(i128::from(*n))),
                },
                [Value::Real(r)] if facts.constant => Some(Number::Real(*r)),
                _ => None,
            }
        }
        _ => None,
    }
}

fn of_literal(literal: &Literal) -> Option<Number> {
    Some(match literal {
        Literal::Int(n) => Number::Int(*n),
        Literal::Real(r) => Number::Real(*r),
        Literal::Time(n) | Literal::Date(n) | Literal::Tod(n) | Literal::Dt(n) => Number::Int(i128::from(*n)),
        Literal::Typed(_, inner) => return of_literal(inner),
        Literal::Bool(_) | Literal::Text(_) => return None,
    })
}

/// The type of a tag as a whole, or of an array's element.
pub(crate) fn scalar(context: &Context, scope: usize, node: &Node) -> Option<Scalar> {
    let name = match &node.kind {
        NodeKind::Name(name) | NodeKind::Address(name) => name,
        NodeKind::Index(base, _) => match &base.kind {
            NodeKind::Name(name) => name,
            _ => return None,
        },
        NodeKind::Paren(inner) => return scalar(context, scope, inner),
        _ => return None,
    };
    match tag(context, scope, name)?.1.ty? {
        Type::Scalar(scalar) => Some(scalar),
        Type::Array { element, .. } => Some(element),
        Type::State(_) | Type::Compound(_) => None,
    }
}

/// Whether a node is a real number as far as the text says: such a literal, or a tag declared so.
pub(crate) fn is_real(context: &Context, scope: usize, node: &Node) -> bool {
    match &node.kind {
        NodeKind::Literal(_) => matches!(number(context, scope, node), Some(Number::Real(_))),
        NodeKind::Unary(_, inner) | NodeKind::Paren(inner) => is_real(context, scope, inner),
        NodeKind::Binary(operator, left, right) => {
            use Operator::*;
            matches!(operator, Add | Sub | Mul | Div | Mod | Power)
                && (is_real(context, scope, left) || is_real(context, scope, right))
        }
        _ => scalar(context, scope, node).is_some_and(Scalar::is_real),
    }
}

/// Every node of an expression, the outer ones first.
pub(crate) fn each_node<'n>(node: &'n Node, give: &mut impl FnMut(&'n Node)) {
    give(node);
    match &node.kind {
        NodeKind::Binary(_, left, right) => {
            each_node(left, give);
            each_node(right, give);
        }
        NodeKind::Unary(_, inner) | NodeKind::Paren(inner) => each_node(inner, give),
        NodeKind::Call(_, arguments) => arguments.iter().for_each(|argument| each_node(argument, give)),
        _ => {}
    }
}

/// Every path of a tag in a value, with its indices and members, and those in its indices.
pub(crate) fn each_tag_path<'n>(node: &'n Node, give: &mut impl FnMut(&'n Node)) {
    match &node.kind {
        NodeKind::Name(_) | NodeKind::Address(_) => give(node),
        NodeKind::Member(..) | NodeKind::Index(..) | NodeKind::Range(..) => {
            give(node);
            let mut base = node;
            loop {
                base = match &base.kind {
                    NodeKind::Member(inner, _) | NodeKind::Paren(inner) => inner,
                    NodeKind::Index(inner, index) => {
                        each_tag_path(index, give);
                        inner
                    }
                    NodeKind::Range(inner, first, last) => {
                        each_tag_path(first, give);
                        each_tag_path(last, give);
                        inner
                    }
                    _ => return,
                };
            }
        }
        NodeKind::Unary(_, inner) | NodeKind::Paren(inner) => each_tag_path(inner, give),
        NodeKind::Binary(_, left, right) => {
            each_tag_path(left, give);
            each_tag_path(right, give);
        }
        NodeKind::Call(_, arguments) => {
            arguments
                .iter()
                .for_each(|argument| each_tag_path(argument, give));
        }
        _ => {}
    }
}
