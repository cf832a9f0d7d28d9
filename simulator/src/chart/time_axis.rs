//! The time axis: where its ticks are, and what they say.

use super::Tick;
use crate::value_text;

/// Ticks at round times from `first` to `last` (nanoseconds), at most `most` of them and one more.
pub(crate) fn ticks(first: f64, last: f64, most: f64) -> Vec<Tick> {
    let step = step((last - first) / most.max(1.0));
    let from = libm::ceil(first / step - ROUNDING) as i64;
    let to = libm::floor(last / step + ROUNDING) as i64;
    (from..=to)
        .take(most.max(1.0) as usize + 2)
        .map(|n| n as f64 * step)
        .map(|time| Tick {
            at: time,
            text: label(time, step, last),
        })
        .collect()
}

/// What is lost where times are computed, in steps.
const ROUNDING: f64 = 1e-6;

const SECOND: f64 = 1e9;

/// The smallest round duration that is at least so long.
fn step(least: f64) -> f64 {
    if least > SECOND {
        // Seconds, minutes, hours, days as clocks have them.
        let clock = [
            1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 60.0, 120.0, 300.0, 600.0, 900.0, 1800.0, 3600.0, 7200.0,
            10800.0, 21600.0, 43200.0, 86400.0,
        ];
        if let Some(found) = clock.into_iter().map(|s| s * SECOND).find(|s| *s >= least) {
            return found;
        }
    }
    let unit = if least > SECOND { 86400.0 * SECOND } else { 1.0 };
    let power = libm::pow(10.0, libm::floor(libm::log10(least.max(1.0) / unit)));
    [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .map(|round| round * power * unit)
        .find(|round| *round >= least * (1.0 - 1e-9))
        .unwrap_or(least)
}

/// `0`, `500 ms`, `1.5 s`, `1m30`: the unit goes with the distance of the ticks, so that all of them have the same.
fn label(time: f64, step: f64, last: f64) -> String {
    if time == 0.0 {
        return "0".to_owned();
    }
    if time < 0.0 {
        return format!("-{}", label(-time, step, last));
    }
    if (SECOND / 1000.0..60.0 * SECOND).contains(&step) && last >= 120.0 * SECOND {
        // Far from the start seconds alone would be counted in thousands.
        let rounded = (libm::round(time / 1e6) as i64).saturating_mul(1_000_000);
        return value_text::duration(rounded);
    }
    if step >= 60.0 * SECOND {
        let minutes = (time / SECOND / 60.0) as u64;
        return match (minutes / 60, minutes % 60) {
            (0, minutes) => format!("{minutes} min"),
            (hours, 0) => format!("{hours} h"),
            (hours, minutes) => format!("{hours} h {minutes:02}"),
        };
    }
    let (size, unit) = match step {
        step if step >= SECOND / 10.0 => (SECOND, "s"),
        step if step >= 1e5 => (1e6, "ms"),
        step if step >= 1e2 => (1e3, "µs"),
        _ => (1.0, "ns"),
    };
    // Shortest, without the noise of the last digit.
    let number = libm::round(time / size * 1000.0) / 1000.0;
    format!("{number} {unit}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use expect_test::expect;

    fn labels(first: f64, last: f64) -> String {
        let labels: Vec<String> = ticks(first, last, 6.0)
            .into_iter()
            .map(|tick| tick.text)
            .collect();
        labels.join(", ")
    }

    #[test]
    fn ticks_stand_at_round_times() {
        let all: Vec<String> = [40.0, 90e6, 600e6, 9e9, 100e9, 4000e9, 200_000e9, 9e15]
            .into_iter()
            .map(|last| labels(0.0, last))
            .collect();
        expect![[r#"
            0, 10 ns, 20 ns, 30 ns, 40 ns
            0, 20 ms, 40 ms, 60 ms, 80 ms
            0, 0.1 s, 0.2 s, 0.3 s, 0.4 s, 0.5 s, 0.6 s
            0, 2 s, 4 s, 6 s, 8 s
            0, 30 s, 60 s, 90 s
            0, 15 min, 30 min, 45 min, 1 h
            0, 12 h, 24 h, 36 h, 48 h
            0, 480 h, 960 h, 1440 h, 1920 h, 2400 h"#]]
        .assert_eq(&all.join("\n"));
    }

    #[test]
    fn a_window_has_only_its_own_ticks() {
        let all: Vec<String> = [
            (95e6, 180e6),
            (1.45e9, 2.61e9),
            (119e9, 121.4e9),
            (7200e9, 7200.5e9),
            (-5e9, 5e9),
            (5e9, 5e9),
        ]
        .into_iter()
        .map(|(first, last)| labels(first, last))
        .collect();
        expect![[r#"
            100 ms, 120 ms, 140 ms, 160 ms, 180 ms
            1.6 s, 1.8 s, 2 s, 2.2 s, 2.4 s, 2.6 s
            1m59s, 1m59s500ms, 2m, 2m500ms, 2m1s
            2h, 2h100ms, 2h200ms, 2h300ms, 2h400ms, 2h500ms
            -4 s, -2 s, 0, 2 s, 4 s
            5000000000 ns"#]]
        .assert_eq(&all.join("\n"));
    }
}
