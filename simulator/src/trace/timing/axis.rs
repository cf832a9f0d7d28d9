//! The time axis: where its ticks stand, and what they say.

/// A tick: its time in nanoseconds, and its label.
pub(super) struct Tick {
    pub(super) time: f64,
    pub(super) label: String,
}

/// Ticks at round times up to `end` (nanoseconds), at most `most` of them.
pub(super) fn ticks(end: f64, most: f64) -> Vec<Tick> {
    let step = step(end / most.max(1.0));
    let last = (end / step * (1.0 + 1e-9)) as u32;
    (0..=last)
        .map(|n| f64::from(n) * step)
        .map(|time| Tick {
            time,
            label: label(time, step),
        })
        .collect()
}

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
fn label(time: f64, step: f64) -> String {
    if time == 0.0 {
        return "0".to_owned();
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

    fn labels(end: f64) -> String {
        let labels: Vec<String> = ticks(end, 6.0).into_iter().map(|tick| tick.label).collect();
        labels.join(", ")
    }

    #[test]
    fn ticks_stand_at_round_times() {
        let all: Vec<String> = [40.0, 90e6, 600e6, 9e9, 100e9, 4000e9, 200_000e9, 9e15]
            .into_iter()
            .map(labels)
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
}
