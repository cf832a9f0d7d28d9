//! Expressions of `[CALC]` in a type.

use super::dice::Dice;
use super::operand::{integer, read, read_exactly};
use super::scope::Scope;
use ladder_analysis::values::types::{DEFAULT_STRING, Scalar};

/// An expression that nests at most so deep.
pub(super) fn expression(dice: &mut Dice, scope: &mut Scope, ty: Scalar, depth: usize) -> String {
    if depth == 0 || dice.one_in(4) {
        return read(dice, scope, ty);
    }
    match ty {
        Scalar::Bool => logic(dice, scope, depth - 1),
        Scalar::Time => time(dice, scope, depth - 1),
        Scalar::String(_) => {
            let text = read(dice, scope, ty);
            let first = expression(dice, scope, ty, depth - 1);
            let count = integer(dice, scope, true);
            match dice.below(3) {
                0 => format!("CONCAT({first}, {text})"),
                1 => format!("LEFT({first}, {count})"),
                _ => format!("right({first},{count})"),
            }
        }
        Scalar::Date | Scalar::Tod | Scalar::Dt => read(dice, scope, ty),
        _ if ty.is_bits() => bits(dice, scope, ty, depth - 1),
        _ => number(dice, scope, ty, depth - 1),
    }
}

fn both(dice: &mut Dice, scope: &mut Scope, ty: Scalar, depth: usize) -> (String, String) {
    (
        expression(dice, scope, ty, depth),
        expression(dice, scope, ty, depth),
    )
}

fn logic(dice: &mut Dice, scope: &mut Scope, depth: usize) -> String {
    if dice.one_in(3) {
        let ty = dice.of(&[
            Scalar::Int,
            Scalar::Dint,
            Scalar::Lreal,
            Scalar::Time,
            Scalar::Word,
        ]);
        let operator = dice.of(&["=", "<>", "<", "<=", ">", ">="]);
        let left = read_exactly(dice, scope, ty);
        let right = read_exactly(dice, scope, ty);
        return format!("{left} {operator} {right}");
    }
    let (a, b) = both(dice, scope, Scalar::Bool, depth);
    match dice.below(4) {
        0 => format!("({a}) AND {b}"),
        1 => format!("{a} or ({b})"),
        2 => format!("({a}) XOR ({b})"),
        _ => format!("NOT ({a})"),
    }
}

fn time(dice: &mut Dice, scope: &mut Scope, depth: usize) -> String {
    let (a, b) = both(dice, scope, Scalar::Time, depth);
    match dice.below(5) {
        0 => format!("({a}) - ({b})"),
        1 => format!("({a}) * {}", dice.between(0, 5)),
        2 => format!("({a}) / {}", read_exactly(dice, scope, Scalar::Dint)),
        3 => format!("MAX({a}, {b})"),
        _ => format!("({a}) + {b}"),
    }
}

fn bits(dice: &mut Dice, scope: &mut Scope, ty: Scalar, depth: usize) -> String {
    let (a, b) = both(dice, scope, ty, depth);
    match dice.below(5) {
        0 => format!("({a}) AND ({b})"),
        1 => format!("({a}) OR ({b})"),
        2 => format!("not ({a})"),
        3 => format!("({a}) SHL {}", integer(dice, scope, true)),
        _ => format!("({a}) xor ({b})"),
    }
}

fn number(dice: &mut Dice, scope: &mut Scope, ty: Scalar, depth: usize) -> String {
    let (a, b) = both(dice, scope, ty, depth);
    let text = match dice.below(11) {
        0 => format!("({a}) - ({b})"),
        1 => format!("({a}) * ({b})"),
        2 => format!("({a}) / ({b})"),
        3 => format!("({a}) MOD ({b})"),
        4 => format!("({a}) ^ {}", dice.between(0, 3)),
        5 => format!("-({a})"),
        6 => format!("MIN({a}, {b})"),
        7 => format!("LIMIT({a}, {b}, {})", read(dice, scope, ty)),
        8 => format!("SEL({}, {a}, {b})", expression(dice, scope, Scalar::Bool, depth)),
        9 if ty.is_real() => format!("SQRT(ABS({a})) + PI"),
        10 => {
            let (name, first, last) = scope.array(dice, ty, 2, false);
            format!("SUM({name}[{first}..{last}]) + ({b})")
        }
        _ => format!("({a}) + ({b})"),
    };
    if ty.is_integer() && dice.one_in(10) {
        let text_type = Scalar::String(DEFAULT_STRING);
        return format!("LEN({}) + ({text})", read(dice, scope, text_type));
    }
    text
}
