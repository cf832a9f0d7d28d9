//! Formulas of `calc` and `math_hex`, as Click and the DSL write them.
//!
//! Loosest first: `OR`, `XOR`, `AND`, `SHL SHR`, `+ -`, `* / MOD`, `^` (to the right), a sign or `NOT`.

mod parse;
mod write;

use super::address::Span;
use super::model::{Formula, Function, MathKind, Operand, Operator};
pub(super) use parse::parse;
pub(super) use write::{Spelling, write};

const OPERATORS: &[(Operator, &str, u8)] = &[
    (Operator::Or, "OR", 1),
    (Operator::Xor, "XOR", 2),
    (Operator::And, "AND", 3),
    (Operator::ShiftLeft, "SHL", 4),
    (Operator::ShiftRight, "SHR", 4),
    (Operator::Add, "+", 5),
    (Operator::Subtract, "-", 5),
    (Operator::Multiply, "*", 6),
    (Operator::Divide, "/", 6),
    (Operator::Modulo, "MOD", 6),
    (Operator::Power, "^", 7),
];

const FUNCTIONS: &[(Function, &str, usize)] = &[
    (Function::Sin, "SIN", 1),
    (Function::Cos, "COS", 1),
    (Function::Tan, "TAN", 1),
    (Function::Asin, "ASIN", 1),
    (Function::Acos, "ACOS", 1),
    (Function::Atan, "ATAN", 1),
    (Function::Log, "LOG", 1),
    (Function::Ln, "LN", 1),
    (Function::Sqrt, "SQRT", 1),
    (Function::Rad, "RAD", 1),
    (Function::Deg, "DEG", 1),
    (Function::RotateLeft, "LRO", 2),
    (Function::RotateRight, "RRO", 2),
];

/// Of signs and `NOT`.
const PREFIX: u8 = 8;
/// Of what stands for itself.
const ATOM: u8 = 9;

impl Operator {
    /// As a formula writes it.
    pub(super) fn sign(self) -> &'static str {
        OPERATORS[self.row()].1
    }

    fn precedence(self) -> u8 {
        OPERATORS[self.row()].2
    }

    fn row(self) -> usize {
        OPERATORS.iter().position(|row| row.0 == self).unwrap_or(0)
    }
}

impl Function {
    /// As a formula writes it.
    pub(super) fn name(self) -> &'static str {
        FUNCTIONS.iter().find(|row| row.0 == self).map_or("", |row| row.1)
    }
}

/// The addresses and pointers that a formula reads, from left to right.
pub(super) fn operands<'f>(formula: &'f Formula, out: &mut Vec<&'f Operand>) {
    match formula {
        Formula::Value(operand) => out.push(operand),
        Formula::Pi | Formula::Sum(_) => {}
        Formula::Negated(inside) | Formula::Not(inside) => operands(inside, out),
        Formula::Binary(left, _, right) => {
            operands(left, out);
            operands(right, out);
        }
        Formula::Call(_, arguments) => arguments.iter().for_each(|argument| operands(argument, out)),
    }
}

/// The ranges that a formula adds up.
pub(super) fn sums<'f>(formula: &'f Formula, out: &mut Vec<&'f Span>) {
    match formula {
        Formula::Sum(span) => out.push(span),
        Formula::Value(_) | Formula::Pi => {}
        Formula::Negated(inside) | Formula::Not(inside) => sums(inside, out),
        Formula::Binary(left, _, right) => {
            sums(left, out);
            sums(right, out);
        }
        Formula::Call(_, arguments) => arguments.iter().for_each(|argument| sums(argument, out)),
    }
}

/// An operator or function that the other kind of math has and this one has not.
pub(super) fn foreign(formula: &Formula, kind: MathKind) -> Option<&'static str> {
    let of_parts = |parts: &[&Formula]| parts.iter().find_map(|part| foreign(part, kind));
    match formula {
        Formula::Value(_) | Formula::Sum(_) => None,
        Formula::Pi => (kind == MathKind::Hex).then_some("PI"),
        Formula::Negated(inside) => foreign(inside, kind),
        Formula::Not(inside) if kind == MathKind::Hex => foreign(inside, kind),
        Formula::Not(_) => Some("NOT"),
        Formula::Binary(left, operator, right) => {
            use Operator::{And, Or, Power, ShiftLeft, ShiftRight, Xor};
            let own = match operator {
                And | Or | Xor | ShiftLeft | ShiftRight => MathKind::Hex,
                Power => MathKind::Decimal,
                _ => kind,
            };
            if own != kind {
                return Some(operator.sign());
            }
            of_parts(&[left, right])
        }
        Formula::Call(function, arguments) => {
            let own = match function {
                Function::RotateLeft | Function::RotateRight => MathKind::Hex,
                _ => MathKind::Decimal,
            };
            if own == kind {
                arguments.iter().find_map(|argument| foreign(argument, kind))
            } else {
                Some(function.name())
            }
        }
    }
}

/// Whether a text has no more parentheses in one another than Click reads.
///
/// # Errors
///
/// It has more of them.
pub(super) fn shallow(text: &str) -> Result<(), String> {
    if nesting(text) > 8 {
        return Err("Click has no more than eight parentheses in one another".to_owned());
    }
    Ok(())
}

/// How many parentheses are in one another in the text of a formula.
pub(super) fn nesting(text: &str) -> usize {
    let mut depth = 0usize;
    let mut deepest = 0;
    for c in text.chars() {
        match c {
            '(' => depth += 1,
            ')' => depth = depth.saturating_sub(1),
            _ => {}
        }
        deepest = deepest.max(depth);
    }
    deepest
}
