//! The thread that reads a controller again and again, and what it has read last.

use crate::source::Source;
use ladder_simulator::online::{Connection, Newest, Wanted, Watched};
use std::io;
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// After a failure it is tried again after the first time, and after twice as long each time up to the last.
const WAITS: [Duration; 2] = [Duration::from_secs(1), Duration::from_secs(30)];

/// A controller that is watched until this is dropped.
#[derive(Debug)]
pub struct Watch {
    wanted: Vec<Wanted>,
    newest: Arc<Mutex<(Newest, Option<Instant>)>>,
    _ending: Sender<()>,
}

impl Watch {
    /// Reads a controller from now on, on a thread of its own. After anything new `wake` is called there.
    ///
    /// # Errors
    /// There is no thread for it.
    pub fn start(
        mut source: Box<dyn Source>,
        wanted: Vec<Wanted>,
        every: Duration,
        wake: impl Fn() + Send + 'static,
    ) -> io::Result<Watch> {
        let nothing = Newest {
            connection: Connection::Opening,
            found: Arc::new([]),
            snapshots: 0,
            values: Arc::new([]),
            age: None,
        };
        let newest = Arc::new(Mutex::new((nothing, None)));
        let (ending, ended) = channel::<()>();
        let shared = newest.clone();
        let is_over = move |wait| ended.recv_timeout(wait) == Err(RecvTimeoutError::Disconnected);
        let work = move || {
            let mut wait = WAITS[0];
            loop {
                let Err(lost) = attend(source.as_mut(), every, &shared, &wake, &is_over, &mut wait) else {
                    return;
                };
                lock(&shared).0.connection = Connection::Lost(lost);
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
            wanted,
            newest,
            _ending: ending,
        })
    }
}

impl Watched for Watch {
    fn wanted(&self) -> &[Wanted] {
        &self.wanted
    }

    fn newest(&self) -> Newest {
        let (newest, at) = lock(&self.newest).clone();
        Newest {
            age: at.map(|at| at.elapsed()),
            ..newest
        }
    }
}

/// Connects and reads until the end is asked for, or until the controller does not answer any more.
fn attend(
    source: &mut dyn Source,
    every: Duration,
    shared: &Mutex<(Newest, Option<Instant>)>,
    wake: &dyn Fn(),
    is_over: &dyn Fn(Duration) -> bool,
    wait: &mut Duration,
) -> Result<(), String> {
    let found = source.connect()?;
    lock(shared).0.found = found.into();
    loop {
        let began = Instant::now();
        let values = source.read()?;
        *wait = WAITS[0];
        {
            let (newest, at) = &mut *lock(shared);
            newest.connection = Connection::Open;
            newest.snapshots += 1;
            newest.values = values.into();
            *at = Some(Instant::now());
        }
        wake();
        // What is late is not caught up: a slow controller would never be left alone.
        if is_over(every.saturating_sub(began.elapsed())) {
            return Ok(());
        }
    }
}

fn lock<T>(newest: &Mutex<T>) -> MutexGuard<'_, T> {
    newest.lock().unwrap_or_else(PoisonError::into_inner)
}
