//! A simulation that remembers, and can say why: what the language server, the interactive screen and tests drive.
//!
//! Whatever is given from outside goes through the session, so that it becomes part of the [history]: going
//! back restores an earlier scan exactly, and going forward again replays what was given. Once something else is given
//! in the past, what followed there is forgotten.

mod banks;
mod breakpoints;
mod change;
mod delta;
mod given;
mod history;
mod inquire;
mod names;
mod past;
mod rewind;
mod serial;
mod steps;
mod touched;
mod why;

use crate::carry::Names;
use crate::compile_error::CompileError;
use crate::fault::Fault;
use crate::machine::FaultRecord;
use crate::retain::Kept;
use crate::simulation::{Options, Simulation, Status, ValueRefused};
use crate::tags::Point;
pub use breakpoints::{Breakpoint, Hit, StepBy};
use change::Era;
use given::AllGiven;
pub(crate) use given::{MOST_GIVEN, NotKnown};
use history::History;
pub use history::HistoryLimits;
use ladder_analysis::Cancel;
use ladder_analysis::program::{Location, Program};
use ladder_analysis::values::value::Value;
use std::cell::OnceCell;
use std::collections::VecDeque;
use std::sync::Arc;
use why::Writers;
pub use why::{Cause, Judged, Judgement, Moment, Reason, Since, Why, Wording, Write};

/// This many faults are kept: those that happened last.
const FAULTS: usize = 4096;

/// Why a run stopped.
#[derive(Debug, Clone, PartialEq)]
pub enum Stop {
    /// It ran as many scans as it was to.
    Done,
    /// It was asked to stop.
    Cancelled,
    /// The program has ended with `<END>`.
    Ended,
    /// The watchdog, or calls nested too deep, stopped the simulation.
    Faulted,
    /// A breakpoint.
    Breakpoint(Hit),
    /// It went the step that it was to: this block or network runs next.
    At(Location),
}

/// A simulation with its history.
#[derive(Debug)]
pub struct Session {
    simulation: Simulation,
    history: History,
    /// Something was given since the last scan.
    changed: bool,
    given: AllGiven,
    /// The scan that is open was stepped back from and is run again.
    repeats: bool,
    faults: VecDeque<FaultRecord>,
    breakpoints: Vec<Breakpoint>,
    /// The run stopped after a block, and what is there has not been checked yet.
    unseen_network: bool,
    /// Who writes what, for those who ask why.
    writers: OnceCell<Writers>,
    /// How often the running program was changed before it became this one.
    generation: u64,
    /// Tags that had another name in a program before, the newest change last.
    renamed: Vec<Names>,
    /// The programs that ran before this one, the newest last.
    earlier: Vec<Era>,
    /// Those that ran after the moment that was stepped back to, the newest first.
    later: Vec<Era>,
}

impl Session {
    /// A program before its first scan: a cold start.
    ///
    /// # Errors
    /// The program needs more memory than there is.
    pub fn new(
        program: Arc<Program>,
        options: Options,
        limits: HistoryLimits,
    ) -> Result<Session, CompileError> {
        Ok(Session::of(Simulation::new(program, options)?, limits))
    }

    /// A session over a simulation; what it did before is not known.
    pub fn of(mut simulation: Simulation, limits: HistoryLimits) -> Session {
        let mut faults = VecDeque::new();
        collect_faults(&mut simulation, &mut faults);
        let mut history = History::new(&simulation, limits);
        history.take_serial(&mut simulation);
        Session {
            given: AllGiven::at_start(&simulation, history.is_on()),
            history,
            simulation,
            changed: false,
            repeats: false,
            faults,
            breakpoints: Vec::new(),
            unseen_network: false,
            writers: OnceCell::new(),
            generation: 0,
            renamed: Vec::new(),
            earlier: Vec::new(),
            later: Vec::new(),
        }
    }

    /// Sets what may cancel a scan that takes long. Such a scan is taken back: the session is before it, with what
    /// was given for it. Without a history that cannot be done, and it is a fault that stops the simulation.
    pub fn set_cancel(&mut self, cancel: Option<Cancel>) {
        self.simulation.set_cancel(cancel);
    }

    /// The simulation, to be read: values, power, forces, names.
    pub fn simulation(&self) -> &Simulation {
        &self.simulation
    }

    /// Holds what another simulation of the same program holds, and its power: for a session that shows what is watched. It has
    /// no history. `time` is its clock from now on, in nanoseconds.
    pub fn mirror(&mut self, other: &Simulation, time: i64) {
        if self.simulation.restore(&other.state()) {
            self.simulation.machine.now = time;
        }
    }

    /// Sets a tag to a value before the next scan, as the world outside does.
    ///
    /// # Errors
    /// The point is read-only, or the value does not fit its type.
    pub fn set(&mut self, point: &Point, value: Value) -> Result<(), ValueRefused> {
        let point = &*self.point_of_now(point)?;
        if self.simulation.is_open() {
            return self.simulation.set(point, value);
        }
        let is_forced = self.simulation.is_forced(point);
        let differs = is_forced && point.is_input
            || !is_forced && self.simulation.is_driven(point)
            || self.simulation.value(point) != value;
        self.simulation.set(point, value)?;
        if differs {
            self.goes_another_way();
        }
        Ok(())
    }

    /// Holds a tag at a value.
    ///
    /// # Errors
    /// The point is read-only, or the value does not fit its type.
    pub fn force(&mut self, point: &Point, value: Value) -> Result<(), ValueRefused> {
        let point = &*self.point_of_now(point)?;
        self.simulation.force(point, value)?;
        if !self.simulation.is_open() {
            self.goes_another_way();
        }
        Ok(())
    }

    /// Lets a tag go.
    pub fn unforce(&mut self, point: &Point) {
        let Ok(point) = &self.point_of_now(point) else {
            return;
        };
        if self.simulation.is_open() {
            self.simulation.unforce(point);
        } else if self.simulation.is_forced(point) {
            self.simulation.unforce(point);
            self.goes_another_way();
        }
    }

    /// Lets all tags go.
    pub fn unforce_all(&mut self) {
        self.take_over();
        if self.simulation.is_open() {
            self.simulation.unforce_all();
        } else if self.simulation.forced().next().is_some() {
            self.simulation.unforce_all();
            self.goes_another_way();
        }
    }

    /// Lets bytes come in at the serial port.
    pub fn feed_serial(&mut self, bytes: &[u8]) {
        if bytes.is_empty() {
            return;
        }
        self.take_over();
        self.simulation.feed_serial(bytes);
        if !self.simulation.is_open() {
            self.goes_another_way();
        }
    }

    /// The bytes that were sent through the serial port so far: the newest 65,536.
    pub fn serial(&self) -> Vec<u8> {
        self.history.serial()
    }

    /// Something happens that did not happen here before.
    fn goes_another_way(&mut self) {
        if !self.changed {
            self.forget_ahead();
        }
        self.changed = true;
    }

    /// Goes back up to this many scans, to the state of then; what was given since is undone with them. How many
    /// scans it were: fewer if fewer are kept.
    ///
    /// A scan that is open counts: going back one goes to its start.
    pub fn step_back(&mut self, scans: usize) -> usize {
        if scans > 0 && self.simulation.is_open() {
            self.give_up_scan();
            return 1 + self.step_back(scans - 1);
        }
        let mut gone = 0;
        loop {
            let went = self
                .history
                .back(&mut self.simulation, scans - gone, self.changed);
            if went > 0 {
                self.changed = false;
            }
            gone += went;
            if gone == scans || !self.go_to_earlier() {
                return gone;
            }
        }
    }

    /// Goes to the state after this many scans, if that is kept: back, or forward over scans that were
    /// stepped back from. Breakpoints are passed by, and a scan that is open is given up. False, and nothing happens, if it
    /// is not kept.
    pub fn go_to(&mut self, scans: u64) -> bool {
        let now = self.simulation.scans();
        let (back, ahead) = (self.scans_behind() as u64, self.scans_ahead() as u64);
        if scans.saturating_add(back) < now || scans > now + ahead {
            return false;
        }
        if self.simulation.is_open() {
            self.give_up_scan();
        }
        if let Some(back @ 1..) = now.checked_sub(scans) {
            self.step_back(back as usize);
            return true;
        }
        let mut left = (scans - now) as usize;
        while left > 0 {
            let gone = self.history.forward_by(&mut self.simulation, left);
            if gone == 0 {
                break;
            }
            left -= gone;
            self.changed = self.history.give_what_waits(&mut self.simulation);
            self.go_to_later();
        }
        true
    }

    /// How many scans can be stepped back.
    pub fn scans_behind(&self) -> usize {
        self.history.behind() + self.earlier.iter().map(Era::kept).sum::<usize>()
    }

    /// How many scans were stepped back from and can be gone forward to again.
    pub fn scans_ahead(&self) -> usize {
        self.history.ahead() + self.later.iter().map(Era::kept).sum::<usize>()
    }

    /// Whether anything was given since the last scan.
    pub(crate) fn is_given(&self) -> bool {
        self.changed
    }

    /// Makes the place where the simulation is the newest: what was stepped back from is forgotten.
    pub fn forget_ahead(&mut self) {
        if self.repeats {
            return;
        }
        self.take_over();
        self.history.forget_ahead();
        self.forget_faults_ahead();
    }

    /// How many bytes the history takes.
    pub fn history_size(&self) -> usize {
        let eras = self.earlier.iter().chain(&self.later);
        self.history.size() + eras.map(Era::size).sum::<usize>()
    }

    /// Begins again from cold: all tags as before the first scan. Forces stay; the history starts again.
    pub fn reset(&mut self) {
        self.go_to_newest();
        self.simulation.reset();
        self.begin_again();
    }

    /// Begins again as after a power failure: retentive tags keep their values. Forces stay; the history starts again.
    ///
    /// Beside a plant the controller has no power for a scan, which is kept as any other: the machine goes on.
    pub fn warm_restart(&mut self) {
        self.go_to_newest();
        if self.simulation.program().plants.is_empty() || self.simulation.status() != Status::Ready {
            self.simulation.warm_restart();
            return self.begin_again();
        }
        self.forget_ahead();
        if self.simulation.is_open() {
            self.scan();
        }
        let power = crate::tags::power();
        // SYS.POWER takes each BOOL.
        let _ = self.set(&power, Value::Bool(false));
        self.scan();
        let _ = self.set(&power, Value::Bool(true));
    }

    /// Begins with the values of retentive tags that were kept outside of the session, see [`Simulation::warm_start`].
    pub fn warm_start(&mut self, kept: &[Kept]) -> Vec<String> {
        self.go_to_newest();
        let complaints = self.simulation.warm_start(kept);
        self.begin_again();
        complaints
    }

    fn begin_again(&mut self) {
        self.faults.clear();
        self.changed = false;
        self.repeats = false;
        self.history.clear(&self.simulation);
        self.given = AllGiven::at_start(&self.simulation, self.history.is_on());
        self.earlier.clear();
    }

    /// The faults so far, the oldest first: the last 4,096 of them. Those of scans that were stepped back from are not
    /// among them.
    pub fn faults(&self) -> Vec<Fault> {
        let happened = self.faults.iter().take_while(|record| self.has_happened(record));
        happened.map(|record| self.simulation.fault(record)).collect()
    }

    /// The last fault so far, and how often it has happened in its block, as far as faults are kept.
    pub fn last_fault(&self) -> Option<(Fault, usize)> {
        let happened = || self.faults.iter().take_while(|record| self.has_happened(record));
        let last = happened().last()?;
        let times = happened().filter(|record| record.block == last.block).count();
        Some((self.simulation.fault(last), times))
    }

    fn has_happened(&self, record: &FaultRecord) -> bool {
        let scans = self.simulation.machine.scan;
        let now = self.simulation.status() == Status::Faulted || (self.simulation.is_open() && !self.repeats);
        record.scan < scans || (record.scan == scans && now)
    }

    /// The faults of one scan, in their order, as far as they have happened and are kept. Of the scan that is open those
    /// so far.
    pub fn faults_of(&self, scan: u64) -> Vec<Fault> {
        let scan = scan as i64;
        if self.repeats && scan == self.simulation.machine.scan {
            let again = self.simulation.machine.faults.iter();
            return again.map(|record| self.simulation.fault(record)).collect();
        }
        let first = self.faults.partition_point(|record| record.scan < scan);
        let of_scan = self.faults.iter().skip(first);
        of_scan
            .take_while(|record| record.scan == scan && self.has_happened(record))
            .map(|record| self.simulation.fault(record))
            .collect()
    }

    fn forget_faults_ahead(&mut self) {
        let kept = self
            .faults
            .iter()
            .take_while(|record| self.has_happened(record))
            .count();
        self.faults.truncate(kept);
    }
}

/// Takes the faults that the last scan recorded.
fn collect_faults(simulation: &mut Simulation, faults: &mut VecDeque<FaultRecord>) {
    let machine = &mut simulation.machine;
    if machine.faults.is_empty() {
        return;
    }
    faults.extend(machine.faults.drain(..));
    machine.faults_lost = 0;
    faults.drain(..faults.len().saturating_sub(FAULTS));
}
