//! A host of one thread, in which everything has its turn: what a page has, and tests that are to say the same each time.
//!
//! Nothing runs by itself. Who owns the loop calls [`EventLoop::turn`], and again when the time has come that this names, or
//! something has arrived.

use std::collections::{BTreeMap, VecDeque};
use std::fmt;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::task::{Context, Wake, Waker};
use std::time::Duration;

use futures::channel::oneshot;
use futures::future::{BoxFuture, FutureExt};

use crate::host::{Host, Moment, Turns, Wait, World};

/// A host of one thread. Clones are the same host.
#[derive(Clone)]
pub struct EventLoop {
    world: World,
    state: Arc<Mutex<State>>,
}

#[derive(Default)]
struct State {
    /// What can go on now, the next one first.
    ready: VecDeque<Runnable>,
    /// What waits for its waker.
    waiting: Vec<(Arc<Alarm>, Runnable)>,
    /// Who is to be woken when; the number keeps apart what is due at once.
    timers: BTreeMap<(Moment, u64), oneshot::Sender<()>>,
    timers_set: u64,
}

/// What has its turn.
enum Runnable {
    Task(BoxFuture<'static, ()>),
    Job(Box<dyn FnOnce() + Send>),
    /// With the moment from which on it has its turn, even if nothing has arrived.
    Turns(Box<dyn Turns>, Option<Moment>),
}

/// Rings when what waits can go on.
#[derive(Default)]
pub(crate) struct Alarm(pub(crate) AtomicBool);

impl Wake for Alarm {
    fn wake(self: Arc<Self>) {
        self.0.store(true, Ordering::Release);
    }
}

impl EventLoop {
    /// A loop in which nothing is to be done yet.
    pub fn new(world: World) -> EventLoop {
        EventLoop {
            world,
            state: Arc::default(),
        }
    }

    /// Does what can be done now: all of it, or as much as begins before `until`. What is next: [`Wait::No`] if there is more,
    /// else the moment of the next thing, or [`Wait::Arrival`].
    pub fn turn(&self, until: Moment) -> Wait {
        loop {
            let now = self.world.clock.now();
            self.wake_up(now);
            let Some(next) = self.lock().ready.pop_front() else {
                return self.next();
            };
            self.run(next);
            if self.world.clock.now() >= until {
                self.wake_up(self.world.clock.now());
                return self.next();
            }
        }
    }

    fn next(&self) -> Wait {
        let state = self.lock();
        if !state.ready.is_empty() {
            return Wait::No;
        }
        let due = state.waiting.iter().filter_map(|(_, runnable)| match runnable {
            Runnable::Turns(_, due) => *due,
            Runnable::Task(_) | Runnable::Job(_) => None,
        });
        let timer = state.timers.keys().next().map(|(at, _)| *at);
        due.chain(timer).min().map_or(Wait::Arrival, Wait::Until)
    }

    /// Puts what can go on into the row.
    fn wake_up(&self, now: Moment) {
        loop {
            let mut state = self.lock();
            match state.timers.first_entry() {
                Some(timer) if timer.key().0 <= now => {
                    let timer = timer.remove();
                    drop(state);
                    let _ = timer.send(());
                }
                _ => break,
            }
        }
        let mut state = self.lock();
        let State { ready, waiting, .. } = &mut *state;
        let goes_on = |(alarm, runnable): &mut (Arc<Alarm>, Runnable)| {
            let is_due = matches!(runnable, Runnable::Turns(_, Some(due)) if *due <= now);
            is_due || alarm.0.load(Ordering::Acquire)
        };
        ready.extend(waiting.extract_if(.., goes_on).map(|(_, runnable)| runnable));
    }

    fn run(&self, runnable: Runnable) {
        let alarm = Arc::<Alarm>::default();
        let waker = Waker::from(alarm.clone());
        let mut context = Context::from_waker(&waker);
        match runnable {
            Runnable::Job(job) => job(),
            Runnable::Task(mut task) => {
                if task.poll_unpin(&mut context).is_pending() {
                    self.lock().waiting.push((alarm, Runnable::Task(task)));
                }
            }
            Runnable::Turns(mut turns, _) => {
                let wait = turns.turn(&mut context);
                let mut state = self.lock();
                match wait {
                    Wait::No => state.ready.push_back(Runnable::Turns(turns, None)),
                    Wait::Until(due) => state.waiting.push((alarm, Runnable::Turns(turns, Some(due)))),
                    Wait::Arrival => state.waiting.push((alarm, Runnable::Turns(turns, None))),
                    Wait::Over => {
                        drop(state);
                        drop(turns);
                    }
                }
            }
        }
    }

    fn lock(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Host for EventLoop {
    fn world(&self) -> &World {
        &self.world
    }

    fn spawn(&self, task: BoxFuture<'static, ()>) {
        self.lock().ready.push_back(Runnable::Task(task));
    }

    fn sleep(&self, time: Duration) -> BoxFuture<'static, ()> {
        let (timer, rings) = oneshot::channel();
        let at = self.world.clock.now().saturating_add(time);
        let mut state = self.lock();
        state.timers_set += 1;
        let number = state.timers_set;
        state.timers.insert((at, number), timer);
        drop(state);
        rings.map(|_| ()).boxed()
    }

    fn work(&self, job: Box<dyn FnOnce() + Send>) {
        self.lock().ready.push_back(Runnable::Job(job));
    }

    fn give_turns(&self, _name: String, turns: Box<dyn Turns>) -> Result<(), String> {
        self.lock().ready.push_back(Runnable::Turns(turns, None));
        Ok(())
    }

    fn gone(&self, _process: u32) -> BoxFuture<'static, ()> {
        futures::future::pending().boxed()
    }

    fn hears_while_working(&self) -> bool {
        false
    }
}

impl fmt::Debug for EventLoop {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("EventLoop").field("next", &self.next()).finish()
    }
}
