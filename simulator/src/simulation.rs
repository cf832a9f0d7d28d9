//! A program that runs: scans, inputs, forces, faults, and what can be seen of it.

use crate::compile::{CompileError, Compiled, compile};
use crate::fault::Fault;
use crate::fuse::Power;
use crate::machine::{FaultRecord, Halt, Machine};
use crate::memory::{Bit, Memory, SERIAL_ROOM, Word};
use crate::tags::{self, Names, Point, PointSlot, UnknownTag};
use ladder_analysis::program::{ElementKind, Location, Program, Role};
use ladder_analysis::types::Scalar;
use ladder_analysis::value::Value;
use std::collections::BTreeMap;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// How a program is run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Options {
    /// The time from one scan to the next, in nanoseconds.
    pub interval: i64,
    /// How many blocks a scan may evaluate before the watchdog stops the simulation.
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

/// Whether a program can go on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Status {
    /// The next scan can run.
    Ready,
    /// The program stopped itself with `<END>`.
    Ended,
    /// The watchdog, or calls nested too deep, stopped it in the middle of a scan.
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
    /// The last scan ran plain code, with forces.
    pub(crate) ran_plain: bool,
}

/// A force that is in effect.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Force {
    point: Point,
    /// What an input would show if it were not forced.
    underneath: Option<Value>,
}

impl Simulation {
    /// A program before its first scan: a cold start.
    ///
    /// # Errors
    /// The program needs more memory than there is.
    pub fn new(program: Arc<Program>, options: Options) -> Result<Simulation, CompileError> {
        let compiled = compile(&program)?;
        let mut memory = compiled.initial.clone();
        if compiled.ports.serial {
            // All the room at once: a scan allocates nothing.
            memory.sent.reserve_exact(SERIAL_ROOM);
        }
        let machine = Machine::new(
            memory,
            &compiled.fused.code,
            program.networks.len(),
            options.watchdog,
        );
        Ok(Simulation {
            names: Names::of(&program),
            points: Names::points(&program, &compiled.homes),
            program,
            compiled,
            machine,
            options,
            status: Status::Ready,
            forces: BTreeMap::new(),
            ran_plain: false,
        })
    }

    /// The program that runs.
    pub fn program(&self) -> &Arc<Program> {
        &self.program
    }

    /// How it runs.
    pub fn options(&self) -> Options {
        self.options
    }

    /// Runs one scan. False, and nothing happens, if the program has ended or a fault stopped it; false also if
    /// a fault stops it now, in the middle of this scan. The scan that reaches `<END>` counts as run.
    pub fn scan(&mut self) -> bool {
        if self.status != Status::Ready {
            return false;
        }
        let machine = &mut self.machine;
        let faults = machine.faults.len() as u64 + machine.faults_lost;
        machine.memory.set_bit(Bit::FIRST_SCAN, machine.scan == 0);
        machine.memory.set_bit(Bit::FAULT, machine.faulted);
        // SYS.SCAN is a DINT and wraps.
        machine.memory.words[Word::SCAN.0 as usize] = i64::from(machine.scan as i32);
        machine.memory.words[Word::TIME.0 as usize] = machine.now;
        machine.memory.words[Word::SCAN_TIME.0 as usize] = if machine.scan == 0 {
            0
        } else {
            self.options.interval
        };
        self.ran_plain = !self.forces.is_empty();
        let halt = if self.forces.is_empty() {
            machine.run::<false>(&self.compiled.fused.code)
        } else {
            machine.run::<true>(&self.compiled.code)
        };
        machine.faulted = machine.faults.len() as u64 + machine.faults_lost != faults;
        if halt == Halt::Stopped {
            self.status = Status::Faulted;
            return false;
        }
        machine.scan += 1;
        machine.now = machine.now.saturating_add(self.options.interval);
        if halt == Halt::Ended {
            self.status = Status::Ended;
        }
        true
    }

    /// Runs up to so many scans; fewer if the program stops, or when `cancel` is set. How many were run.
    pub fn run(&mut self, scans: u64, cancel: &AtomicBool) -> u64 {
        (0..scans)
            .take_while(|_| !cancel.load(Ordering::Relaxed) && self.scan())
            .count() as u64
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

    /// Begins again from cold: all tags as before the first scan. Forces stay.
    pub fn reset(&mut self) {
        self.restart(None);
    }

    /// Begins again as after a power failure: retentive tags keep their values, all others begin as before the
    /// first scan. Forces stay.
    pub fn warm_restart(&mut self) {
        let kept = self.machine.memory.clone();
        self.restart(Some(&kept));
    }

    fn restart(&mut self, kept: Option<&Memory>) {
        let now = self.machine.now;
        let forced: Vec<(Point, Value)> = self
            .forces
            .values()
            .map(|force| (force.point.clone(), self.value(&force.point)))
            .collect();
        self.unforce_all();
        self.machine.restart(&self.compiled.initial);
        if let Some(kept) = kept {
            for range in &self.compiled.retained {
                range.restore(&mut self.machine.memory, kept, now);
            }
        }
        self.status = Status::Ready;
        for (point, value) in forced {
            self.hold(point, value);
        }
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

    /// Every scalar tag in the order of its first appearance. Of timers, counters and bistables it has the members
    /// that show what they do (`t1.Q`, `t1.ET`); arrays are found element by element with [`Self::resolve`].
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// The value that a text names: `run`, `t1.ET`, `a[3]`, `w.15`, `SYS.SCAN`, in any case; or a channel of a port,
    /// `PORT.ADC[0]`.
    ///
    /// # Errors
    /// There is no such value.
    pub fn resolve(&self, text: &str) -> Result<Point, UnknownTag> {
        if let Some(port) = tags::port(self.compiled.ports, text) {
            return port;
        }
        self.names.resolve(&self.program, &self.compiled.homes, text)
    }

    /// Lets bytes come in at the serial port.
    pub fn feed_serial(&mut self, bytes: &[u8]) {
        self.machine.memory.received.extend(bytes);
    }

    /// The bytes that were sent through the serial port since they were last taken. The newest 65,536 are kept.
    pub fn take_serial(&mut self) -> Vec<u8> {
        self.machine.memory.sent.drain(..).collect()
    }

    /// What a point holds.
    pub fn value(&self, point: &Point) -> Value {
        point.read(&self.machine.memory)
    }

    /// Every part of the drawing that carries power, and whether it had power in the last scan. What that scan
    /// did not reach has none.
    pub fn power(&self) -> impl Iterator<Item = (ElementKind, Location, bool)> + '_ {
        self.compiled.elements.iter().map(|element| {
            let network = element.network as usize;
            let reached = self.machine.scan > 0
                && (!self.compiled.skippable[network]
                    || (self.machine.reached[network] == self.machine.scan
                        && element.step <= self.machine.left_at[network]));
            (
                element.kind,
                element.location,
                reached && self.has_power(element.power),
            )
        })
    }

    fn has_power(&self, slot: Bit) -> bool {
        let place = if self.ran_plain {
            Power::Slot(slot)
        } else {
            self.compiled.fused.power(slot)
        };
        match place {
            Power::Slot(slot) => self.machine.memory.bit(slot),
            Power::Row { record, truth } => truth >> (self.machine.rows[record as usize] & 7) & 1 != 0,
        }
    }

    /// Gives a tag a value before the next scan, as the world outside does. A forced tag goes on showing its
    /// forced value.
    ///
    /// # Errors
    /// The point is read-only, or the value does not fit its type.
    pub fn set(&mut self, point: &Point, value: Value) -> Result<(), Refused> {
        check(point, &value)?;
        if let Some(force) = self.forces.get_mut(&point.name) {
            if point.role == Role::Input {
                force.underneath = Some(value);
            }
            return Ok(());
        }
        self.write(point, &value);
        Ok(())
    }

    /// Holds a tag at a value: it reads as this value everywhere, and writes to it have no effect.
    ///
    /// # Errors
    /// The point is read-only, or the value does not fit its type.
    pub fn force(&mut self, point: &Point, value: Value) -> Result<(), Refused> {
        check(point, &value)?;
        self.hold(point.clone(), value);
        Ok(())
    }

    fn hold(&mut self, point: Point, value: Value) {
        let before = match self.forces.get(&point.name) {
            Some(force) => force.underneath.clone(),
            None => (point.role == Role::Input).then(|| self.value(&point)),
        };
        if self.forces.is_empty() {
            self.make_room_for_marks();
        }
        self.mark(&point, true);
        // The value goes in underneath the mark, which only keeps the program from writing.
        self.write(&point, &value);
        self.forces.insert(
            point.name.clone(),
            Force {
                point,
                underneath: before,
            },
        );
    }

    /// Lets a tag go. An input shows its own value again, any other tag keeps the forced one until it is written.
    /// Nothing happens if it is not forced.
    pub fn unforce(&mut self, point: &Point) {
        let Some(force) = self.forces.remove(&point.name) else {
            return;
        };
        self.mark(&force.point, false);
        // A word and a bit of it may both be forced.
        let others: Vec<Point> = self.forces.values().map(|other| other.point.clone()).collect();
        for other in &others {
            self.mark(other, true);
        }
        if let Some(value) = force.underneath {
            self.write(&force.point, &value);
        }
    }

    /// Lets all tags go.
    pub fn unforce_all(&mut self) {
        for force in std::mem::take(&mut self.forces).into_values() {
            self.mark(&force.point, false);
            if let Some(value) = force.underneath {
                self.write(&force.point, &value);
            }
        }
    }

    /// Makes these the forces. The banks already hold what forced points show.
    pub(crate) fn restore_forces(&mut self, forces: &BTreeMap<String, Force>) {
        if self.forces == *forces {
            return;
        }
        for force in std::mem::take(&mut self.forces).into_values() {
            self.mark(&force.point, false);
        }
        self.forces.clone_from(forces);
        if !forces.is_empty() {
            self.make_room_for_marks();
        }
        for force in forces.values() {
            self.mark(&force.point, true);
        }
    }

    fn make_room_for_marks(&mut self) {
        let memory = &mut self.machine.memory;
        memory.held.bits = vec![0; memory.bits.len()];
        memory.held.words = vec![0; memory.words.len()];
        memory.held.texts = vec![false; memory.texts.len()];
    }

    /// Whether a point is forced.
    pub fn is_forced(&self, point: &Point) -> bool {
        !self.forces.is_empty() && self.forces.contains_key(&point.name)
    }

    /// The points that are forced, by name.
    pub fn forced(&self) -> impl Iterator<Item = &Point> {
        self.forces.values().map(|force| &force.point)
    }

    /// Writes past all forces.
    fn write(&mut self, point: &Point, value: &Value) {
        let memory = &mut self.machine.memory;
        match (point.slot, value) {
            (PointSlot::Bit(slot), Value::Bool(high)) => memory.set_bit(slot, *high),
            (PointSlot::Word(slot), Value::Int(number)) => memory.words[slot.0 as usize] = *number,
            (PointSlot::Word(slot), Value::Real(real)) => {
                let real = if point.ty == Scalar::Real {
                    f64::from(*real as f32)
                } else {
                    *real
                };
                memory.words[slot.0 as usize] = real.to_bits() as i64;
            }
            (PointSlot::Text(slot), Value::Text(bytes)) => memory.texts[slot.0 as usize].set(bytes),
            (PointSlot::BitOf { word, bit, ty }, Value::Bool(high)) => {
                let mask = 1i64 << bit;
                let value = memory.word(word) & !mask | if *high { mask } else { 0 };
                memory.words[word.0 as usize] = ladder_analysis::value::wrap(value, ty);
            }
            _ => {}
        }
    }

    /// Marks a slot as held, or not.
    fn mark(&mut self, point: &Point, held: bool) {
        let marks = &mut self.machine.memory.held;
        match point.slot {
            PointSlot::Bit(slot) => marks.bits[slot.0 as usize] = u8::from(held),
            PointSlot::Word(slot) => marks.words[slot.0 as usize] = if held { -1 } else { 0 },
            PointSlot::Text(slot) => marks.texts[slot.0 as usize] = held,
            PointSlot::BitOf { word, bit, ty } => {
                // The sign's copies above the width go with the highest bit.
                let mask = if ty.is_signed() && u32::from(bit) + 1 == ty.width() {
                    -1 << bit
                } else {
                    1 << bit
                };
                let marks = &mut marks.words[word.0 as usize];
                *marks = if held { *marks | mask } else { *marks & !mask };
            }
            PointSlot::Timing { .. } => {}
        }
    }
}

/// Whether a point takes a value from outside.
fn check(point: &Point, value: &Value) -> Result<(), Refused> {
    if point.read_only {
        return Err(Refused {
            message: format!("{} is read-only: it cannot be given a value", point.name),
        });
    }
    let fits = match (value, point.ty) {
        (Value::Bool(_), Scalar::Bool) => true,
        (Value::Real(real), ty) => ty.is_real() && real.is_finite(),
        (Value::Text(_), ty) => ty.is_string(),
        (Value::Int(number), ty) => match ty.bounds() {
            Some(_) => ladder_analysis::value::wrap(*number, ty) == *number,
            None => ty == Scalar::Time || ty.is_date(),
        },
        (Value::Bool(_), _) => false,
    };
    if fits {
        return Ok(());
    }
    Err(Refused {
        message: format!("{} is a {} and cannot hold this value", point.name, point.ty),
    })
}

/// Why a tag did not take a value.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refused {
    /// What is wrong and what to do.
    pub message: String,
}

impl std::fmt::Display for Refused {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Refused {}
