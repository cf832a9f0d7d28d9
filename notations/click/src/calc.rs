//! Formulas as `[CALC]` computes them.

use super::bank::Kind;
use super::formula::{self, Spelling};
use super::model::{Constant, Formula, Function, Math, MathKind, Operand, Operator};
use super::operand::{Chain, kind, literal};
use super::tags::Tags;
use std::cell::RefCell;

/// The blocks that compute a formula.
pub(super) fn math(tags: &mut Tags<'_>, math: &Math) -> Result<Chain, String> {
    let mut chain = Chain::default();
    let Some(target) = kind(&math.target) else {
        return Err("a constant cannot be written".to_owned());
    };
    let constants = match math.kind {
        MathKind::Decimal => decimal(&math.formula, target)?,
        MathKind::Hex => Kind::Hex,
    };
    let expression = expression(tags, &mut chain, &math.formula, constants);
    let place = chain.place(tags, &math.target);
    chain.push(format!("[CALC]( {place}, {expression} )"));
    Ok(chain)
}

/// What a decimal formula is computed in: wide enough for all of its parts.
fn decimal(formula: &Formula, target: Kind) -> Result<Kind, String> {
    let mut kinds = parts(formula);
    kinds.push(target);
    if let Some(odd) = kinds.iter().find(|kind| matches!(kind, Kind::Bit | Kind::Text)) {
        let what = if *odd == Kind::Bit { "a bit" } else { "a text" };
        return Err(format!("{what} is not a number"));
    }
    if kinds.contains(&Kind::Hex) {
        return Err("decimal and hexadecimal numbers do not mix in a formula".to_owned());
    }
    let wide = kinds.contains(&Kind::Int2);
    let real = kinds.contains(&Kind::Float) || is_real(formula);
    Ok(match (real, wide) {
        (true, _) => Kind::Float,
        (false, true) => Kind::Int2,
        (false, false) => Kind::Int,
    })
}

/// The kinds of what a formula reads.
pub(super) fn parts(formula: &Formula) -> Vec<Kind> {
    let (mut operands, mut sums) = (Vec::new(), Vec::new());
    formula::operands(formula, &mut operands);
    formula::sums(formula, &mut sums);
    let mut kinds: Vec<Kind> = operands.into_iter().filter_map(kind).collect();
    kinds.extend(sums.iter().map(|span| span.bank.kind()));
    kinds
}

/// Whether a formula has a real number in it, whatever its addresses hold.
fn is_real(formula: &Formula) -> bool {
    match formula {
        Formula::Pi => true,
        Formula::Value(operand) => matches!(operand, Operand::Constant(Constant::Float(_))),
        Formula::Sum(_) => false,
        Formula::Negated(inside) | Formula::Not(inside) => is_real(inside),
        Formula::Binary(left, _, right) => is_real(left) || is_real(right),
        Formula::Call(function, arguments) => {
            !matches!(function, Function::RotateLeft | Function::RotateRight) || arguments.iter().any(is_real)
        }
    }
}

/// A formula as the expression of a `[CALC]`. What must be ready before it goes into the chain.
fn expression(tags: &mut Tags<'_>, chain: &mut Chain, formula: &Formula, ty: Kind) -> String {
    let formula = without_rotates(formula);
    let both = RefCell::new((tags, chain));
    let operand = |operand: &Operand| {
        let (tags, chain) = &mut *both.borrow_mut();
        match operand {
            Operand::Constant(constant) => literal(constant, Some(ty)),
            other => chain.value(tags, other, None),
        }
    };
    let spelling = Spelling {
        operand: &operand,
        sum: &|span| format!("SUM({})", super::ranges::range(span)),
        binary: None,
    };
    formula::write(&formula, spelling)
}

/// A rotate by a number of places is two shifts.
fn without_rotates(formula: &Formula) -> Formula {
    let all = |inside: &Formula| Box::new(without_rotates(inside));
    match formula {
        Formula::Value(_) | Formula::Pi | Formula::Sum(_) => formula.clone(),
        Formula::Negated(inside) => Formula::Negated(all(inside)),
        Formula::Not(inside) => Formula::Not(all(inside)),
        Formula::Binary(left, operator, right) => Formula::Binary(all(left), *operator, all(right)),
        Formula::Call(function @ (Function::RotateLeft | Function::RotateRight), arguments) => {
            let [value, by] = &arguments[..] else {
                return formula.clone();
            };
            let (there, back) = match function {
                Function::RotateLeft => (Operator::ShiftLeft, Operator::ShiftRight),
                _ => (Operator::ShiftRight, Operator::ShiftLeft),
            };
            let width = Box::new(Formula::Value(Operand::Constant(Constant::Int(16))));
            let rest = Formula::Binary(width, Operator::Subtract, all(by));
            Formula::Binary(
                Box::new(Formula::Binary(all(value), there, all(by))),
                Operator::Or,
                Box::new(Formula::Binary(all(value), back, Box::new(rest))),
            )
        }
        Formula::Call(function, arguments) => {
            Formula::Call(*function, arguments.iter().map(without_rotates).collect())
        }
    }
}
