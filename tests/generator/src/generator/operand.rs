//! What is between a block's parentheses: values that pass to a type, and places of a type.

use super::dice::Dice;
use super::scope::{Scope, Type};
use super::value::{SCALARS, literal};
use ladder_analysis::values::types::{Scalar, passes};
use ladder_instructions::StateType;

/// The integer types.
pub(super) const INTEGERS: [Scalar; 8] = [
    Scalar::Sint,
    Scalar::Int,
    Scalar::Dint,
    Scalar::Lint,
    Scalar::Usint,
    Scalar::Uint,
    Scalar::Udint,
    Scalar::Ulint,
];

/// A value that passes to a type: a literal, a tag, an element, a bit, a member.
pub(super) fn read(dice: &mut Dice, scope: &mut Scope, ty: Scalar) -> String {
    if !scope.is_boolean && dice.one_in(4) {
        return literal(dice, ty);
    }
    let sources: Vec<Scalar> = SCALARS.into_iter().filter(|&from| passes(from, ty)).collect();
    let from = if dice.one_in(3) { dice.of(&sources) } else { ty };
    read_exactly(dice, scope, from)
}

/// A tag, element, bit or member of exactly this type.
pub(super) fn read_exactly(dice: &mut Dice, scope: &mut Scope, ty: Scalar) -> String {
    if !scope.is_boolean
        && dice.one_in(5)
        && let Some(found) = member(dice, scope, ty)
    {
        return found;
    }
    place_or_value(dice, scope, ty, false)
}

/// A tag, element or bit that can be written.
pub(super) fn place(dice: &mut Dice, scope: &mut Scope, ty: Scalar) -> String {
    place_or_value(dice, scope, ty, true)
}

fn place_or_value(dice: &mut Dice, scope: &mut Scope, ty: Scalar, write: bool) -> String {
    if scope.is_boolean {
        return format!("m{}", dice.below(8));
    }
    match dice.below(8) {
        0 => {
            let (name, first, last) = scope.array(dice, ty, 2, write);
            let index = index(dice, scope, first, last);
            format!("{name}[{index}]")
        }
        1 if ty == Scalar::Bool => {
            let words = [
                Scalar::Byte,
                Scalar::Word,
                Scalar::Int,
                Scalar::Udint,
                Scalar::Lint,
            ];
            let word = dice.of(&words);
            let name = scope.scalar(dice, word, write);
            // `%IW3.2` is not a bit of an address.
            format!("{name}.{}", dice.below(word.width() as usize))
        }
        _ => scope.scalar(dice, ty, write),
    }
}

/// An index, which may lie outside the array when the program runs: then it is not CONSTANT.
fn index(dice: &mut Dice, scope: &mut Scope, first: i64, last: i64) -> String {
    if dice.one_in(4) {
        let ty = dice.of(&INTEGERS);
        return scope.scalar(dice, ty, true);
    }
    dice.between(first, last).to_string()
}

/// A range of so many elements, or all from an element on: the array and the range.
pub(super) fn range(dice: &mut Dice, scope: &mut Scope, element: Scalar, length: i64, write: bool) -> String {
    let (name, first, last) = scope.array(dice, element, length, write);
    let start = dice.between(first, last - length + 1);
    format!("{name}[{start}..{}]", start + length - 1)
}

/// Any integer.
pub(super) fn integer(dice: &mut Dice, scope: &mut Scope, small: bool) -> String {
    if small && !dice.one_in(4) {
        return dice.between(0, 4).to_string();
    }
    let ty = dice.of(&INTEGERS);
    read_exactly(dice, scope, ty)
}

/// A member of a timer, counter or bistable that is there, or a system tag.
fn member(dice: &mut Dice, scope: &Scope, ty: Scalar) -> Option<String> {
    let states: Vec<(&str, StateType)> = scope
        .tags
        .iter()
        .filter_map(|tag| match tag.ty {
            Type::State(state) => Some((tag.name.as_str(), state)),
            _ => None,
        })
        .collect();
    let system: &[&str] = match ty {
        Scalar::Bool => &[
            "SYS.FIRST_SCAN",
            "SYS.ON",
            "SYS.OFF",
            "SYS.FAULT",
            "SYS.CLOCK_100MS",
        ],
        Scalar::Dint => &["SYS.SCAN"],
        Scalar::Time => &["SYS.TIME", "SYS.SCAN_TIME"],
        _ => return None,
    };
    if states.is_empty() || dice.one_in(3) {
        return Some(dice.of(system).to_owned());
    }
    let (name, state) = dice.of(&states);
    let members: &[&str] = match (ty, state) {
        (Scalar::Bool, state) if state.is_timer() => &["Q", "IN", "EN", "DN", "TT", "R"],
        (Scalar::Bool, StateType::Ctud) => &["QU", "QD", "Q", "CU", "CD", "CC", "LD"],
        (Scalar::Bool, state) if state.is_counter() => &["Q", "DN", "CU", "CC", "R"],
        (Scalar::Bool, _) => &["Q1"],
        (Scalar::Time, state) if state.is_timer() => &["ET", "PT", "PRE", "ACC", "AC"],
        (Scalar::Dint, state) if state.is_counter() => &["CV", "PV", "ACC", "PRE"],
        _ => return None,
    };
    Some(format!("{name}.{}", dice.of(members)))
}
