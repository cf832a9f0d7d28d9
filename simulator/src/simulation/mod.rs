//! A program that runs: scans, inputs, forces, faults, and what can be seen of it.

mod activations;
mod brief;
mod forces;
mod indexed;
mod instances;
mod listing;
mod pages;
mod power;
mod restart;
mod scan;
mod scope;
mod state;
mod supply;

use crate::compile::{Compiled, compile};
use crate::compile_error::CompileError;
use crate::fault::{Fault, Trouble};
use crate::groups;
use crate::machine::{FaultRecord, Machine};
use crate::memory::SERIAL_ROOM;
use crate::tags::{self, Names, Point, UnknownTag};
use crate::tree::Tree;
use ladder_analysis::Cancel;
use ladder_analysis::program::{Location, Place, Program, TagId};
use ladder_analysis::values::value::Value;
use std::collections::BTreeMap;
use std::sync::{Arc, OnceLock};
use std::time::Duration;

pub(crate) use activations::Bodies;
pub use activations::{Activation, Routine};
pub use forces::ValueRefused;
pub use instances::Instance;
pub(crate) use power::PowerSource;
pub use scan::Stepped;
pub(crate) use scope::Scope;
pub use state::State;

/// How a program is run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Options {
    /// The time from one scan to the next, in nanoseconds.
    pub interval: i64,
    /// How many blocks a scan may evaluate before the watchdog stops the simulation. 100 elements of arrays or
    /// characters of texts that a block goes through count as a further block.
    pub watchdog: u64,
}

impl Default for Options {
    /// 10 ms and 1,000,000 blocks.
    fn default() -> Self {
        Options {
            interval: 10_000_000,
            watchdog: 1_000_000,
        }
    }
}

/// A time of a program or of settings, in nanoseconds, as clocks have it. One before 0 counts as it would after.
pub fn real_time(nanoseconds: i64) -> Duration {
    Duration::from_nanos(nanoseconds.unsigned_abs())
}

/// Whether a program can go on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Status {
    /// The next scan can run.
    Ready,
    /// The program stopped itself with `<END>`.
    Ended,
    /// The watchdog, calls nested too deep, or cancelling stopped it in the middle of a scan.
    Faulted,
}

/// A running program.
#[derive(Debug)]
pub struct Simulation {
    pub(crate) program: Arc<Program>,
    pub(crate) compiled: Compiled,
    pub(crate) names: Names,
    pub(crate) points: Vec<Point>,
    pub(crate) machine: Machine,
    pub(crate) options: Options,
    pub(crate) status: Status,
    pub(crate) forces: BTreeMap<String, Force>,
    /// The last scan ran plain code: with forces, or in steps.
    pub(crate) ran_plain: bool,
    /// A scan was begun and is not finished.
    pub(crate) open: bool,
    /// What waits for its end.
    pub(crate) pending: Vec<Change>,
    /// What passed without a scan since the last one, in nanoseconds.
    passed: i64,
    /// What its tags open into, for those who ask.
    pub(crate) tree: OnceLock<Tree>,
    /// Where user-defined blocks are, for those who ask.
    pub(crate) instances: OnceLock<Vec<Instance>>,
    /// Where their bodies' code is, likewise.
    pub(crate) bodies: OnceLock<Bodies>,
}

/// A force that is in effect.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Force {
    pub(crate) point: Point,
    /// What an input would show if it were not forced.
    pub(crate) underneath: Option<Value>,
}

/// What was asked for within a scan.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Change {
    Set(Point, Value),
    Force(Point, Value),
    Unforce(Point),
    UnforceAll,
    Serial(Vec<u8>),
}

impl Simulation {
    /// A program before its first scan: a cold start.
    ///
    /// # Errors
    /// The program needs more memory than there is.
    pub fn new(program: Arc<Program>, options: Options) -> Result<Simulation, CompileError> {
        let compiled = compile(&program, options.interval)?;
        let mut memory = compiled.initial.clone();
        if compiled.ports.serial {
            // All the room at once: a scan allocates nothing.
            memory.sent.reserve_exact(SERIAL_ROOM);
        }
        let machine = Machine::new(
            memory,
            &compiled.fused.code,
            // One more for the places of blocks that are not drawn.
            program.networks.len() + 1,
            options.watchdog,
        );
        Ok(Simulation {
            names: Names::of(&program),
            points: groups::points(&program, &compiled.homes),
            program,
            compiled,
            machine,
            options,
            status: Status::Ready,
            forces: BTreeMap::new(),
            ran_plain: false,
            open: false,
            pending: Vec::new(),
            passed: 0,
            tree: OnceLock::new(),
            instances: OnceLock::new(),
            bodies: OnceLock::new(),
        })
    }

    /// The program that runs.
    pub fn program(&self) -> &Arc<Program> {
        &self.program
    }

    /// Its compiled form.
    pub fn compiled(&self) -> &Compiled {
        &self.compiled
    }

    /// How it runs.
    pub fn options(&self) -> Options {
        self.options
    }

    /// Sets what may cancel a scan that takes long; none lets every scan come to its end. A scan that was cancelled is
    /// a fault that stops the simulation; a [`Session`](crate::Session) takes it back instead.
    pub fn set_cancel(&mut self, cancel: Option<Cancel>) {
        self.machine.cancel = cancel;
    }

    /// What all scans have done so far, in blocks, as the watchdog counts them.
    pub fn work(&self) -> u64 {
        self.machine.worked
    }

    /// Stops the program with a fault: it has done all that it may.
    pub(crate) fn exhaust(&mut self, limit: u64) {
        self.machine
            .record(Trouble::Exhausted(limit), 0, self.machine.scan);
        self.status = Status::Faulted;
    }

    /// Whether it can go on.
    pub fn status(&self) -> Status {
        self.status
    }

    /// How many scans have been run.
    pub fn scans(&self) -> u64 {
        self.machine.scan as u64
    }

    /// The clock of the next scan, in nanoseconds since the start.
    pub fn time(&self) -> i64 {
        self.machine.now
    }

    /// How many faults were recorded since they were last taken.
    pub(crate) fn fault_count(&self) -> u64 {
        self.machine.faults.len() as u64 + self.machine.faults_lost
    }

    /// The faults that were recorded since they were last taken, oldest first.
    pub fn take_faults(&mut self) -> Vec<Fault> {
        self.machine.faults_lost = 0;
        let records = std::mem::take(&mut self.machine.faults);
        let faults = records.iter().map(|record| self.fault(record)).collect();
        self.machine.faults = records;
        self.machine.faults.clear();
        faults
    }

    pub(crate) fn fault(&self, record: &FaultRecord) -> Fault {
        let blocks = &self.compiled.code.blocks;
        let nowhere = Location {
            file: 0,
            range: ladder_syntax::TextRange::default(),
        };
        Fault {
            message: record.trouble.message(),
            location: blocks
                .get(record.block as usize)
                .map_or(nowhere, |block| block.location),
            scan: record.scan as u64,
            stops: record.trouble.stops(),
        }
    }

    /// Every value that a list of all tags has, in the order of the tags' first appearance: of timers, counters and bistables
    /// the members that show what they do (`t1.Q`, `t1.ET`), of arrays the elements, unless there are very many
    /// ([`Self::entries`] has those arrays too).
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// The value that a text names: `run`, `t1.ET`, `a[3]`, `w.15`, `SYS.SCAN`, in any case; a channel of a port,
    /// `PORT.ADC[0]`; or a tag of a place where a user-defined block is, `$RAMP#2.level`, see [`Self::instances`].
    ///
    /// # Errors
    /// There is no such value.
    pub fn resolve(&self, text: &str) -> Result<Point, UnknownTag> {
        if let Some(port) = tags::port(self.compiled.ports, text) {
            return port;
        }
        if let Some(of_instance) = self.resolve_in_instance(text) {
            return of_instance;
        }
        if let Some(of_plant) = self.resolve_system_of_plant(text) {
            return of_plant;
        }
        self.names.resolve(&self.program, &self.compiled.homes, text)
    }

    /// A system tag of a plant, `plant.SYS.FAULT`. None: the text names something else.
    fn resolve_system_of_plant(&self, text: &str) -> Option<Result<Point, UnknownTag>> {
        let system = self.compiled.plants.as_ref()?.system;
        let own = self
            .program
            .plants
            .iter()
            .find_map(|plant| plant.tag_in(text.trim()));
        let (sys, name) = own?.split_once('.')?;
        sys.eq_ignore_ascii_case("SYS").then(|| {
            let point = tags::system_tag(name.trim(), system)?;
            let plant = &text.trim()[..text.trim().len() - own.unwrap_or_default().len()];
            Ok(Point {
                name: format!("{plant}{}", point.name),
                ..point
            })
        })
    }

    /// The value of a place that is written so, if it always is the same one: not `a[i]`, and not the tags of a
    /// user-defined block's body, of which every place where the block is has its own.
    pub fn point_at(&self, place: &Place, written: &str) -> Option<Point> {
        let in_body = |tag: TagId| self.program.tags[tag.0 as usize].block.is_some();
        if place.root().is_some_and(in_body) {
            return None;
        }
        // What a body calls so may be another tag here.
        let point = self.resolve(written).ok()?;
        let is_it = |tag: TagId| self.compiled.homes[tag.0 as usize].holds(point.slot);
        place.root().is_none_or(is_it).then_some(point)
    }

    /// Whether the program uses the serial port.
    pub(crate) fn has_serial(&self) -> bool {
        self.compiled.ports.serial
    }

    /// Lets bytes come in at the serial port.
    pub fn feed_serial(&mut self, bytes: &[u8]) {
        if self.open {
            self.pending.push(Change::Serial(bytes.to_vec()));
            return;
        }
        self.machine.memory.received.extend(bytes);
    }

    /// The bytes that were sent through the serial port since they were last taken. The newest 65,536 are kept.
    pub fn take_serial(&mut self) -> Vec<u8> {
        self.machine.memory.sent.drain(..).collect()
    }

    /// What a point holds at a cold start.
    pub fn initial(&self, point: &Point) -> Value {
        point.read(&self.compiled.initial)
    }

    /// What a point holds.
    pub fn value(&self, point: &Point) -> Value {
        point.read(&self.machine.memory)
    }
}
