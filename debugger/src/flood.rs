//! Log points write no faster than an editor shows: one that is flooded can neither show nor stop anything any more.

use std::time::Duration;

use ladder_host::Moment;

/// So many lines are written at once ..
const MOST: usize = 100;
/// .. and no more in this time.
const WINDOW: Duration = Duration::from_millis(100);

/// How much was written lately.
#[derive(Debug, Default)]
pub(crate) struct Flood {
    begun: Moment,
    written: usize,
}

impl Flood {
    /// Something is written.
    pub(crate) fn add(&mut self, now: Moment) {
        if now >= self.begun + WINDOW {
            *self = Flood {
                begun: now,
                written: 0,
            };
        }
        self.written += 1;
    }

    /// When the program may go on, if it has written too much.
    pub(crate) fn until(&self) -> Option<Moment> {
        (self.written >= MOST).then(|| self.begun + WINDOW)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_program_waits_once_it_has_written_too_much() {
        let at = Duration::from_millis;
        let mut flood = Flood::default();
        (0..MOST - 1).for_each(|_| flood.add(at(500)));
        assert_eq!(flood.until(), None);
        flood.add(at(599));
        assert_eq!(flood.until(), Some(at(600)));
        flood.add(at(600));
        assert_eq!(flood.until(), None);
    }
}
