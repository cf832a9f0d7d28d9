//! What the scan thread and the tasks of the devices exchange: two lists of words under a lock that nobody holds for long.

use super::Wired;
use super::client::{self, Tell};
use crate::modbus::bind::Entry;
use crate::modbus::blocks::Block;
use crate::modbus::registers::{Words, value, words};
use ladder_analysis::values::value::Value;
use ladder_simulator::{Point, Simulation};
use std::io;
use std::sync::mpsc::{Receiver, channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};
use tokio::sync::watch;

/// What is read and written, and with which requests.
#[derive(Debug)]
pub(super) struct Plan {
    /// In the order of their places, as all of these.
    pub(super) reads: Vec<Entry>,
    pub(super) read_blocks: Vec<Block>,
    pub(super) writes: Vec<Entry>,
    pub(super) write_blocks: Vec<Block>,
    pub(super) words: Words,
    pub(super) ok: Option<Point>,
    pub(super) age: Option<Point>,
}

impl Plan {
    /// The values to write as words, bits as 0 and 1.
    fn outputs(&self, value: impl Fn(&Point) -> Value) -> Vec<u16> {
        let mut all = Vec::new();
        for entry in &self.writes {
            match value(&entry.point) {
                Value::Bool(high) => all.push(u16::from(high)),
                number => all.extend(words(&number, entry.point.ty, self.words)),
            }
        }
        all
    }

    /// What was read is given to the program. A value that a tag cannot have, such as 300 for a USINT, leaves it as it is.
    fn give(&self, mut read: &[u16], simulation: &mut Simulation) {
        for entry in &self.reads {
            let Some((own, rest)) = read.split_at_checked(entry.width) else {
                return;
            };
            read = rest;
            let value = if entry.place.table.is_of_bits() {
                Some(Value::Bool(own[0] != 0))
            } else {
                value(own, entry.point.ty, self.words)
            };
            if let Some(value) = value {
                let _ = simulation.set(&entry.point, value);
            }
        }
    }
}

/// What passes between a task and the scan thread.
#[derive(Debug)]
pub(super) struct Exchange(Mutex<Inner>);

#[derive(Debug)]
struct Inner {
    plan: Arc<Plan>,
    /// What was read since the program was last given anything: the words of the entries, one after the other.
    read: Option<Vec<u16>>,
    /// What is to be written; none before the first scan has ended.
    outputs: Option<Vec<u16>>,
    /// When the last exchange was whole.
    heard: Option<Instant>,
    answers: bool,
}

impl Exchange {
    fn new(plan: Arc<Plan>) -> Exchange {
        Exchange(Mutex::new(Inner {
            plan,
            read: None,
            outputs: None,
            heard: None,
            answers: false,
        }))
    }

    fn lock(&self) -> MutexGuard<'_, Inner> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub(super) fn plan(&self) -> Arc<Plan> {
        self.lock().plan.clone()
    }

    /// All of the plan was read. What is to be written then; none if nothing is yet, or if there is another plan by now.
    pub(super) fn swap(&self, plan: &Arc<Plan>, read: Vec<u16>) -> Option<Vec<u16>> {
        let mut inner = self.lock();
        if !Arc::ptr_eq(plan, &inner.plan) {
            return None;
        }
        inner.read = Some(read);
        inner.outputs.clone()
    }

    /// What is to be written of the plan.
    pub(super) fn outputs(&self, plan: &Arc<Plan>) -> Option<Vec<u16>> {
        let inner = self.lock();
        inner.outputs.clone().filter(|_| Arc::ptr_eq(plan, &inner.plan))
    }

    /// The device has answered all of an exchange.
    pub(super) fn answered(&self) {
        let mut inner = self.lock();
        inner.heard = Some(Instant::now());
        inner.answers = true;
    }

    /// The device does not answer any more.
    pub(super) fn lost(&self) {
        self.lock().answers = false;
    }
}

/// Devices that are connected, or being connected.
#[derive(Debug)]
pub struct Devices {
    own: Vec<(Arc<Plan>, Arc<Exchange>)>,
    began: Instant,
    ending: watch::Sender<bool>,
    ended: Receiver<()>,
    /// How long the last exchange may take.
    patience: Duration,
}

impl Devices {
    /// Connects devices on a thread of their own. What changes with one is told in a sentence.
    ///
    /// # Errors
    /// There is no thread for it.
    pub fn connect(wired: Vec<Wired>, tell: impl Fn(&str) + Send + Sync + 'static) -> io::Result<Devices> {
        let tell: Tell = Arc::new(tell);
        let runtime = tokio::runtime::Builder::new_current_thread()
            .enable_all()
            .build()?;
        let (ending, asked) = watch::channel(false);
        let (end, ended) = channel();
        let longest = wired.iter().map(|wired| wired.device.timeout).max();
        let mut own = Vec::new();
        for Wired { device, plan } in wired {
            let exchange = Arc::new(Exchange::new(plan.clone()));
            own.push((plan, exchange.clone()));
            let (asked, end, tell) = (asked.clone(), end.clone(), tell.clone());
            runtime.spawn(async move {
                client::attend(&device, &exchange, asked, &tell).await;
                // Nobody waits for it where the run has ended otherwise.
                let _ = end.send(());
            });
        }
        let mut asked = asked;
        let work = move || {
            // Until the end is asked for, and then until the sender is gone with the process.
            runtime.block_on(async { while asked.changed().await.is_ok() {} });
        };
        std::thread::Builder::new()
            .name("devices".to_owned())
            .spawn(work)?;
        Ok(Devices {
            own,
            began: Instant::now(),
            ending,
            ended,
            patience: longest.unwrap_or_default() * 2,
        })
    }

    /// Before a scan: what was read is given to the program, all of one exchange together.
    pub fn give(&self, simulation: &mut Simulation, now: Instant) {
        for (plan, exchange) in &self.own {
            let (read, answers, heard) = {
                let mut inner = exchange.lock();
                (inner.read.take(), inner.answers, inner.heard)
            };
            if let Some(read) = read {
                plan.give(&read, simulation);
            }
            if let Some(ok) = &plan.ok {
                let _ = simulation.set(ok, Value::Bool(answers));
            }
            if let Some(age) = &plan.age {
                let passed = now.saturating_duration_since(heard.unwrap_or(self.began));
                let passed = i64::try_from(passed.as_nanos()).unwrap_or(i64::MAX);
                let _ = simulation.set(age, Value::Int(passed));
            }
        }
    }

    /// After a scan: its values are what is to be written.
    pub fn take(&self, simulation: &Simulation) {
        for (plan, exchange) in &self.own {
            let outputs = plan.outputs(|point| simulation.value(point));
            exchange.lock().outputs = Some(outputs);
        }
    }

    /// The same devices are wired to another program from now on. Nothing of it is written before its first scan has ended.
    pub fn replace(&mut self, wired: Vec<Wired>) {
        for ((plan, exchange), wired) in self.own.iter_mut().zip(wired) {
            *plan = wired.plan;
            let mut inner = exchange.lock();
            inner.plan = plan.clone();
            inner.read = None;
            inner.outputs = None;
        }
    }

    /// The run has ended: what a device was written is written as it is before the program does anything, once, as far as
    /// the device answers.
    pub fn finish(self, simulation: &Simulation) {
        for (plan, exchange) in &self.own {
            if let Some(outputs) = &mut exchange.lock().outputs {
                *outputs = plan.outputs(|point| simulation.initial(point));
            }
        }
        self.ending.send_replace(true);
        let end = Instant::now() + self.patience;
        for _ in &self.own {
            let left = end.saturating_duration_since(Instant::now());
            if self.ended.recv_timeout(left).is_err() {
                return;
            }
        }
    }
}
