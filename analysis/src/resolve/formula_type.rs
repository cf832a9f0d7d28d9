//! The type that a formula is computed in where that is the widest of its parts
//! ([`Arithmetic::OfFormula`](ladder_instructions::Arithmetic) and its like).

use super::Resolver;
use crate::values::literal::Literal;
use crate::values::types::Scalar;
use crate::written::constant::signed_literal;
use crate::written::facts::{Node, NodeKind};
use ladder_instructions::{Accepts, Arithmetic, Shape, TypeClass, lookup};

/// What a formula and its result are made of.
#[derive(Default)]
struct Parts {
    real: bool,
    /// An integer of more than 16 bits.
    wide: bool,
    /// A real of 64 bits.
    long: bool,
    bits: bool,
    /// A number is written that only an unsigned integer of 16 bits holds, or none of 16 bits.
    unsigned: bool,
    large: bool,
    /// Something that is not a number: then the result says what to expect.
    other: bool,
}

impl Parts {
    fn add(&mut self, ty: Scalar) {
        match ty {
            Scalar::Lreal => (self.real, self.long) = (true, true),
            Scalar::Real => self.real = true,
            Scalar::Sint | Scalar::Int | Scalar::Usint => {}
            Scalar::Dint => self.wide = true,
            Scalar::Byte | Scalar::Word | Scalar::Uint => self.bits = true,
            _ => self.other = true,
        }
    }
}

impl Resolver<'_, '_> {
    /// The type in which the formula of `[CALC]` is computed whose result has a type.
    pub(super) fn formula_type(&self, node: &Node, result: Scalar) -> Scalar {
        let is_wide = match self.semantics().arithmetic {
            Arithmetic::OfFormula => false,
            Arithmetic::OfWideFormula => true,
            Arithmetic::OfResult | Arithmetic::OfOperands => return result,
        };
        let mut parts = Parts::default();
        parts.add(result);
        self.collect(node, &mut parts);
        let Parts {
            bits,
            unsigned,
            large,
            ..
        } = parts;
        parts.wide |= large || (unsigned && !bits);
        match parts {
            Parts { other: true, .. } => result,
            Parts {
                real: true,
                wide,
                long,
                ..
            } => {
                // 32 bits of a real do not hold 32 bits of an integer.
                if wide || long { Scalar::Lreal } else { Scalar::Real }
            }
            Parts { wide: true, .. } => Scalar::Dint,
            _ if is_wide => Scalar::Dint,
            Parts { bits: true, .. } => Scalar::Uint,
            _ => Scalar::Int,
        }
    }

    fn collect(&self, node: &Node, parts: &mut Parts) {
        if let Some((literal, negative)) = signed_literal(node) {
            match literal {
                Ok(Literal::Int(number)) => {
                    let number = if negative { -number } else { *number };
                    match i16::try_from(number) {
                        Ok(_) => {}
                        Err(_) if u16::try_from(number).is_ok() => parts.unsigned = true,
                        Err(_) => parts.large = true,
                    }
                }
                Ok(Literal::Real(_)) => parts.real = true,
                Ok(Literal::Typed(ty, _)) => parts.add(*ty),
                Ok(_) => parts.other = true,
                Err(_) => {}
            }
            return;
        }
        match &node.kind {
            NodeKind::Paren(inner) | NodeKind::Unary(_, inner) => self.collect(inner, parts),
            NodeKind::Binary(_, left, right) => {
                self.collect(left, parts);
                self.collect(right, parts);
            }
            NodeKind::Name(name) if name.eq_ignore_ascii_case("PI") => parts.real = true,
            NodeKind::Call(name, arguments) => {
                let mut rows = lookup(Shape::Logical, &name.text);
                parts.real |= rows.any(|row| {
                    let result = row.operands.first().map(|operand| operand.accepts);
                    result == Some(Accepts::Result(TypeClass::Real))
                });
                for argument in arguments {
                    self.collect(argument, parts);
                }
            }
            _ => {
                if let Some(ty) = self.own_type(node) {
                    parts.add(ty);
                }
            }
        }
    }
}
