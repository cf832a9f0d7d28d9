//! A host for tests: files in memory, and a clock that goes on only when there is nothing else to do.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::task::{Context, Poll, Waker};
use std::time::{Duration, Instant};

use ladder_workspace::{MemoryDisk, SystemDisk};

use crate::event_loop::Alarm;
use crate::event_loop::EventLoop;
use crate::host::{Clock, Wait, World};

/// The files and the clock of the operating system.
pub fn on_disk() -> World {
    let begun = Instant::now();
    World {
        disk: Arc::new(SystemDisk),
        clock: Clock::new(move || begun.elapsed()),
        wires: None,
    }
}

/// A loop with its clock.
#[derive(Debug, Clone)]
pub struct TestHost {
    /// The loop.
    pub host: Arc<EventLoop>,
    /// In nanoseconds.
    time: Arc<AtomicU64>,
}

impl Default for TestHost {
    /// A loop in which nothing is to be done yet, with no file.
    fn default() -> TestHost {
        let time = Arc::<AtomicU64>::default();
        let shown = time.clone();
        let world = World {
            disk: Arc::new(MemoryDisk::default()),
            clock: Clock::new(move || Duration::from_nanos(shown.load(Ordering::Relaxed))),
            wires: None,
        };
        TestHost {
            host: Arc::new(EventLoop::new(world)),
            time,
        }
    }
}

impl TestHost {
    /// What a future resolves to, which the loop helps to get there.
    ///
    /// # Panics
    /// It waits for what never comes.
    pub fn run<T>(&self, future: impl Future<Output = T>) -> T {
        let mut future = std::pin::pin!(future);
        let alarm = Arc::new(Alarm(AtomicBool::new(true)));
        let waker = Waker::from(alarm.clone());
        loop {
            if alarm.0.swap(false, Ordering::AcqRel)
                && let Poll::Ready(value) = future.as_mut().poll(&mut Context::from_waker(&waker))
            {
                return value;
            }
            match self.host.turn(Duration::ZERO) {
                _ if alarm.0.load(Ordering::Acquire) => {}
                Wait::Until(moment) => self.time.store(moment.as_nanos() as u64, Ordering::Relaxed),
                Wait::No | Wait::Over => {}
                Wait::Arrival => panic!("nothing more happens"),
            }
        }
    }
}
