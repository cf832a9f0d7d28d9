//! How late scans were, and how long they took.

use hdrhistogram::Histogram;
use std::fmt;
use std::time::Duration;

/// Longer times, in nanoseconds, count as this one: an hour.
const LONGEST: u64 = 3_600_000_000_000;

/// Durations by how many of them there were.
#[derive(Debug, Clone)]
pub struct Times(Histogram<u64>);

impl Default for Times {
    fn default() -> Times {
        // All the room at once: counting allocates nothing.
        Times(Histogram::new_with_bounds(1, LONGEST, 2).expect("bounds that are apart, and two digits"))
    }
}

impl Times {
    /// One more.
    pub fn add(&mut self, time: Duration) {
        let nanos = u64::try_from(time.as_nanos()).unwrap_or(LONGEST);
        self.0.saturating_record(nanos.clamp(1, LONGEST));
    }

    /// Of 100 times so many are not longer than this one.
    pub fn percentile(&self, percent: f64) -> Duration {
        Duration::from_nanos(self.0.value_at_percentile(percent))
    }

    /// The longest.
    pub fn max(&self) -> Duration {
        Duration::from_nanos(self.0.max())
    }
}

impl fmt::Display for Times {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [half, most, max] = [self.percentile(50.0), self.percentile(99.0), self.max()].map(shown);
        write!(f, "50 % {half}, 99 % {most}, at most {max}")
    }
}

/// What a run was like so far.
#[derive(Debug, Clone, Default)]
pub struct Report {
    /// How many scans ran.
    pub scans: u64,
    /// How many slots passed without a scan, because the one before took too long or the machine was busy.
    pub missed: u64,
    /// How much after their time scans began.
    pub lateness: Times,
    /// How long they took.
    pub scan_times: Times,
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} scans, {} missed; late: {}; a scan takes: {}",
            self.scans, self.missed, self.lateness, self.scan_times
        )
    }
}

/// A duration with three digits, in the unit that people would take.
fn shown(time: Duration) -> String {
    let micros = time.as_nanos() as f64 / 1_000.0;
    match micros {
        ..1_000.0 => format!("{micros:.0} µs"),
        ..1_000_000.0 => format!("{:.1} ms", micros / 1_000.0),
        _ => format!("{:.2} s", micros / 1_000_000.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use expect_test::expect;

    #[test]
    fn a_report_is_a_line() {
        let mut report = Report {
            scans: 100,
            missed: 2,
            ..Report::default()
        };
        for n in 0..100 {
            report.lateness.add(Duration::from_micros(70 + n / 50));
            report.scan_times.add(Duration::from_micros(n * 100));
        }
        report.lateness.add(Duration::from_millis(2500));
        expect!["100 scans, 2 missed; late: 50 % 71 µs, 99 % 71 µs, at most 2.52 s; a scan takes: 50 % 4.9 ms, 99 % 9.8 ms, at most 10.0 ms"]
            .assert_eq(&report.to_string());
    }

    #[test]
    fn nothing_yet() {
        assert_eq!(Times::default().max(), Duration::ZERO);
    }
}
