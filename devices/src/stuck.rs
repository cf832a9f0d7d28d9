//! A second thread beside the one that scans: it ends a scan that takes too long, and the run where that does not help.

use ladder_analysis::Cancel;
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::Scope;
use std::time::{Duration, Instant};

/// It is looked so often in the time that a scan may take.
const LOOKS: u32 = 4;

/// When the scan began that runs.
#[derive(Debug, Default)]
pub(crate) struct Scanning {
    now: Mutex<Now>,
    over: Condvar,
}

#[derive(Debug, Default)]
struct Now {
    began: Option<Instant>,
    is_over: bool,
}

/// Ends the watch when it is dropped.
pub(crate) struct Watched<'s>(&'s Scanning);

impl Drop for Watched<'_> {
    fn drop(&mut self) {
        self.0.now().is_over = true;
        self.0.over.notify_all();
    }
}

impl Scanning {
    /// A scan begins, or is over.
    pub(crate) fn set(&self, began: Option<Instant>) {
        self.now().began = began;
    }

    /// Watches from a thread of its own. A scan that takes longer than `longest` is cancelled, which stops any program; one that has
    /// not come back after twice as long waits for something else, and `stuck` is called, once.
    pub(crate) fn watch<'s>(
        &'s self,
        scope: &'s Scope<'s, '_>,
        longest: Duration,
        cancel: &'s Cancel,
        stuck: &'s (dyn Fn(Duration) + Sync),
    ) -> Watched<'s> {
        let look = (longest / LOOKS).max(Duration::from_millis(1));
        let watch = move || {
            let mut now = self.now();
            let mut is_told = false;
            while !now.is_over {
                let took = now.began.map(|began| began.elapsed()).unwrap_or_default();
                if took > longest {
                    cancel.cancel();
                }
                if took > longest * 2 && !is_told {
                    is_told = true;
                    drop(now);
                    stuck(took);
                    now = self.now();
                    continue;
                }
                let waited = self.over.wait_timeout(now, look);
                now = waited.unwrap_or_else(PoisonError::into_inner).0;
            }
        };
        // Without a thread the run is as it was before there was one: a scan that takes too long ends it when it is over.
        let _ = std::thread::Builder::new()
            .name("watchdog".to_owned())
            .spawn_scoped(scope, watch);
        Watched(self)
    }

    fn now(&self) -> MutexGuard<'_, Now> {
        self.now.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
