//! When a search must be done, and how much a solver may do for one question.
//!
//! Only the whole has a time. What its parts may do is counted in steps, so that a busy machine says the same as an idle one.

use crate::clock::Clock;
use batsat::Callbacks;
use ladder_analysis::Cancel;
use std::cell::Cell;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

/// Why nothing more of a program is followed once that is so.
pub(crate) const LATE: &str = "the time was over before all of the program was followed";

/// When all must be done: no time or no work is left then, or nobody waits any more. By default that is never.
#[derive(Debug, Clone, Default)]
pub(crate) struct End {
    at: Option<Duration>,
    /// How many steps all solvers together may still make; as many as they like without it.
    work: Option<Arc<AtomicU64>>,
    clock: Clock,
    cancel: Cancel,
}

impl End {
    /// When so much time has passed, or once it is cancelled.
    pub(crate) fn after(time: Duration, clock: &Clock, cancel: &Cancel) -> End {
        End {
            at: Some(clock.now() + time),
            work: None,
            clock: clock.clone(),
            cancel: cancel.clone(),
        }
    }

    /// The same with so many steps of solvers at most.
    #[must_use]
    pub(crate) fn with_work(self, steps: Option<u64>) -> End {
        let work = steps.map(|steps| Arc::new(AtomicU64::new(steps)));
        End { work, ..self }
    }

    pub(crate) fn is_over(&self) -> bool {
        self.is_spent() || self.at.is_some_and(|at| self.clock.now() >= at) || self.cancel.is_cancelled()
    }

    /// Whether all steps are made.
    fn is_spent(&self) -> bool {
        let work = self.work.as_ref();
        work.is_some_and(|left| left.load(Ordering::Relaxed) == 0)
    }

    /// A solver makes a step. Whether it was the last.
    fn spend(&self) -> bool {
        let Some(left) = &self.work else { return false };
        let before = left.fetch_update(Ordering::Relaxed, Ordering::Relaxed, |left| left.checked_sub(1));
        before.is_err()
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
    pub(crate) fn new(end: End, conflicts: u64) -> Limits {
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
        if self.end.spend() || (asked.is_multiple_of(256) && self.end.is_over()) {
            self.is_late.set(true);
        }
        self.is_late.get() || self.conflicts.get() == 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Arc;
    use std::sync::atomic::{AtomicU64, Ordering};

    impl End {
        /// The same, by the clock of the operating system.
        pub(crate) fn in_time(time: Duration) -> End {
            End::after(time, &Clock::default(), &Cancel::default())
        }
    }

    #[test]
    fn it_is_over_when_nobody_waits() {
        let cancel = Cancel::default();
        let end = End::after(Duration::from_secs(60), &Clock::default(), &cancel);
        assert!(!end.is_over());
        cancel.cancel();
        assert!(end.is_over());
        assert!(End::in_time(Duration::ZERO).is_over());
        assert!(!End::default().is_over());
    }

    #[test]
    fn it_is_over_when_the_work_is_done() {
        let end = End::default().with_work(Some(2));
        assert!(!end.spend() && !end.is_over());
        assert!(!end.spend() && end.is_over());
        assert!(end.spend() && end.clone().is_over());
    }

    #[test]
    fn the_time_is_that_of_the_clock_that_is_given() {
        let time = Arc::<AtomicU64>::default();
        let shown = time.clone();
        let clock = Clock::new(move || Duration::from_secs(shown.load(Ordering::Relaxed)));
        let end = End::after(Duration::from_secs(60), &clock, &Cancel::default());
        assert!(!end.is_over());
        time.store(60, Ordering::Relaxed);
        assert!(end.is_over());
    }
}
