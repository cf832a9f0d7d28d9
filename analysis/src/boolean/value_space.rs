//! The values of a number, as the numbers that it is compared with cut them up.

use super::comparison::order_mask;
use crate::names::operand_value::Number;
use crate::values::types::Scalar;
use ladder_instructions::Op;

/// A number that a value is compared with.
#[derive(Debug, Clone)]
pub(crate) struct Bound {
    pub(crate) at: Number,
    /// As it is written.
    pub(crate) text: String,
}

/// Stretches of values in which every comparison gives one answer: below the first number, equal to it, between
/// it and the next, and so on.
#[derive(Debug, Clone, Default)]
pub(crate) struct Regions {
    /// In rising order, each once.
    bounds: Vec<Bound>,
    /// The stretches that hold a value: `2 i` lies below bound `i`, `2 i + 1` is the bound itself.
    kept: Vec<usize>,
    /// A stretch may hold no value after all.
    pub(crate) some_impossible: bool,
}

impl Regions {
    /// None if a mask has too few bits for them.
    pub(crate) fn new(mut bounds: Vec<Bound>, ty: Option<Scalar>) -> Option<Regions> {
        let whole = bounds.iter().all(|bound| matches!(bound.at, Number::Int(_)));
        let real_type = ty.is_some_and(Scalar::is_real);
        bounds.sort_by(|a, b| match (a.at, b.at) {
            (Number::Int(a), Number::Int(b)) => a.cmp(&b),
            (a, b) => a.real().total_cmp(&b.real()),
        });
        bounds.dedup_by(|a, b| match (a.at, b.at) {
            (Number::Int(a), Number::Int(b)) => a == b,
            (a, b) => a.real().total_cmp(&b.real()).is_eq(),
        });
        let stretches = 0..=2 * bounds.len();
        let kept: Vec<usize> = if whole && !real_type {
            let (low, high) = ty.and_then(Scalar::bounds).unwrap_or((i128::MIN, i128::MAX));
            let at = |index: usize| match bounds[index].at {
                Number::Int(n) => n,
                Number::Real(_) => 0,
            };
            stretches
                .filter(|&stretch| {
                    let index = stretch / 2;
                    let (first, last) = if stretch % 2 == 1 {
                        (at(index), at(index))
                    } else {
                        let first = index
                            .checked_sub(1)
                            .map_or(i128::MIN, |before| at(before).saturating_add(1));
                        let last = if index < bounds.len() {
                            at(index).saturating_sub(1)
                        } else {
                            i128::MAX
                        };
                        (first, last)
                    };
                    first.max(low) <= last.min(high)
                })
                .collect()
        } else {
            stretches.collect()
        };
        (kept.len() <= 64 && !kept.is_empty()).then_some(Regions {
            bounds,
            kept,
            some_impossible: !whole && !real_type,
        })
    }

    /// How many stretches there are.
    pub(crate) fn count(&self) -> usize {
        self.kept.len()
    }

    /// In which of them a comparison with one of the numbers holds.
    pub(crate) fn mask(&self, op: Op, with: Number) -> u64 {
        let same = |bound: &Bound| match (bound.at, with) {
            (Number::Int(a), Number::Int(b)) => a == b,
            (a, b) => a.real().total_cmp(&b.real()).is_eq(),
        };
        let Some(index) = self.bounds.iter().position(same) else {
            return 0;
        };
        let equal = 2 * index + 1;
        self.kept.iter().enumerate().fold(0, |mask, (bit, &stretch)| {
            let order = stretch.cmp(&equal) as i8 + 1;
            mask | (order_mask(op) >> order & 1) << bit
        })
    }

    /// That a value lies in a stretch, as a person says it.
    pub(crate) fn says(&self, name: &str, value: usize) -> String {
        let stretch = self.kept[value];
        let text = |index: usize| self.bounds[index].text.as_str();
        let index = stretch / 2;
        match (stretch % 2, index.checked_sub(1), self.bounds.get(index)) {
            (1, ..) => format!("{name} = {}", text(index)),
            (_, None, Some(_)) => format!("{name} < {}", text(index)),
            (_, Some(below), Some(_)) => format!("{} < {name} < {}", text(below), text(index)),
            (_, Some(below), None) => format!("{name} > {}", text(below)),
            (_, None, None) => name.to_owned(),
        }
    }
}
