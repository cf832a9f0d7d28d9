//! When scans are due.

use std::time::{Duration, Instant};

/// Slots at absolute times: slot k is k intervals after the start.
#[derive(Debug, Clone)]
pub struct Pace {
    start: Instant,
    interval: Duration,
    /// The slot of the scan that runs, or that ran last.
    slot: u64,
}

/// The next slot.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Due {
    /// When its scan is to begin.
    pub at: Instant,
    /// So many slots before it have passed without a scan.
    pub missed: u64,
}

impl Pace {
    /// The first slot is at the start.
    pub fn new(start: Instant, interval: Duration) -> Pace {
        Pace {
            start,
            interval: interval.max(Duration::from_nanos(1)),
            slot: 0,
        }
    }

    /// The slot after the one whose scan has ended. Who comes late for it by less than an interval runs at once; slots
    /// that have passed wholly are missed, and never caught up.
    pub fn next(&mut self, now: Instant) -> Due {
        let next = self.slot + 1;
        let passed = now.saturating_duration_since(self.start);
        let reached = u64::try_from(passed.as_nanos() / self.interval.as_nanos()).unwrap_or(u64::MAX);
        self.slot = next.max(reached);
        Due {
            at: self.start + self.offset(self.slot),
            missed: self.slot - next,
        }
    }

    fn offset(&self, slot: u64) -> Duration {
        let nanos = self.interval.as_nanos().saturating_mul(u128::from(slot));
        Duration::from_nanos(u64::try_from(nanos).unwrap_or(u64::MAX))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MS: Duration = Duration::from_millis(1);

    /// For each time at which a scan ends, in ms, the slot that follows and how many were missed.
    fn slots(ends: &[u32]) -> Vec<(u128, u64)> {
        let start = Instant::now();
        let mut pace = Pace::new(start, 10 * MS);
        let next = |end: &u32| {
            let due = pace.next(start + *end * MS);
            ((due.at - start).as_millis(), due.missed)
        };
        ends.iter().map(next).collect()
    }

    #[test]
    fn lateness_does_not_add_up() {
        assert_eq!(slots(&[1, 13, 29]), [(10, 0), (20, 0), (30, 0)]);
    }

    #[test]
    fn a_scan_that_ends_late_is_followed_at_once_or_in_the_next_slot() {
        // The slot at 10 ms has begun, and is not over.
        assert_eq!(slots(&[14, 15]), [(10, 0), (20, 0)]);
        // Those at 10, 20 and 30 ms have passed.
        assert_eq!(slots(&[47, 48]), [(40, 3), (50, 0)]);
    }

    #[test]
    fn a_clock_that_goes_back_waits() {
        assert_eq!(slots(&[47, 5]), [(40, 3), (50, 0)]);
    }
}
