//! How fast the simulation's clock goes next to the real one.

use std::fmt;
use std::time::Duration;

/// A real-time factor, or as fast as the machine can.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Speed(usize);

/// In tenths.
const TENTHS: [u64; 10] = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000];

impl Default for Speed {
    /// Real time.
    fn default() -> Self {
        Speed(3)
    }
}

impl Speed {
    pub(super) fn faster(self) -> Speed {
        Speed((self.0 + 1).min(TENTHS.len()))
    }

    pub(super) fn slower(self) -> Speed {
        Speed(self.0.saturating_sub(1))
    }

    /// How much simulated time passes in a span of real time. None: as much as can be.
    pub(super) fn simulated(self, real: Duration) -> Option<i64> {
        let tenths = TENTHS.get(self.0)?;
        Some((real.as_nanos() as u64).saturating_mul(*tenths) as i64 / 10)
    }
}

impl fmt::Display for Speed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match TENTHS.get(self.0) {
            Some(tenths) if tenths % 10 == 0 => write!(f, "{}x", tenths / 10),
            Some(tenths) => write!(f, "0.{tenths}x"),
            None => f.write_str("max"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn from_slow_to_fast() {
        let mut speed = Speed(0);
        let mut shown = vec![speed.to_string()];
        while speed.faster() != speed {
            speed = speed.faster();
            shown.push(speed.to_string());
        }
        assert_eq!(shown.join(" "), "0.1x 0.2x 0.5x 1x 2x 5x 10x 20x 50x 100x max");
        assert_eq!(Speed::default().to_string(), "1x");
        assert_eq!(Speed(0).slower(), Speed(0));
    }

    #[test]
    fn time_passes() {
        let real = Duration::from_millis(40);
        assert_eq!(Speed(0).simulated(real), Some(4_000_000));
        assert_eq!(Speed::default().simulated(real), Some(40_000_000));
        assert_eq!(Speed(9).simulated(real), Some(4_000_000_000));
        assert_eq!(Speed(10).simulated(real), None);
    }
}
