//! The server with a runtime, threads, the files of the operating system and its clock.

mod parent;
#[cfg(feature = "online")]
mod wires;

use std::sync::Arc;
use std::task::{Context, Wake, Waker};
use std::thread::{self, Thread};
use std::time::{Duration, Instant};

use futures::FutureExt;
use futures::future::BoxFuture;
use ladder_host::{Clock, Host, Turns, Wait, World};
use ladder_workspace::SystemDisk;
use tokio::runtime::Handle;

/// The files of the operating system, and its clock.
pub(crate) fn world() -> World {
    let begun = Instant::now();
    World {
        disk: Arc::new(SystemDisk),
        clock: Clock::new(move || begun.elapsed()),
        #[cfg(feature = "online")]
        wires: Some(Arc::new(wires::Network)),
        #[cfg(not(feature = "online"))]
        wires: None,
    }
}

/// A host with threads.
#[derive(Debug)]
pub(crate) struct Native {
    world: World,
    runtime: Handle,
}

impl Native {
    /// The host in whose runtime this is called.
    pub(crate) fn here() -> Arc<Native> {
        Arc::new(Native {
            world: world(),
            runtime: Handle::current(),
        })
    }
}

impl Host for Native {
    fn world(&self) -> &World {
        &self.world
    }

    fn spawn(&self, task: BoxFuture<'static, ()>) {
        self.runtime.spawn(task);
    }

    fn sleep(&self, time: Duration) -> BoxFuture<'static, ()> {
        let _runtime = self.runtime.enter();
        tokio::time::sleep(time).boxed()
    }

    fn work(&self, job: Box<dyn FnOnce() + Send>) {
        self.runtime.spawn_blocking(job);
    }

    fn give_turns(&self, name: String, turns: Box<dyn Turns>) -> Result<(), String> {
        let clock = self.world.clock.clone();
        thread::Builder::new()
            .name(name)
            .spawn(move || take_turns(turns, &clock))
            .map(|_| ())
            .map_err(|error| error.to_string())
    }

    fn gone(&self, process: u32) -> BoxFuture<'static, ()> {
        parent::gone(process).boxed()
    }

    fn hears_while_working(&self) -> bool {
        true
    }
}

/// Wakes a thread that waits.
struct Rouse(Thread);

impl Wake for Rouse {
    fn wake(self: Arc<Self>) {
        self.0.unpark();
    }
}

fn take_turns(mut turns: Box<dyn Turns>, clock: &Clock) {
    let waker = Waker::from(Arc::new(Rouse(thread::current())));
    let mut context = Context::from_waker(&waker);
    loop {
        match turns.turn(&mut context) {
            Wait::No => {}
            Wait::Until(moment) => thread::park_timeout(moment.saturating_sub(clock.now())),
            Wait::Arrival => thread::park(),
            Wait::Over => return,
        }
    }
}
