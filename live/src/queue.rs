//! Which commands wait for a simulation, and when what runs gives way to them.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::time::Duration;

use crate::action::Action;
use ladder_analysis::Cancel;
use ladder_host::{Clock, Host};

/// What runs gives way to a command that is not urgent when it has taken this long.
const PATIENCE: Duration = Duration::from_secs(1);

/// Where no command arrives while there is work, a scan gives way after this time, and begins again.
const DEAF: Duration = Duration::from_millis(500);

/// A step, or the recording of a scenario, takes this long at most: a client that has asked for a billion scans is answered.
const LONGEST: Duration = Duration::from_secs(10);

/// The commands that were sent to a simulation and are not taken up yet, and when the work under way began.
#[derive(Debug)]
pub(crate) struct Queue {
    /// How many urgent commands wait.
    pub(crate) urgent: Arc<AtomicUsize>,
    /// How many texts wait to be followed.
    texts: AtomicUsize,
    /// How many commands wait whose senders wait for the answer.
    awaited: AtomicUsize,
    clock: Clock,
    /// Whether commands arrive while there is work.
    hears: bool,
    /// When the work under way began, in milliseconds.
    begun: AtomicU64,
}

impl Queue {
    pub(crate) fn new(host: &dyn Host) -> Arc<Queue> {
        Arc::new(Queue {
            urgent: Arc::default(),
            texts: AtomicUsize::new(0),
            awaited: AtomicUsize::new(0),
            clock: host.world().clock.clone(),
            hears: host.hears_while_working(),
            begun: AtomicU64::new(0),
        })
    }

    /// An action is sent.
    pub(crate) fn enter(&self, action: &Action) {
        for counter in self.counters(action) {
            counter.fetch_add(1, Ordering::SeqCst);
        }
    }

    /// It is taken up.
    pub(crate) fn leave(&self, action: &Action) {
        for counter in self.counters(action) {
            counter.fetch_sub(1, Ordering::SeqCst);
        }
        self.begin();
    }

    fn counters(&self, action: &Action) -> impl Iterator<Item = &AtomicUsize> {
        let urgent = action.is_urgent().then_some(&*self.urgent);
        let text = matches!(action, Action::Follow(_)).then_some(&self.texts);
        let awaited = action.is_awaited().then_some(&self.awaited);
        [urgent, text, awaited].into_iter().flatten()
    }

    /// Whether a newer text waits to be followed.
    pub(crate) fn has_text(&self) -> bool {
        self.texts.load(Ordering::SeqCst) > 0
    }

    /// A command, or a scan of a run, begins.
    pub(crate) fn begin(&self) {
        self.begun.store(self.now(), Ordering::SeqCst);
    }

    fn now(&self) -> u64 {
        u64::try_from(self.clock.now().as_millis()).unwrap_or(u64::MAX)
    }

    fn has_taken(&self, time: Duration) -> bool {
        let begun = self.begun.load(Ordering::SeqCst);
        u128::from(self.now().saturating_sub(begun)) >= time.as_millis()
    }

    fn is_pressing(&self) -> bool {
        self.urgent.load(Ordering::SeqCst) > 0
            || (self.awaited.load(Ordering::SeqCst) > 0 && self.has_taken(PATIENCE))
    }

    /// Cancels a scan of a run that takes long, so that the session can serve a command.
    pub(crate) fn cancel_of_run(self: &Arc<Self>) -> Cancel {
        let queue = self.clone();
        Cancel::when(move || queue.is_pressing() || (!queue.hears && queue.has_taken(DEAF)))
    }

    /// Cancels what a command does.
    pub(crate) fn cancel_of_command(self: &Arc<Self>, cancel: &Cancel) -> Cancel {
        let (queue, cancel) = (self.clone(), cancel.clone());
        Cancel::when(move || cancel.is_cancelled() || queue.is_pressing() || queue.has_taken(LONGEST))
    }
}
