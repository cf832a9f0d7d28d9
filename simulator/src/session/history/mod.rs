//! What was: the differences between scans, so that any kept one can be gone back to exactly.
//!
//! ```text
//! base --given, ran--> after scan 0 --given, ran--> after scan 1 .. here .. newest --given--> not scanned yet
//! ```
//!
//! Each entry is one scan in two parts: what was given from outside before it, and what it did. Both are the bytes
//! of [`Banks::follow`], which lead either way, so no full copies are kept but one: the banks of the moment
//! that the simulation is at.

mod entry;
mod spans;
mod travel;

use super::banks::Banks;
use super::delta::{Bytes, Way};
use super::serial::SerialLog;
use super::touched::Touched;
use crate::simulation::Simulation;
pub use entry::HistoryLimits;
pub(super) use entry::{Entry, Forces, Given, Moment};
use spans::{Span, Spans};
use std::collections::VecDeque;

/// The kept scans.
#[derive(Debug)]
pub(super) struct History {
    limits: HistoryLimits,
    /// The banks where the simulation is: after a scan and before anything was given since.
    pub(super) banks: Banks,
    /// The forces there.
    pub(super) forces: Forces,
    /// The moment before the oldest entry.
    pub(super) base: Moment,
    pub(super) entries: VecDeque<Entry>,
    /// The bytes of all entries.
    bytes: VecDeque<u8>,
    /// How many entries, and how many of the bytes, lie before the moment where the simulation is.
    pub(super) here: usize,
    bytes_here: usize,
    /// What was given for the scan that runs.
    pub(super) given: Given,
    /// What was given after the newest scan, while the simulation is before it.
    waiting: Given,
    serial: SerialLog,
    scratch: Vec<u8>,
    /// What has changed since this began, in scans that are no longer kept too, and roughly when.
    pub(super) touched: Touched,
    spans: Spans,
    #[cfg(test)]
    pub(super) are_spans_passed: bool,
    /// It began before the first scan.
    pub(super) is_from_the_start: bool,
}

impl History {
    /// Nothing kept yet.
    pub(super) fn new(simulation: &Simulation, limits: HistoryLimits) -> History {
        History {
            serial: SerialLog::default(),
            limits,
            banks: Banks::of(&simulation.machine),
            forces: simulation.forces.clone(),
            base: Moment::of(simulation),
            entries: VecDeque::new(),
            bytes: VecDeque::new(),
            here: 0,
            bytes_here: 0,
            given: Given::default(),
            waiting: Given::default(),
            scratch: Vec::new(),
            touched: Touched::nothing(&simulation.machine.memory),
            spans: Spans::default(),
            #[cfg(test)]
            are_spans_passed: true,
            is_from_the_start: simulation.machine.scan == 0,
        }
    }

    /// Forgets everything: the program begins again.
    pub(super) fn clear(&mut self, simulation: &Simulation) {
        *self = History::new(simulation, self.limits);
    }

    /// Whether anything is kept at all.
    pub(super) fn is_on(&self) -> bool {
        self.limits.scans > 0
    }

    /// How many scans can be gone back.
    pub(super) fn behind(&self) -> usize {
        self.here
    }

    /// How many scans can be gone forward again.
    pub(super) fn ahead(&self) -> usize {
        self.entries.len() - self.here
    }

    /// After how many scans the values are known, the one that the simulation is after among them.
    pub(super) fn known(&self) -> usize {
        if !self.is_on() {
            return 0;
        }
        // The moment before the oldest entry follows a scan too, unless that is the first one.
        self.here + usize::from(self.base.scan > 0)
    }

    /// How many bytes are in use.
    pub(super) fn size(&self) -> usize {
        self.bytes.len() + self.serial.size() + self.entries.len() * size_of::<Entry>() + self.spans.size()
    }

    /// What was sent through the serial port.
    pub(super) fn serial(&self) -> Vec<u8> {
        self.serial.shown().collect()
    }

    /// Takes what was sent in a scan that is not kept.
    pub(super) fn take_serial(&mut self, simulation: &mut Simulation) {
        let sent = self.serial.take(&mut simulation.machine.memory.sent);
        self.serial.forget_oldest(sent);
    }

    /// Forgets the oldest kept scan. False if there is none.
    pub(super) fn forget_oldest(&mut self) -> bool {
        if self.here == 0 {
            return false;
        }
        let Some(oldest) = self.entries.pop_front() else {
            return false;
        };
        self.bytes.drain(..oldest.bytes());
        self.bytes_here -= oldest.bytes();
        self.here -= 1;
        self.serial.forget_oldest(oldest.sent);
        self.base = oldest.after;
        self.spans.forget_before(self.base.scan);
        true
    }

    /// How much may be kept.
    pub(super) fn limits(&self) -> HistoryLimits {
        self.limits
    }

    /// How many scans are kept.
    pub(super) fn kept(&self) -> usize {
        self.entries.len()
    }

    /// Begins after what another program sent through the serial port.
    pub(super) fn follow_serial(&mut self, earlier: &History) {
        self.serial = earlier.serial.following();
    }

    /// What lies ahead will not be gone to any more: something else happens from here on.
    pub(super) fn forget_ahead(&mut self) {
        if self.ahead() > 0 {
            self.spans.forget_from(self.moment().scan);
        }
        self.entries.truncate(self.here);
        self.bytes.truncate(self.bytes_here);
        self.serial.forget_ahead();
        self.waiting = Given::default();
    }

    /// A scan is about to run. `changed` says whether anything was given from outside since the last one.
    pub(super) fn begin(&mut self, simulation: &Simulation, changed: bool) {
        self.forget_ahead();
        if !self.is_on() {
            return;
        }
        if changed {
            self.given = self.take_up(simulation);
        } else {
            self.given.bytes.clear();
            self.given.forces = None;
        }
    }

    /// Notes what was given since the last scan.
    fn take_up(&mut self, simulation: &Simulation) -> Given {
        let mut given = Given {
            bytes: std::mem::take(&mut self.given.bytes),
            forces: None,
        };
        given.bytes.clear();
        self.touched.is_at(simulation.machine.scan);
        self.banks
            .follow(&simulation.machine, &mut self.touched, &mut given.bytes);
        if self.forces != simulation.forces {
            let before = std::mem::replace(&mut self.forces, simulation.forces.clone());
            given.forces = Some(Box::new((before, simulation.forces.clone())));
        }
        given
    }

    /// The scan that was begun has been run.
    pub(super) fn finish(&mut self, simulation: &mut Simulation) {
        if !self.is_on() {
            self.take_serial(simulation);
            return;
        }
        let mut ran = std::mem::take(&mut self.scratch);
        ran.clear();
        let scan = self.moment().scan;
        self.touched.is_at(scan);
        self.banks
            .follow(&simulation.machine, &mut self.touched, &mut ran);
        self.bytes.extend(&self.given.bytes);
        self.bytes.extend(&ran);
        self.entries.push_back(Entry {
            given: self.given.bytes.len() as u32,
            ran: ran.len() as u32,
            sent: self.serial.take(&mut simulation.machine.memory.sent),
            forces: self.given.forces.take(),
            after: Moment::of(simulation),
        });
        self.scratch = ran;
        self.given.bytes.clear();
        if simulation.machine.scan > scan {
            self.spans
                .is_at(scan + 1, &self.banks, &mut self.touched, &self.entries);
        }
        while self.entries.len() > self.limits.scans || self.size() > self.limits.bytes {
            let Some(oldest) = self.entries.pop_front() else {
                break;
            };
            self.bytes.drain(..oldest.bytes());
            self.serial.forget_oldest(oldest.sent);
            self.base = oldest.after;
            self.spans.forget_before(self.base.scan);
        }
        (self.here, self.bytes_here) = (self.entries.len(), self.bytes.len());
    }

    /// The scan that was begun is given up: the simulation is before it again, with what was given for it. Returns
    /// whether that is anything.
    pub(super) fn give_up(&mut self, simulation: &mut Simulation) -> bool {
        self.banks.restore(&mut simulation.machine);
        self.moment().restore(simulation);
        let given = std::mem::take(&mut self.given);
        self.take_back(&given);
        !given.is_nothing()
    }

    fn take_back(&mut self, given: &Given) {
        if !given.bytes.is_empty() {
            self.banks.go(Bytes(&given.bytes), Way::Back);
        }
        if let Some(change) = &given.forces {
            self.forces.clone_from(&change.0);
        }
    }

    fn moment(&self) -> Moment {
        self.moment_before(self.here)
    }

    /// The moment before an entry.
    pub(super) fn moment_before(&self, entry: usize) -> Moment {
        match entry.checked_sub(1) {
            Some(last) => self.entries[last].after,
            None => self.base,
        }
    }

    /// The number of an entry's scan and its clock.
    pub(super) fn clock_before(&self, entry: usize) -> (u64, i64) {
        let moment = self.moment_before(entry);
        (moment.scan as u64, moment.now)
    }

    /// The span of scans right before an entry, if there is one.
    pub(super) fn span_before(&self, entry: usize) -> Option<&Span> {
        #[cfg(test)]
        if !self.are_spans_passed {
            return None;
        }
        self.spans.before(self.moment_before(entry).scan)
    }

    /// Where the bytes of the entries before here end.
    pub(super) fn bytes_here(&self) -> usize {
        self.bytes_here
    }

    /// The bytes of an entry that ends there: what was given before it and what it did, in one.
    pub(super) fn bytes_before(&self, end: usize, entry: usize, into: &mut Vec<u8>) -> usize {
        let start = end - self.entries[entry].bytes();
        into.clear();
        into.extend(self.bytes.range(start..end));
        start
    }

    /// The bytes of what was given before the entry ahead.
    pub(super) fn given_ahead(&self) -> Vec<u8> {
        let given = self
            .entries
            .get(self.here)
            .map_or(0, |entry| entry.given as usize);
        self.bytes
            .range(self.bytes_here..self.bytes_here + given)
            .copied()
            .collect()
    }
}
