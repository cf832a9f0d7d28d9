//! Constant expressions: `3.14 / 180` is a number.

use ladder_format::program::{Expression, Literal, Operator, Path, Sign};
use std::cell::Cell;

/// Constants are made of others no deeper.
const DEEPEST: usize = 32;

/// A number is made of so many parts at most, each counted where it is used: constants that use others twice would be computed for ever.
const MOST_PARTS: usize = 10_000;

#[derive(Debug, Clone, Copy, PartialEq)]
enum Number {
    Whole(i128),
    Real(f64),
}

/// The number that an expression of numbers is; `value_of` is what a constant in it has. None: it is none, or systems differ about
/// it, as about `1 / 3`.
pub fn folded(expression: &Expression, value_of: &dyn Fn(&Path) -> Option<Expression>) -> Option<Literal> {
    let left = Cell::new(MOST_PARTS);
    let text = match number(expression, value_of, &left, 0)? {
        Number::Whole(number) => number.to_string(),
        Number::Real(number) if number.is_finite() => {
            let text = format!("{number:?}");
            // `1e-7` has no point.
            match text.split_once('e') {
                Some((digits, power)) if !digits.contains('.') => format!("{digits}.0e{power}"),
                _ => text,
            }
        }
        Number::Real(_) => return None,
    };
    Literal::read(text).ok()
}

fn number(
    expression: &Expression,
    value_of: &dyn Fn(&Path) -> Option<Expression>,
    left: &Cell<usize>,
    depth: usize,
) -> Option<Number> {
    left.set(left.get().checked_sub(1)?);
    if depth > DEEPEST {
        return None;
    }
    let inner = |inner: &Expression| number(inner, value_of, left, depth + 1);
    match expression {
        Expression::Literal(literal) => of_literal(literal.as_str()),
        Expression::Path(path) => inner(&value_of(path)?),
        Expression::Group(group) => inner(group),
        Expression::Unary(Sign::Minus, operand) => Some(match inner(operand)? {
            Number::Whole(number) => Number::Whole(number.checked_neg()?),
            Number::Real(number) => Number::Real(-number),
        }),
        Expression::Binary(operator, left, right) => match (inner(left)?, inner(right)?) {
            (Number::Whole(left), Number::Whole(right)) => of_whole(*operator, left, right),
            (left, right) => of_real(*operator, left.real(), right.real()),
        },
        Expression::Unary(Sign::Not, _) | Expression::Call(..) => None,
    }
}

impl Number {
    fn real(self) -> f64 {
        match self {
            Number::Whole(number) => number as f64,
            Number::Real(number) => number,
        }
    }
}

fn of_literal(text: &str) -> Option<Number> {
    let digits: String = text.chars().filter(|c| *c != '_').collect();
    if let Some((base, digits)) = digits.split_once('#') {
        let base = base.parse().ok().filter(|base| (2..=16).contains(base))?;
        return i128::from_str_radix(digits, base).ok().map(Number::Whole);
    }
    if !digits.starts_with(|c: char| c.is_ascii_digit() || c == '-') {
        return None;
    }
    match digits.parse() {
        Ok(number) => Some(Number::Whole(number)),
        Err(_) => digits.parse().ok().map(Number::Real),
    }
}

fn of_whole(operator: Operator, left: i128, right: i128) -> Option<Number> {
    let number = match operator {
        Operator::Plus => left.checked_add(right),
        Operator::Minus => left.checked_sub(right),
        Operator::Times => left.checked_mul(right),
        Operator::Divide if left.checked_rem(right)? == 0 => left.checked_div(right),
        Operator::Mod => left.checked_rem(right),
        _ => None,
    };
    number.map(Number::Whole)
}

fn of_real(operator: Operator, left: f64, right: f64) -> Option<Number> {
    let number = match operator {
        Operator::Plus => left + right,
        Operator::Minus => left - right,
        Operator::Times => left * right,
        Operator::Divide => left / right,
        _ => return None,
    };
    Some(Number::Real(number))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn constant_expressions_are_numbers() {
        let value_of = |path: &Path| {
            let value = if path.root == "size" { "10" } else { "size" };
            (path.root != "other").then(|| Expression::read(value).ok())?
        };
        let shown = |text: &str| {
            let expression = Expression::read(text).expect("it is an expression");
            folded(&expression, &value_of).map_or("none".to_owned(), |literal| literal.as_str().to_owned())
        };
        let all = [
            "3.0 / 4",
            "-(2 + 3) * 16#10",
            "again - 1",
            "1 / 3",
            "6 / 3",
            "1.0 / 0.0",
            "other + 1",
            "0.001 / 10000",
            "TRUE",
        ];
        let shown: Vec<String> = all.into_iter().map(shown).collect();
        assert_eq!(shown.join(" "), "0.75 -80 9 none 2 none none 1.0e-7 none");
    }

    #[test]
    fn what_is_made_of_too_many_parts_is_none() {
        // Each constant is the sum of the one before with itself, again and again.
        fn doubled(name: &str, times: usize) -> String {
            match times {
                0 => name.to_owned(),
                _ => format!("({0} + {0})", doubled(name, times - 1)),
            }
        }
        let value_of = |path: &Path| {
            let value = if path.root == "a" {
                doubled("b", 7)
            } else {
                "1".to_owned()
            };
            Expression::read(&value).ok()
        };
        let value = |text: String| folded(&Expression::read(&text).expect("it is an expression"), &value_of);
        assert!(value(doubled("b", 7)).is_some());
        assert!(value(doubled("a", 7)).is_none());
    }
}
