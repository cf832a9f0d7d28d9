//! How instructions mix times, points in time and numbers (LANGUAGE §5.2): ADD, SUB, MIN, MAX, LIMIT of TIMEs; MUL
//! and DIV of a TIME by a number; DT - DT and TOD - TOD are TIME, DT + TIME is DT. Nothing else.

use super::Resolver;
use crate::networks::BlockAt;
use crate::networks::network::Formal;
use crate::rules::type_mismatch;
use crate::values::types::Scalar;
use crate::written::constant::{natural_type, signed_literal};
use crate::written::facts::Node;
use ladder_instructions::{Accepts, Op};

/// What an operand is to such an instruction.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Time,
    Dt,
    Tod,
    Number,
}

impl Resolver<'_, '_> {
    /// Whether the operands fit together for a result of type TIME or DT. Says so if they do not; what is neither a
    /// time nor a number is reported operand by operand.
    pub(super) fn check_times(&mut self, op: Op, bound: BlockAt<'_>, ty: Scalar) -> bool {
        if !matches!(ty, Scalar::Time | Scalar::Dt)
            || !matches!(
                op,
                Op::Add | Op::Sub | Op::Mul | Op::Div | Op::Min | Op::Max | Op::Limit
            )
        {
            return true;
        }
        let operands = bound.facts.operands.iter().zip(bound.formals.iter());
        let values = operands.filter(
            |(_, formal)| matches!(formal, Formal::Operand(operand) if operand.accepts == Accepts::Value),
        );
        let kinds: Option<Vec<Kind>> = values.map(|(operand, _)| self.kind(&operand.value)).collect();
        let Some(kinds) = kinds else { return true };
        // A number among TIMEs does not pass, and is reported by itself.
        let points = kinds.iter().any(|kind| matches!(kind, Kind::Dt | Kind::Tod));
        if ty == Scalar::Time && !points && !matches!(op, Op::Mul | Op::Div) {
            return true;
        }
        if fit(op, ty, &kinds) {
            return true;
        }
        self.report(type_mismatch::times(op, ty, bound.range()));
        false
    }

    fn kind(&self, node: &Node) -> Option<Kind> {
        let ty = match self.own_type(node) {
            Some(ty) => ty,
            None => match signed_literal(node)? {
                (Ok(literal), negative) => natural_type(literal, negative),
                (Err(_), _) => return None,
            },
        };
        match ty {
            Scalar::Time => Some(Kind::Time),
            Scalar::Dt => Some(Kind::Dt),
            Scalar::Tod => Some(Kind::Tod),
            ty if ty.is_number() => Some(Kind::Number),
            _ => None,
        }
    }
}

fn fit(op: Op, ty: Scalar, kinds: &[Kind]) -> bool {
    let all = |kind: Kind, of: &[Kind]| of.iter().all(|&found| found == kind);
    let Some((first, rest)) = kinds.split_first() else {
        return true;
    };
    match (op, ty) {
        (Op::Add, Scalar::Dt) => *first == Kind::Dt && all(Kind::Time, rest),
        (_, Scalar::Dt) => false,
        (Op::Sub, _) if matches!(kinds, [Kind::Dt, Kind::Dt] | [Kind::Tod, Kind::Tod]) => true,
        (Op::Mul, _) => {
            let times = kinds.iter().filter(|&&kind| kind == Kind::Time).count();
            let numbers = kinds.iter().filter(|&&kind| kind == Kind::Number).count();
            times == 1 && times + numbers == kinds.len()
        }
        (Op::Div, _) => *first == Kind::Time && all(Kind::Number, rest),
        _ => all(Kind::Time, kinds),
    }
}
