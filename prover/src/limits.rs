//! When a search must be done, and how much a solver may do for one question.
//!
//! Only the whole has a time. What its parts may do is counted in steps, so that a busy machine says the same as an idle one.

use crate::clock::now;
use crate::wanted::is_wanted;
use batsat::Callbacks;
use std::cell::Cell;
use std::time::Duration;

/// Why nothing more of a program is followed once that is so.
pub(crate) const LATE: &str = "the time was over before all of the program was followed";

/// When all must be done; without a time, when nobody waits.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct End {
    at: Option<Duration>,
}

impl End {
    /// When so much time has passed.
    pub(crate) fn after(time: Duration) -> End {
        End {
            at: Some(now() + time),
        }
    }

    /// No time is left, or nobody waits.
    pub(crate) fn is_over(self) -> bool {
        self.at.is_some_and(|at| now() >= at) || !is_wanted()
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
