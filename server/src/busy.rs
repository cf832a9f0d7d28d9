//! Whether work is under way: the end of a session waits for what must be saved, and a recording that is played back for
//! what nobody asked for, so that it says the same each time.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

/// How much work is under way. Clones count together.
#[derive(Debug, Clone, Default)]
pub(crate) struct Busy(Arc<AtomicUsize>);

/// Work that is under way until this is dropped.
#[derive(Debug)]
pub(crate) struct Work(Busy);

impl Busy {
    /// Work begins.
    pub(crate) fn begin(&self) -> Work {
        self.0.fetch_add(1, Ordering::AcqRel);
        Work(self.clone())
    }

    /// Waits until nothing is under way, but no longer than this.
    pub(crate) async fn rest(&self, patience: Duration) {
        let begun = Instant::now();
        while self.0.load(Ordering::Acquire) > 0 && begun.elapsed() < patience {
            tokio::time::sleep(Duration::from_millis(1)).await;
        }
    }
}

impl Drop for Work {
    fn drop(&mut self) {
        self.0.0.fetch_sub(1, Ordering::AcqRel);
    }
}
