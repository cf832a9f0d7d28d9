//! The clock that measures the time of a proof: the operating system's, or another one where there is none.

use std::fmt;
use std::sync::{Arc, LazyLock};
use std::time::{Duration, Instant};

static ORIGIN: LazyLock<Instant> = LazyLock::new(Instant::now);

/// A clock, which goes on and is never set. The default is that of the operating system.
#[derive(Clone, Default)]
pub struct Clock(Option<Arc<dyn Fn() -> Duration + Send + Sync>>);

impl Clock {
    /// A clock that shows what this says: the time since it began to run.
    pub fn new(now: impl Fn() -> Duration + Send + Sync + 'static) -> Clock {
        Clock(Some(Arc::new(now)))
    }

    pub(crate) fn now(&self) -> Duration {
        match &self.0 {
            Some(now) => now(),
            None => ORIGIN.elapsed(),
        }
    }
}

impl fmt::Debug for Clock {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Clock")
    }
}
