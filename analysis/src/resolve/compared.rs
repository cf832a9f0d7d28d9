//! The type that an instruction works in where its operands decide it.

use super::Resolver;
use crate::networks::BlockAt;
use crate::networks::network::Formal;
use crate::program::{Expr, ExprKind};
use crate::rules::type_mismatch;
use crate::values::types::{Scalar, Type, common};
use crate::values::value::Value;
use crate::written::constant::{natural_type, signed_literal};
use crate::written::facts::{Node, NodeKind};
use ladder_instructions::{Accepts, Arithmetic, Op, Truth};

/// How the operands of a comparison agree.
#[derive(Clone, Copy)]
pub(super) enum Compared {
    /// In one type.
    In(Scalar),
    /// Integers of different types: by value.
    ByValue,
    /// There are none, or they do not agree.
    Not,
}

/// The type that operands are compared in, if its values have no order: BOOL, an enumeration.
pub(super) fn compared_without_order(compared: Compared) -> Option<Scalar> {
    match compared {
        Compared::In(ty @ (Scalar::Bool | Scalar::Enum(_))) => Some(ty),
        _ => None,
    }
}

impl Resolver<'_, '_> {
    /// Whether an instruction works in the type of its operands, not in that of its result.
    pub(super) fn is_of_operands(&self, op: Op) -> bool {
        self.semantics().arithmetic == Arithmetic::OfOperands && op.is_plain_arithmetic()
    }

    /// An operand of such an instruction: any number, or a BOOL.
    pub(super) fn operand_number(&mut self, node: &Node) -> Option<Expr> {
        let mut value = self.natural(node)?;
        if let ExprKind::Constant(Value::Real(real)) = &mut value.kind
            && value.ty == Scalar::Lreal
            && Scalar::real_of(self.semantics()) == Scalar::Real
        {
            value.ty = Scalar::Real;
            *real = f64::from(*real as f32);
        }
        if value.ty.is_number() || value.ty.is_bits() || value.ty == Scalar::Bool {
            return Some(value);
        }
        self.report(type_mismatch::wrong(
            value.range,
            format!("a number is expected here, this is {}", value.ty),
        ));
        None
    }

    /// The type of the elements of a range among the operands.
    fn searched(&self, bound: BlockAt<'_>) -> Option<Scalar> {
        let array = bound
            .facts
            .operands
            .iter()
            .find_map(|written| match &written.value.kind {
                NodeKind::Range(base, ..) => Some(base),
                _ => None,
            });
        match self.tag_type(self.named_tag(array?)?) {
            Type::Array { element, .. } => Some(element),
            _ => None,
        }
    }

    /// The type that the operands of a comparison agree in.
    pub(super) fn compared_type(&mut self, bound: BlockAt<'_>) -> Compared {
        let nodes: Vec<&Node> = bound
            .facts
            .operands
            .iter()
            .zip(bound.formals.iter())
            .filter(|(_, formal)| matches!(formal, Formal::Operand(o) if o.accepts == Accepts::Compared))
            .map(|(operand, _)| &operand.value)
            .collect();
        if nodes.is_empty() {
            return Compared::Not;
        }
        let mut typed: Vec<Scalar> = nodes.iter().filter_map(|node| self.own_type(node)).collect();
        if self.semantics().truth == Truth::NotZero {
            // A BOOL is a number there.
            for ty in typed.iter_mut().filter(|ty| **ty == Scalar::Bool) {
                *ty = Scalar::integer_of(self.semantics());
            }
        }
        if typed.is_empty() {
            // A value of the elements that are searched.
            typed.extend(self.searched(bound).filter(|ty| ty.is_enumeration()));
        }
        let Some((&first, rest)) = typed.split_first() else {
            // Literals only.
            let natural = |node: &&Node| match signed_literal(node) {
                Some((Ok(literal), negative)) => natural_type(literal, negative),
                _ => Scalar::Dint,
            };
            let all = nodes.iter().map(natural).reduce(|a, b| common(a, b).unwrap_or(a));
            return Compared::In(all.unwrap_or(Scalar::Dint));
        };
        let has_real_literal = nodes.iter().any(|node| {
            matches!(
                signed_literal(node),
                Some((Ok(crate::values::literal::Literal::Real(_)), _))
            )
        });
        let integers = typed.iter().all(|ty| ty.is_integer());
        if integers && !has_real_literal && rest.iter().any(|&ty| ty != first) {
            return Compared::ByValue;
        }
        let mut ty = first;
        for &other in rest {
            match common(ty, other) {
                Some(common) => ty = common,
                None => {
                    let asked = typed.iter().copied().find(|ty| ty.is_enumeration());
                    let hidden = asked.and_then(|asked| {
                        let mut nodes = nodes.iter();
                        nodes.find_map(|node| {
                            self.hidden_value(self.at(node.range), self.own_type(node)?, asked)
                        })
                    });
                    let found =
                        hidden.unwrap_or_else(|| type_mismatch::cannot_compare(ty, other, bound.range()));
                    self.report(found);
                    return Compared::Not;
                }
            }
        }
        let mixed = typed.iter().any(|&t| t != ty);
        if ty.is_integer() && mixed && !has_real_literal {
            return Compared::ByValue;
        }
        Compared::In(ty)
    }
}
