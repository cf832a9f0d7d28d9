//! `[PWL]`: a curve of straight lines, held flat outside.

use super::Operands;
use crate::fault::Trouble;
use crate::memory::{Memory, Word};
use crate::operation::{Width, finite};
use ladder_analysis::values::types::Scalar;

pub(super) fn point(memory: &mut Memory, with: &mut Operands) -> Result<(), Trouble> {
    let (to, ty) = (with.word(), with.ty());
    let x = with.value(memory);
    let list = with.list();
    with.count(list.len());
    let value = |slot: u32| memory.word(Word(slot));
    let points = list.chunks_exact(2).map(|pair| (value(pair[0]), value(pair[1])));
    memory.words[to.0 as usize] = if ty.is_real() {
        let number = |word: i64| f64::from_bits(word as u64);
        let y = on_curve(
            number(x),
            points.map(|(x, y)| (number(x), number(y))),
            |x, (x0, y0), (x1, y1)| y0 + (y1 - y0) * (x - x0) / (x1 - x0),
        );
        finite(y.unwrap_or(0.0), ty == Scalar::Real)?.to_bits() as i64
    } else {
        let width = Width::of(ty);
        let number = |word: i64| width.number(word);
        let y = on_curve(number(x), points.map(|(x, y)| (number(x), number(y))), between);
        width.wrap(y.unwrap_or(0) as i64)
    };
    Ok(())
}

/// The height of the curve at x. Of two points that are one above the other the later one counts.
fn on_curve<N: PartialOrd + Copy>(
    x: N,
    points: impl Iterator<Item = (N, N)>,
    between: impl Fn(N, (N, N), (N, N)) -> N,
) -> Option<N> {
    let mut before: Option<(N, N)> = None;
    for point in points {
        if x < point.0 {
            return Some(match before {
                Some(before) => between(x, before, point),
                None => point.1,
            });
        }
        before = Some(point);
    }
    before.map(|(_, y)| y)
}

/// Cut off toward zero, from the exact value.
fn between(x: i128, (x0, y0): (i128, i128), (x1, y1): (i128, i128)) -> i128 {
    let span = x1 - x0;
    let exact = y0
        .checked_mul(span)
        .zip((y1 - y0).checked_mul(x - x0))
        .and_then(|(base, rise)| base.checked_add(rise));
    match exact {
        Some(scaled) => scaled / span,
        // Only where 64-bit numbers lie as far apart as they can: the last digits do not matter there.
        None => (y0 as f64 + (y1 - y0) as f64 * ((x - x0) as f64 / span as f64)) as i128,
    }
}
