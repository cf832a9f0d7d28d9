//! Giving memory back when the server has come to rest.
//!
//! A thread keeps the pages of memory that it worked with, also empty ones, and the allocator gives pages back to the
//! system a second after they became free at the earliest, and only when some thread asks it for more or ends. Nobody
//! does when the person stops typing: what a large answer took would stay until the next one. So threads that have waited
//! in vain for [`PATIENCE`] end, and after the last of them one is started only to end: with it goes what the others left.

use std::hint::black_box;
use std::sync::Arc;
use std::thread;
use std::time::Duration;

use tokio::sync::Notify;
use tokio::time::timeout;

/// So long a thread waits for work. Who types has a thread that is awake.
pub(crate) const PATIENCE: Duration = Duration::from_secs(2);

/// Longer than the allocator waits before it gives back what is free: a second.
const DELAY: Duration = Duration::from_millis(1_100);

/// Whether threads have ended. Clones hear of the same threads.
#[derive(Debug, Clone, Default)]
pub(crate) struct Settling(Arc<Notify>);

impl Settling {
    /// A thread of the runtime ends.
    pub(crate) fn thread_ended(&self) {
        self.0.notify_one();
    }

    /// Ends a thread, which has asked the allocator for something, whenever others have ended and none did since.
    pub(crate) async fn watch(self) {
        loop {
            self.0.notified().await;
            while timeout(DELAY, self.0.notified()).await.is_ok() {}
            let _ = thread::Builder::new().spawn(|| drop(black_box(Vec::<u8>::with_capacity(64))));
        }
    }
}
