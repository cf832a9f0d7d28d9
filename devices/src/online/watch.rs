//! The thread that reads a controller again and again, and what it has read last.

use super::{Found, Source};
use ladder_analysis::values::value::Value;
use std::io;
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// After a failure it is tried again after the first time, and after twice as long each time up to the last.
const WAITS: [Duration; 2] = [Duration::from_secs(1), Duration::from_secs(30)];

/// Whether a controller answers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Connection {
    /// Not yet, and nothing has failed.
    Opening,
    /// It does.
    Open,
    /// It does not, and why; it is tried again.
    Lost(String),
}

/// What is known of a controller.
#[derive(Debug, Clone)]
pub struct Newest {
    /// Whether it answers.
    pub connection: Connection,
    /// What it has of what is wanted, in the order of that; nothing before it was first connected.
    pub found: Arc<[Found]>,
    /// How many snapshots have come.
    pub snapshots: u64,
    /// The values of the last one, in the order of what is wanted.
    pub values: Arc<[Option<Value>]>,
    /// When that was complete.
    pub at: Option<Instant>,
    /// How long it took to read.
    pub took: Duration,
}

/// A controller that is watched until this is dropped.
#[derive(Debug)]
pub struct Watch {
    newest: Arc<Mutex<Newest>>,
    _ending: Sender<()>,
}

impl Watch {
    /// Reads a controller from now on, on a thread of its own. After anything new `wake` is called there.
    ///
    /// # Errors
    /// There is no thread for it.
    pub fn start(
        mut source: Box<dyn Source>,
        every: Duration,
        wake: impl Fn() + Send + 'static,
    ) -> io::Result<Watch> {
        let newest = Arc::new(Mutex::new(Newest {
            connection: Connection::Opening,
            found: Arc::new([]),
            snapshots: 0,
            values: Arc::new([]),
            at: None,
            took: Duration::ZERO,
        }));
        let (ending, ended) = channel::<()>();
        let shared = newest.clone();
        let is_over = move |wait| ended.recv_timeout(wait) == Err(RecvTimeoutError::Disconnected);
        let work = move || {
            let mut wait = WAITS[0];
            loop {
                let Err(lost) = attend(source.as_mut(), every, &shared, &wake, &is_over, &mut wait) else {
                    return;
                };
                lock(&shared).connection = Connection::Lost(lost);
                wake();
                if is_over(wait) {
                    return;
                }
                wait = (wait * 2).min(WAITS[1]);
            }
        };
        std::thread::Builder::new()
            .name("controller".to_owned())
            .spawn(work)?;
        Ok(Watch {
            newest,
            _ending: ending,
        })
    }

    /// What is known now.
    pub fn newest(&self) -> Newest {
        lock(&self.newest).clone()
    }
}

/// Connects and reads until the end is asked for, or until the controller does not answer any more.
fn attend(
    source: &mut dyn Source,
    every: Duration,
    shared: &Mutex<Newest>,
    wake: &dyn Fn(),
    is_over: &dyn Fn(Duration) -> bool,
    wait: &mut Duration,
) -> Result<(), String> {
    let found = source.connect()?;
    lock(shared).found = found.into();
    loop {
        let began = Instant::now();
        let values = source.read()?;
        *wait = WAITS[0];
        {
            let mut newest = lock(shared);
            newest.connection = Connection::Open;
            newest.snapshots += 1;
            newest.values = values.into();
            newest.at = Some(Instant::now());
            newest.took = began.elapsed();
        }
        wake();
        // What is late is not caught up: a slow controller would never be left alone.
        if is_over(every.saturating_sub(began.elapsed())) {
            return Ok(());
        }
    }
}

fn lock(newest: &Mutex<Newest>) -> MutexGuard<'_, Newest> {
    newest.lock().unwrap_or_else(PoisonError::into_inner)
}
