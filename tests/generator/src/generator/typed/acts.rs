//! What a rung does, with parts that fit.

use super::{Act, CELL, Dice, INPUTS, Index, Path, Span, Ty, Typed};
use std::collections::HashSet;

/// What the next rung does, if there are parts for what the dice choose. The timers and counters in the set have their block.
pub(super) fn act(dice: &mut Dice, typed: &Typed, states: &mut HashSet<String>) -> Option<Act> {
    let path = |dice: &mut Dice, ty: &Ty| typed.path(dice, ty);
    let number = |dice: &mut Dice| typed.path(dice, &Ty::Int);
    Some(match dice.below(16) {
        0 | 1 => {
            let ty = typed.copied(dice)?;
            Act::Move(path(dice, &ty)?, path(dice, &ty)?)
        }
        2 => {
            let ty = typed.copied(dice)?;
            let y = path(dice, &ty)?;
            Act::Select(y, path(dice, &Ty::Bool)?, [path(dice, &ty)?, path(dice, &ty)?])
        }
        3 => {
            let ty = typed.copied(dice)?;
            let y = path(dice, &ty)?;
            let values = [path(dice, &ty)?, path(dice, &ty)?, path(dice, &ty)?];
            Act::Choose(y, Index::Input(dice.below(INPUTS), 0), values)
        }
        4 => Act::Add(number(dice)?, number(dice)?, dice.between(-300, 300)),
        5 => Act::ToPhase(path(dice, &Ty::Phase)?, number(dice)?),
        6 => Act::ToNumber(number(dice)?, path(dice, &Ty::Phase)?),
        7 => Act::Equal(path(dice, &Ty::Phase)?, path(dice, &Ty::Phase)?),
        8 => Act::Contact(path(dice, &Ty::Bool)?),
        9 => Act::Coil(path(dice, &Ty::Bool)?),
        10 => {
            let (array, dimensions, element) = typed.array(dice, None)?;
            let value = path(dice, &element)?;
            Act::Fill(span(dice, array, &dimensions, None), value)
        }
        11 => {
            let (to, dimensions, element) = typed.array(dice, None)?;
            let (from, others, _) = typed.array(dice, Some(&element))?;
            let most = [&dimensions, &others].map(|all| all.last().map_or(0, |(first, last)| last - first));
            let more = dice.between(0, most[0].min(most[1]));
            let to = span(dice, to, &dimensions, Some(more));
            Act::Copy(to, span(dice, from, &others, Some(more)))
        }
        12 => Act::Ton(fresh(path(dice, &Ty::Ton)?, states)?),
        13 => Act::Ctu(fresh(path(dice, &Ty::Ctu)?, states)?),
        14 => {
            let given = [path(dice, &Ty::Bool)?, number(dice)?, number(dice)?];
            Act::Acc(path(dice, &Ty::Acc)?, given)
        }
        _ => Act::Poke(path(dice, &Ty::Structure(CELL))?, number(dice)?),
    })
}

/// Two blocks on one timer or counter are an error, and so is one on a timer that `$Poke` has.
fn fresh(path: Path, states: &mut HashSet<String>) -> Option<Path> {
    (path.steps.len() == 1 && states.insert(path.to_string())).then_some(path)
}

fn span(dice: &mut Dice, array: Path, dimensions: &[(i64, i64)], more: Option<i64>) -> Span {
    let (&(first, last), others) = dimensions.split_last().expect("an array has a dimension");
    let others = others.iter().map(|bounds| index(dice, *bounds)).collect();
    let length = more.unwrap_or_else(|| dice.between(0, last - first));
    let from = dice.between(first, last - length);
    let ends = match (dice.one_in(2), dice.below(INPUTS)) {
        (true, input) => (Index::Input(input, 0), Index::Input(input, length)),
        (false, _) => (Index::Number(from), Index::Number(from + length)),
    };
    Span {
        array,
        indices: (others, ends.0, ends.1),
    }
}

pub(super) fn index(dice: &mut Dice, (first, last): (i64, i64)) -> Index {
    if dice.one_in(2) {
        Index::Input(dice.below(INPUTS), dice.of(&[0, 0, 1, -1]))
    } else {
        Index::Number(dice.between(first, last))
    }
}

impl Typed {
    /// Whether all that a rung names is there and of a type that will do.
    pub(super) fn fits(&self, act: &Act) -> bool {
        let is = |path: &Path, ty: &Ty| self.type_of(path).as_ref() == Some(ty);
        let number = |path: &Path| matches!(self.type_of(path), Some(Ty::Int | Ty::Range(..)));
        let same = |y: &Path, a: &Path| match (self.type_of(y), self.type_of(a)) {
            (Some(y), Some(a)) => y == a && !self.keeps_state(&y),
            _ => false,
        };
        let element = |span: &Span| self.element_of(span);
        match act {
            Act::Move(y, a) => same(y, a),
            Act::Select(y, g, values) => is(g, &Ty::Bool) && values.iter().all(|a| same(y, a)),
            Act::Choose(y, _, values) => values.iter().all(|a| same(y, a)),
            Act::Add(y, a, _) => number(y) && number(a),
            Act::ToPhase(y, a) => is(y, &Ty::Phase) && number(a),
            Act::ToNumber(y, a) => number(y) && is(a, &Ty::Phase),
            Act::Equal(a, b) => is(a, &Ty::Phase) && is(b, &Ty::Phase),
            Act::Contact(a) | Act::Coil(a) => is(a, &Ty::Bool),
            Act::Fill(span, a) => element(span).is_some_and(|ty| is(a, &ty)),
            Act::Copy(to, from) => element(to).is_some() && element(to) == element(from),
            Act::Ton(t) => is(t, &Ty::Ton),
            Act::Ctu(c) => is(c, &Ty::Ctu),
            Act::Acc(state, [x, by, total]) => {
                is(state, &Ty::Acc) && is(x, &Ty::Bool) && number(by) && number(total)
            }
            Act::Poke(cell, by) => is(cell, &Ty::Structure(CELL)) && number(by),
        }
    }
}
