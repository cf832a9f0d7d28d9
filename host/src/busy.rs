//! Whether work is under way: the end of a session waits for what must be saved, and a recording that is played back for
//! what nobody asked for, so that it says the same each time.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

use crate::host::Host;

/// How much work is under way. Clones count together.
#[derive(Debug, Clone, Default)]
pub struct Busy(Arc<AtomicUsize>);

/// Work that is under way until this is dropped.
#[derive(Debug)]
pub struct Work(Busy);

impl Busy {
    /// Work begins.
    pub fn begin(&self) -> Work {
        self.0.fetch_add(1, Ordering::AcqRel);
        Work(self.clone())
    }

    /// Waits until nothing is under way, but no longer than this.
    pub async fn rest(&self, host: &dyn Host, patience: Duration) {
        let clock = &host.world().clock;
        let end = clock.now() + patience;
        while self.0.load(Ordering::Acquire) > 0 && clock.now() < end {
            host.sleep(Duration::from_millis(1)).await;
        }
    }
}

impl Drop for Work {
    fn drop(&mut self) {
        self.0.0.fetch_sub(1, Ordering::AcqRel);
    }
}
