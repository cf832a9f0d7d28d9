//! Formulas: what they compute with, and what can never be computed.

use super::super::calc;
use super::super::dsl::spell;
use super::super::formula;
use super::super::model::{Constant, Formula, Function, Math, MathKind, Operand, Operator};
use super::super::operand::kind;
use super::Found;
use super::kinds::{Family, family, sort};
use ladder_notation::LineColumn;

pub(super) fn check(place: LineColumn, math: &Math, out: &mut Found) {
    let Some(target) = kind(&math.target) else {
        return out.error(
            place,
            "click-math",
            "a constant cannot be written: the result goes into an address",
        );
    };
    let mut kinds = calc::parts(&math.formula);
    kinds.push(target);
    let wanted = match math.kind {
        MathKind::Decimal => Family::Decimal,
        MathKind::Hex => Family::Hex,
    };
    if let Some(odd) = kinds.into_iter().find(|kind| family(*kind) != wanted) {
        let instead = match math.kind {
            MathKind::Decimal => "decimal numbers",
            MathKind::Hex => "hexadecimal words",
        };
        let word = out.words.math(math.kind);
        let message = format!("{word} computes with {instead}, and this is {}", sort(odd));
        out.error(place, "click-math", message);
    }
    let text = spell::formula(&math.formula);
    if formula::nesting(&text) > 8 {
        out.error(
            place,
            "click-math",
            "Click has no more than eight parentheses in one another",
        );
    }
    if let Some(why) = impossible(&math.formula) {
        let message = format!("the formula cannot be computed: {why}");
        out.warning(place, "click-c0108", message);
    }
    let operators = formula::foreign(&math.formula, math.kind);
    if let Some(word) = operators {
        let where_it_is = out.words.math(match math.kind {
            MathKind::Decimal => MathKind::Hex,
            MathKind::Hex => MathKind::Decimal,
        });
        out.error(place, "click-math", format!("{word} is for {where_it_is} alone"));
    }
}

/// What a formula can never compute, in words: Click stops with a math error there.
fn impossible(formula: &Formula) -> Option<&'static str> {
    match formula {
        Formula::Value(_) | Formula::Pi | Formula::Sum(_) => None,
        Formula::Negated(inside) | Formula::Not(inside) => impossible(inside),
        Formula::Binary(left, operator, right) => {
            let by_zero =
                matches!(operator, Operator::Divide | Operator::Modulo) && number(right) == Some(0.0);
            if by_zero {
                return Some("it divides by 0");
            }
            impossible(left).or_else(|| impossible(right))
        }
        Formula::Call(function, arguments) => {
            let value = arguments.first().and_then(number);
            let wrong = match (function, value) {
                (Function::Sqrt, Some(value)) if value < 0.0 => Some("a negative number has no square root"),
                (Function::Log | Function::Ln, Some(value)) if value <= 0.0 => {
                    Some("only numbers above 0 have a logarithm")
                }
                (Function::Asin | Function::Acos, Some(value)) if value.abs() > 1.0 => {
                    Some("a sine or cosine lies between -1 and 1")
                }
                _ => None,
            };
            wrong.or_else(|| arguments.iter().find_map(impossible))
        }
    }
}

/// The value of a constant, with its sign.
fn number(formula: &Formula) -> Option<f64> {
    match formula {
        Formula::Value(Operand::Constant(constant)) => match constant {
            Constant::Int(number) => Some(*number as f64),
            Constant::Hex(number) => Some(f64::from(*number)),
            Constant::Float(number) => Some(*number),
            Constant::Bit(_) | Constant::Text(_) => None,
        },
        Formula::Negated(inside) => number(inside).map(|value| -value),
        _ => None,
    }
}
