//! When a search must be done, and how much a solver may do for one question.

use crate::wanted::is_wanted;
use batsat::Callbacks;
use std::cell::Cell;
use std::time::{Duration, Instant};

/// When all must be done.
#[derive(Debug, Clone, Copy)]
pub(crate) struct End {
    at: Instant,
}

impl End {
    /// In so long, if not before.
    #[must_use]
    pub(crate) fn within(self, time: Duration) -> End {
        End {
            at: self.at.min(Instant::now() + time),
        }
    }

    /// After a part of the time that is left.
    #[must_use]
    pub(crate) fn part(self, divisor: u32) -> End {
        self.within(self.at.saturating_duration_since(Instant::now()) / divisor)
    }

    /// No time is left, or nobody waits.
    pub(crate) fn is_over(self) -> bool {
        Instant::now() >= self.at || !is_wanted()
    }
}

impl From<Instant> for End {
    fn from(at: Instant) -> End {
        End { at }
    }
}

/// Stops a question that takes too long.
pub(crate) struct Limits {
    end: End,
    /// Conflicts that this question may still have.
    conflicts: Cell<u64>,
    asked: Cell<u32>,
    is_late: Cell<bool>,
}

impl Limits {
    pub(crate) const fn new(end: End, conflicts: u64) -> Limits {
        Limits {
            end,
            conflicts: Cell::new(conflicts),
            asked: Cell::new(0),
            is_late: Cell::new(false),
        }
    }

    /// The next question may have so many conflicts.
    pub(crate) fn allow(&self, conflicts: u64) {
        self.conflicts.set(conflicts);
    }

    pub(crate) fn is_over(&self) -> bool {
        self.end.is_over()
    }
}

impl Callbacks for Limits {
    fn on_new_clause(&mut self, _: &[batsat::Lit], kind: batsat::ClauseKind) {
        if kind == batsat::ClauseKind::Learnt {
            self.conflicts.set(self.conflicts.get().saturating_sub(1));
        }
    }

    fn stop(&self) -> bool {
        let asked = self.asked.get().wrapping_add(1);
        self.asked.set(asked);
        if asked.is_multiple_of(256) && self.end.is_over() {
            self.is_late.set(true);
        }
        self.is_late.get() || self.conflicts.get() == 0
    }
}
