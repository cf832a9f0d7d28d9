//! What was: the differences between scans, so that any kept one can be gone back to exactly.
//!
//! ```text
//! base --given, ran--> after scan 0 --given, ran--> after scan 1 .. here .. newest --given--> not scanned yet
//! ```
//!
//! Each entry is one scan in two parts: what was given from outside before it, and what it did. Both are the bytes
//! of [`Banks::follow`], which lead either way, so no full copies are kept but one: the banks of the moment
//! that the simulation is at.

use super::banks::Banks;
use super::delta::{Bytes, Way};
use super::rewind::Rewind;
use super::serial::SerialLog;
use super::touched::Touched;
use crate::memory::Memory;
use crate::simulation::{Force, Simulation, Status};
use std::collections::{BTreeMap, VecDeque};

/// How much of the past is kept.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct HistoryLimits {
    /// At most so many scans; none with 0.
    pub scans: usize,
    /// At most so many bytes.
    pub bytes: usize,
}

impl Default for HistoryLimits {
    /// 10,000 scans (100 seconds at 10 ms) in at most 64 MiB.
    fn default() -> Self {
        HistoryLimits {
            scans: 10_000,
            bytes: 64 << 20,
        }
    }
}

impl HistoryLimits {
    /// So many scans, in at most as many bytes as by default.
    pub fn of_scans(scans: usize) -> HistoryLimits {
        HistoryLimits {
            scans,
            ..HistoryLimits::default()
        }
    }
}

pub(super) type Forces = BTreeMap<String, Force>;

/// The clock of a moment, and how the program stood.
#[derive(Debug, Clone, Copy)]
pub(super) struct Moment {
    pub(super) now: i64,
    pub(super) scan: i64,
    faulted: bool,
    status: Status,
    ran_plain: bool,
}

impl Moment {
    fn of(simulation: &Simulation) -> Moment {
        Moment {
            now: simulation.machine.now,
            scan: simulation.machine.scan,
            faulted: simulation.machine.faulted,
            status: simulation.status,
            ran_plain: simulation.ran_plain,
        }
    }

    pub(super) fn restore(self, simulation: &mut Simulation) {
        simulation.machine.now = self.now;
        simulation.machine.scan = self.scan;
        simulation.machine.faulted = self.faulted;
        simulation.status = self.status;
        simulation.ran_plain = self.ran_plain;
    }
}

/// What was given from outside, beyond what the banks show: the forces before and after. None if they stayed.
pub(super) type ForceChange = Option<Box<(Forces, Forces)>>;

/// One scan.
#[derive(Debug)]
pub(super) struct Entry {
    /// Bytes of what was given before it.
    pub(super) given: u32,
    /// Bytes of what it did.
    ran: u32,
    /// Bytes that it sent through the serial port.
    sent: u32,
    pub(super) forces: ForceChange,
    after: Moment,
}

impl Entry {
    fn bytes(&self) -> usize {
        self.given as usize + self.ran as usize
    }
}

/// What was given for a scan that has not ended.
#[derive(Debug, Default)]
pub(super) struct Given {
    pub(super) bytes: Vec<u8>,
    pub(super) forces: ForceChange,
}

impl Given {
    fn is_nothing(&self) -> bool {
        self.bytes.is_empty() && self.forces.is_none()
    }
}

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
    /// What was given behind the newest scan, while the simulation is before it.
    waiting: Given,
    serial: SerialLog,
    scratch: Vec<u8>,
    /// What has changed since this began, in scans that are no longer kept too.
    pub(super) touched: Touched,
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

    /// After how many scans the values are known, the one that the simulation is behind among them.
    pub(super) fn known(&self) -> usize {
        if !self.is_on() {
            return 0;
        }
        // The moment before the oldest entry follows a scan too, unless that is the first one.
        self.here + usize::from(self.base.scan > 0)
    }

    /// How many bytes are in use.
    pub(super) fn size(&self) -> usize {
        self.bytes.len() + self.serial.size() + self.entries.len() * size_of::<Entry>()
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

    /// What was given behind the newest scan is set aside, for when the simulation comes forward again: it leaves this
    /// history.
    pub(super) fn set_aside(&mut self, simulation: &Simulation) {
        let given = self.take_up(simulation);
        self.take_back(&given);
        self.waiting = given;
    }

    /// Gives what was set aside, if the simulation is behind the newest scan again. Whether that is anything.
    pub(super) fn give_what_waits(&mut self, simulation: &mut Simulation) -> bool {
        if self.ahead() > 0 || self.waiting.is_nothing() {
            return false;
        }
        let given = std::mem::take(&mut self.waiting);
        if let Some(change) = &given.forces {
            simulation.restore_forces(&change.1);
        }
        let mut then = self.banks.clone();
        then.go(Bytes(&given.bytes), Way::Forward);
        then.restore(&mut simulation.machine);
        true
    }

    /// Begins behind what another program sent through the serial port.
    pub(super) fn follow_serial(&mut self, earlier: &History) {
        self.serial = earlier.serial.following();
    }

    /// What lies ahead will not be gone to any more: something else happens from here on.
    pub(super) fn forget_ahead(&mut self) {
        self.entries.truncate(self.here);
        self.bytes.truncate(self.bytes_here);
        self.serial.forget_ahead();
        self.waiting = Given::default();
    }

    /// Gives again what was given before the scan ahead.
    pub(super) fn give_next(&mut self, simulation: &mut Simulation) {
        let Some(entry) = self.entries.get(self.here) else {
            return;
        };
        if let Some(change) = &entry.forces {
            simulation.restore_forces(&change.1);
        }
        let given = entry.given as usize;
        self.go(self.bytes_here, given, Way::Forward);
        self.banks.restore(&mut simulation.machine);
        self.go(self.bytes_here, given, Way::Back);
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
        while self.entries.len() > self.limits.scans || self.size() > self.limits.bytes {
            let Some(oldest) = self.entries.pop_front() else {
                break;
            };
            self.bytes.drain(..oldest.bytes());
            self.serial.forget_oldest(oldest.sent);
            self.base = oldest.after;
        }
        (self.here, self.bytes_here) = (self.entries.len(), self.bytes.len());
    }

    /// The scan that was begun is given up: the simulation is before it again, with what was given for it. Gives
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

    /// Goes back up to so many scans; how many it were. What was given since the last scan (`changed`) is kept for
    /// when the simulation comes forward again.
    pub(super) fn back(&mut self, simulation: &mut Simulation, scans: usize, changed: bool) -> usize {
        let scans = scans.min(self.here);
        if scans == 0 {
            return 0;
        }
        if changed {
            let given = self.take_up(simulation);
            self.take_back(&given);
            self.waiting = given;
        }
        for _ in 0..scans {
            self.here -= 1;
            let entry = &self.entries[self.here];
            let (given, ran) = (entry.given as usize, entry.ran as usize);
            self.serial.back(entry.sent);
            if let Some(change) = &entry.forces {
                self.forces.clone_from(&change.0);
            }
            self.bytes_here -= ran;
            self.go(self.bytes_here, ran, Way::Back);
            self.bytes_here -= given;
            self.go(self.bytes_here, given, Way::Back);
        }
        self.restore(simulation);
        scans
    }

    /// Goes forward one kept scan. None if there is none; else whether something was given behind it, which is
    /// given again now.
    pub(super) fn forward(&mut self, simulation: &mut Simulation) -> Option<bool> {
        (self.forward_by(simulation, 1) == 1).then(|| self.give_what_waits(simulation))
    }

    /// Goes forward up to so many kept scans; how many it were. What was given behind the newest one still waits.
    pub(super) fn forward_by(&mut self, simulation: &mut Simulation, scans: usize) -> usize {
        let scans = scans.min(self.ahead());
        for _ in 0..scans {
            let entry = &self.entries[self.here];
            let (given, ran) = (entry.given as usize, entry.ran as usize);
            self.serial.forward(entry.sent);
            if let Some(change) = &entry.forces {
                self.forces.clone_from(&change.1);
            }
            self.here += 1;
            self.go(self.bytes_here, given, Way::Forward);
            self.bytes_here += given;
            self.go(self.bytes_here, ran, Way::Forward);
            self.bytes_here += ran;
        }
        if scans > 0 {
            self.restore(simulation);
        }
        scans
    }

    /// Looks at the memory of tags after each of the scans ahead, without moving the history.
    pub(super) fn look_ahead(&self, mut look: impl FnMut(&Memory)) {
        let mut banks = self.banks.clone();
        let (mut start, mut bytes) = (self.bytes_here, Vec::new());
        for entry in self.entries.iter().skip(self.here) {
            let end = start + entry.bytes();
            bytes.clear();
            bytes.extend(self.bytes.range(start..end));
            let (given, ran) = bytes.split_at(entry.given as usize);
            for part in [given, ran] {
                if !part.is_empty() {
                    banks.go_over_tags(&mut Bytes(part), Way::Forward);
                }
            }
            look(&banks.memory);
            start = end;
        }
    }

    /// Moves the banks over a part of the bytes.
    fn go(&mut self, start: usize, len: usize, way: Way) {
        if len == 0 {
            return;
        }
        self.scratch.clear();
        self.scratch.extend(self.bytes.range(start..start + len));
        self.banks.go(Bytes(&self.scratch), way);
    }

    /// Makes the simulation be here.
    pub(super) fn restore(&self, simulation: &mut Simulation) {
        simulation.restore_forces(&self.forces);
        self.banks.restore(&mut simulation.machine);
        self.moment().restore(simulation);
    }

    /// The state from which one can go back scan by scan, without moving the history.
    pub(super) fn rewind(&self, simulation: &Simulation) -> Rewind<'_> {
        Rewind::new(self, simulation)
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
