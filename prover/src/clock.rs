//! The clock that measures the time of a proof: the operating system's, or another one where there is none.

use std::cell::RefCell;
use std::sync::LazyLock;
use std::time::{Duration, Instant};

type Clock = Box<dyn Fn() -> Duration>;

thread_local! {
    /// Of the job that this thread does.
    static CLOCK: RefCell<Option<Clock>> = const { RefCell::new(None) };
}

static ORIGIN: LazyLock<Instant> = LazyLock::new(Instant::now);

/// Forgets at the end of a job, and after a panic in it, too.
struct Forget;

impl Drop for Forget {
    fn drop(&mut self) {
        CLOCK.set(None);
    }
}

/// Does a job on this thread whose proofs take their time from this clock.
pub fn by_clock<T>(clock: impl Fn() -> Duration + 'static, job: impl FnOnce() -> T) -> T {
    CLOCK.set(Some(Box::new(clock)));
    let _forget = Forget;
    job()
}

/// The time since the clock began to run.
pub(crate) fn now() -> Duration {
    CLOCK.with_borrow(|clock| match clock {
        Some(clock) => clock(),
        None => ORIGIN.elapsed(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::limits::End;
    use std::cell::Cell;
    use std::rc::Rc;

    #[test]
    fn the_time_is_that_of_the_clock_that_is_given() {
        let time = Rc::new(Cell::new(Duration::ZERO));
        let shown = time.clone();
        by_clock(
            move || shown.get(),
            || {
                let end = End::after(Duration::from_secs(60));
                assert!(!end.is_over());
                time.set(Duration::from_secs(60));
                assert!(end.is_over());
            },
        );
        assert!(!End::after(Duration::from_secs(60)).is_over());
    }
}
