//! A running program that is changed: what has the same path keeps its value where its type allows, all else starts as it is declared.

use super::{Running, Value};
use crate::generator::typed::{Ty, Typed};

impl Running {
    /// Goes on with another form of the program.
    pub fn change(&mut self, program: &Typed) {
        let was = std::mem::replace(self, Running::new(program));
        for (at, tag) in program.tags.iter().enumerate() {
            if let Some((number, old)) = was.program.tag(&tag.name) {
                let value = &was.tags[number];
                keep(&was.program, &old.ty, value, program, &tag.ty, &mut self.tags[at]);
            }
        }
        for (number, done) in &was.done {
            if let Some(is) = self.done.get_mut(number) {
                *is = *done;
            }
        }
        (self.now, self.switches, self.numbers) = (was.now, was.switches, was.numbers);
    }
}

/// Keeps what a part held.
fn keep(old: &Typed, was: &Ty, value: &Value, new: &Typed, is: &Ty, to: &mut Value) {
    match (old.unnamed(was), value, new.unnamed(is), &mut *to) {
        (Ty::Phase, Value::One(number), Ty::Phase, Value::One(to)) => {
            if old.phase.name != new.phase.name && old.phase.values != new.phase.values {
                return;
            }
            let held = old.phase.values.iter().find(|(_, own)| own == number);
            let now = held.and_then(|(held, _)| new.phase.values.iter().find(|(name, _)| name == held));
            if let Some((_, number)) = now {
                *to = *number;
            }
        }
        (Ty::Structure(was), Value::Many(values), Ty::Structure(is), Value::Many(parts)) => {
            let members = new.structures[*is].members.iter().zip(parts);
            for (member, part) in members {
                if let Some((at, former)) = old.member(*was, &member.name) {
                    keep(old, &former.ty, &values[at], new, &member.ty, part);
                }
            }
        }
        (Ty::Array(was, element), Value::Many(values), Ty::Array(is, now), Value::Many(parts)) => {
            if was.len() != is.len() {
                return;
            }
            for (number, part) in parts.iter_mut().enumerate() {
                if let Some(at) = place(was, &indices(is, number)) {
                    keep(old, element, &values[at], new, now, part);
                }
            }
        }
        (Ty::Bool, _, Ty::Bool, to) | (Ty::Int | Ty::Range(..), _, Ty::Int | Ty::Range(..), to) => {
            to.clone_from(value);
        }
        (Ty::Ton, _, Ty::Ton, to) | (Ty::Ctu, _, Ty::Ctu, to) | (Ty::Acc, _, Ty::Acc, to) => {
            to.clone_from(value);
        }
        _ => {}
    }
}

/// The indices of an element of an array, row by row.
fn indices(dimensions: &[(i64, i64)], number: usize) -> Vec<i64> {
    let mut rest = number as i64;
    let mut indices = Vec::new();
    for (first, last) in dimensions.iter().rev() {
        let count = last - first + 1;
        indices.push(first + rest % count);
        rest /= count;
    }
    indices.reverse();
    indices
}

/// Where the element with these indices is.
fn place(dimensions: &[(i64, i64)], indices: &[i64]) -> Option<usize> {
    let mut at = 0;
    for ((first, last), index) in dimensions.iter().zip(indices) {
        if !(first..=last).contains(&index) {
            return None;
        }
        at = at * (last - first + 1) + (index - first);
    }
    Some(at as usize)
}
