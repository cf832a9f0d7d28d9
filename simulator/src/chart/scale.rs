//! The axis of a track's values.

use super::{Tick, time_axis};
use ladder_analysis::values::types::Scalar;

/// Ticks at round values from the least to the greatest, at most `most` of them and one more. TIME in milliseconds.
pub(super) fn ticks(least: f64, greatest: f64, most: u64, ty: Scalar) -> Vec<Tick> {
    const NANOSECONDS: f64 = 1e6;
    if least >= greatest {
        return vec![Tick {
            at: least,
            text: if ty == Scalar::Time {
                super::duration((least * NANOSECONDS) as i64)
            } else {
                format!("{least}")
            },
        }];
    }
    if ty == Scalar::Time {
        let ticks = time_axis::ticks(least * NANOSECONDS, greatest * NANOSECONDS, most as f64);
        return ticks
            .into_iter()
            .map(|tick| Tick {
                at: tick.at / NANOSECONDS,
                text: tick.text,
            })
            .collect();
    }
    if !(greatest - least).is_finite() {
        let ends = [least, greatest].map(|at| Tick {
            at,
            text: format!("{at:.2e}"),
        });
        return ends.into();
    }
    let is_whole = !ty.is_real();
    let rough = (greatest - least) / most.max(1) as f64;
    let power = libm::pow(10.0, libm::floor(libm::log10(rough)));
    let round = [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .map(|factor| factor * power)
        .find(|step| *step >= rough * (1.0 - 1e-9))
        .unwrap_or(rough);
    let step = if is_whole { round.max(1.0) } else { round };
    let (from, to) = (libm::ceil(least / step), libm::floor(greatest / step));
    let mut ticks = Vec::new();
    let mut number = from;
    while number <= to && (ticks.len() as u64) <= most {
        let value = number * step;
        ticks.push(Tick {
            at: value,
            text: short(value, step),
        });
        number += 1.0;
    }
    ticks
}

/// With as many decimals as it takes to distinguish neighbours.
fn short(value: f64, step: f64) -> String {
    if value != 0.0 && !(1e-4..1e7).contains(&value.abs()) {
        return format!("{value:e}");
    }
    let decimals = libm::ceil(-libm::log10(step)).clamp(0.0, 9.0) as usize;
    format!("{value:.decimals$}")
}
