//! Formulas as `[CALC]` computes them.

use super::act::Refusal;
use super::bank::Kind;
use super::formula;
use super::model::{Constant, Formula, Function, Math, MathKind, Operand};
use super::operand::{Chain, kind};
use super::ranges::range;
use super::tags::Tags;
use ladder_format::program::{Expression, Operator, Path, Sign};
use ladder_instructions::Op;

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
    let value = expression(tags, &mut chain, &math.formula, constants)?;
    let place = chain.value(tags, &math.target, None)?;
    chain.push(Op::Calc, [place, value])?;
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
fn expression(
    tags: &mut Tags<'_>,
    chain: &mut Chain,
    formula: &Formula,
    ty: Kind,
) -> Result<Expression, Refusal> {
    let mut inner = |formula: &Formula| expression(tags, chain, formula, ty);
    Ok(match formula {
        Formula::Value(operand) => chain.value(tags, operand, Some(ty))?,
        Formula::Pi => Path::tag("PI").into(),
        Formula::Sum(span) => Expression::call("SUM", [range(span)]),
        Formula::Negated(inside) => Expression::Unary(Sign::Minus, Box::new(inner(inside)?)),
        Formula::Not(inside) => inner(inside)?.negated(),
        Formula::Binary(left, operator, right) => {
            let sign = operator.sign();
            let operator = Operator::of(sign).ok_or_else(|| format!("`{sign}` has no counterpart here"))?;
            inner(left)?.with(operator, inner(right)?)
        }
        // A rotate by a number of places is two shifts.
        Formula::Call(function @ (Function::RotateLeft | Function::RotateRight), arguments) => {
            let [value, by] = &arguments[..] else {
                return Err(format!(
                    "`{}` takes a value and a number of places",
                    function.name()
                ));
            };
            let (value, by) = (inner(value)?, inner(by)?);
            let (there, back) = match function {
                Function::RotateLeft => (Operator::Shl, Operator::Shr),
                _ => (Operator::Shr, Operator::Shl),
            };
            let rest = Expression::from(16).with(Operator::Minus, by.clone());
            let low = value.clone().with(back, rest);
            value.with(there, by).with(Operator::Or, low)
        }
        Formula::Call(function, arguments) => {
            let arguments: Result<Vec<Expression>, Refusal> = arguments.iter().map(inner).collect();
            Expression::call(function.name(), arguments?)
        }
    })
}
