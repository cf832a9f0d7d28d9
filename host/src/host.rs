//! What a server needs of where it runs: files, the time, and a place where its work is done.
//!
//! `ladder lsp` has a runtime with threads, a page one thread for everything. The server knows neither: it asks a [`Host`].

use std::fmt;
use std::pin::pin;
use std::sync::Arc;
use std::task::Context;
use std::time::Duration;

use futures::future::{BoxFuture, Either, select};
use ladder_workspace::Disk;

use crate::wires::Wires;

/// A moment, as the time since a clock began to run.
pub type Moment = Duration;

/// A clock, which goes on and is never set.
#[derive(Clone)]
pub struct Clock(Arc<dyn Fn() -> Moment + Send + Sync>);

impl Clock {
    /// A clock that shows what this says.
    pub fn new(now: impl Fn() -> Moment + Send + Sync + 'static) -> Clock {
        Clock(Arc::new(now))
    }

    /// The time.
    pub fn now(&self) -> Moment {
        (self.0)()
    }
}

impl fmt::Debug for Clock {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Clock({:?})", self.now())
    }
}

/// What a program finds where it runs.
#[derive(Debug, Clone)]
pub struct World {
    /// Its files.
    pub disk: Arc<dyn Disk>,
    /// Its clock.
    pub clock: Clock,
    /// The way to what is outside, if there is one.
    pub wires: Option<Arc<dyn Wires>>,
}

/// Where the server runs.
pub trait Host: fmt::Debug + Send + Sync {
    /// The files and the clock.
    fn world(&self) -> &World;

    /// Does a task. It waits often and works little.
    fn spawn(&self, task: BoxFuture<'static, ()>);

    /// Resolves when this time has passed.
    fn sleep(&self, time: Duration) -> BoxFuture<'static, ()>;

    /// Does work that takes longer than a moment, and may wait for files: where there are threads, on one that keeps no
    /// message waiting.
    fn work(&self, job: Box<dyn FnOnce() + Send>);

    /// Lets something have its turns until it is over: where there are threads, on one of its own with this name.
    ///
    /// # Errors
    /// There is no thread for it: what the operating system says.
    fn give_turns(&self, name: String, turns: Box<dyn Turns>) -> Result<(), String>;

    /// Resolves when the process is gone. Where there are none that is never.
    fn gone(&self, process: u32) -> BoxFuture<'static, ()>;

    /// Whether messages arrive while work is done. Where they do not, work that could go on for ever stops now and then.
    fn hears_while_working(&self) -> bool;
}

/// What goes on by turns, between which it is asked what it waits for.
pub trait Turns: Send {
    /// Does the next piece. The waker of the context is woken when something has arrived.
    fn turn(&mut self, context: &mut Context<'_>) -> Wait;
}

/// What something waits for between two turns. Whatever it is, what arrives comes first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wait {
    /// For nothing: it goes on at once.
    No,
    /// For a moment.
    Until(Moment),
    /// For something to arrive.
    Arrival,
    /// It is over.
    Over,
}

/// What a future resolves to, if it does so in this time.
pub async fn within<T>(host: &dyn Host, time: Duration, future: impl Future<Output = T>) -> Option<T> {
    match select(pin!(future), host.sleep(time)).await {
        Either::Left((value, _)) => Some(value),
        Either::Right(_) => None,
    }
}
