//! The machine that runs flat code: one scan is one walk through it.

mod execute;
mod flow;
mod position;
mod state;

use crate::code::{Code, Instr};
use crate::controller::Relay;
use crate::fault::Trouble;
use crate::memory::{Bit, Memory};
use crate::timers::Clock;
use crate::work::{CALL_DEPTH, UNCANCELLED};
use execute::{Onward, execute};
use flow::{Flow, Frame, Loop};
use ladder_analysis::Cancel;
use ladder_analysis::program::DEEPEST_LOOP;
use ladder_instructions::Controller;
use position::Position;
pub(crate) use position::Until;
pub(crate) use state::MachineState;

/// How a scan ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Halt {
    /// It ran to its end.
    Done,
    /// `<END>`: no scan follows.
    Ended,
    /// Watchdog or call depth: the scan was not finished.
    Stopped,
    /// It is in front of a block or network where it was to halt, and can go on.
    Halted,
}

/// A fault as the machine records it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FaultRecord {
    pub(crate) trouble: Trouble,
    /// The block, as an index into [`Code::blocks`].
    pub(crate) block: u32,
    pub(crate) scan: i64,
}

/// Whether a scan recorded a fault: each has a `SYS.FAULT` of its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Faulted {
    pub(crate) program: bool,
    pub(crate) plants: bool,
}

/// A program's state while it runs.
#[derive(Debug)]
pub(crate) struct Machine {
    pub(crate) memory: Memory,
    /// The clock of the scan that runs, or of the next one.
    pub(crate) now: i64,
    /// The scan that runs, or the next one, from 0.
    pub(crate) scan: i64,
    /// Blocks that a scan may evaluate.
    pub(crate) watchdog: u64,
    /// What may stop a scan that takes long.
    pub(crate) cancel: Option<Cancel>,
    /// What all scans have done so far, in blocks.
    pub(crate) worked: u64,
    /// Faults, at most as many as there is room for.
    pub(crate) faults: Vec<FaultRecord>,
    /// How many were not kept for want of room.
    pub(crate) faults_lost: u64,
    /// Whether the last scan recorded a fault.
    pub(crate) faulted: Faulted,
    /// Whether the scan that runs has recorded one.
    fault_now: Faulted,
    /// Whether the scan that runs is the last one, though it runs to its end.
    pub(crate) ending: bool,
    /// For each network the last scan that reached it, counted from 1; kept only where scans may skip it.
    pub(crate) reached: Vec<i64>,
    /// For each network the step at which it was last left early, else the largest number.
    pub(crate) left_at: Vec<u32>,
    /// For each record of fused code the row that it last took.
    pub(crate) rows: Vec<u8>,
    position: Position,
    frames: Vec<Frame>,
    saved: Vec<u8>,
    /// The loops that run around the innermost one of each frame, from the outside in.
    outer_loops: Vec<Loop>,
}

/// Room for this many faults between two checks of them.
const FAULTS: usize = 4096;

impl Machine {
    pub(crate) fn new(memory: Memory, code: &Code, networks: usize, watchdog: u64) -> Machine {
        let widest = code.saved.iter().map(Vec::len).max().unwrap_or(0);
        Machine {
            memory,
            now: 0,
            scan: 0,
            watchdog,
            cancel: None,
            worked: 0,
            faults: Vec::with_capacity(FAULTS),
            faults_lost: 0,
            faulted: Faulted::default(),
            fault_now: Faulted::default(),
            ending: false,
            position: Position::start(watchdog),
            reached: vec![0; networks],
            left_at: vec![u32::MAX; networks],
            rows: vec![0; code.records.len()],
            frames: Vec::with_capacity(CALL_DEPTH + 1),
            saved: Vec::with_capacity(CALL_DEPTH * widest),
            outer_loops: Vec::with_capacity(DEEPEST_LOOP * (CALL_DEPTH + 1)),
        }
    }

    /// Begins again with this memory.
    pub(crate) fn restart(&mut self, memory: &Memory) {
        self.memory.bits.copy_from_slice(&memory.bits);
        self.memory.words.copy_from_slice(&memory.words);
        self.memory.texts.clone_from(&memory.texts);
        self.memory.received.clear();
        self.memory.sent.clear();
        (self.now, self.scan, self.faulted) = (0, 0, Faulted::default());
        self.faults.clear();
        self.faults_lost = 0;
        self.reached.fill(0);
        self.left_at.fill(u32::MAX);
    }

    /// Begins a scan.
    pub(crate) fn begin(&mut self) {
        self.frames.clear();
        self.saved.clear();
        self.outer_loops.clear();
        self.fault_now = Faulted::default();
        self.ending = false;
        self.position = Position::start(self.watchdog);
    }

    /// Ends a scan that ran to an end of its own.
    pub(crate) fn finish(&mut self, interval: i64) {
        self.faulted = self.fault_now;
        self.worked += self.watchdog - self.position.budget;
        self.scan += 1;
        self.now = self.now.saturating_add(interval);
    }

    /// Runs on in the scan that was begun. `PLAIN` code respects forces, and can halt; fused code is never asked to.
    pub(crate) fn run<const PLAIN: bool>(&mut self, code: &Code, until: Until) -> Halt {
        let clock = Clock {
            now: self.now,
            scan: self.scan + 1,
        };
        let mut pc = self.position.pc;
        let mut passed = self.position.passed;
        // The stretch of code that may run before the watchdog must be asked again: where code runs straight on,
        // what is evaluated is known beforehand, so nothing is counted there.
        let (mut entered, mut instrs) = stretch(code, pc, self.position.budget);
        loop {
            let Some(instr) = instrs.get(pc) else {
                let block = first_beyond(code, entered + self.position.budget);
                self.record(Trouble::Watchdog(self.watchdog), block, clock.scan);
                self.position.budget = 0;
                return Halt::Stopped;
            };
            if PLAIN {
                if until.halts(code, pc, passed) {
                    self.position.pay(work_before(code, pc) - entered);
                    self.position.pc = pc;
                    self.position.passed = until.passed();
                    return Halt::Halted;
                }
                passed = 0;
            }
            match execute::<PLAIN>(&mut self.memory, &mut self.rows, code, instr, clock) {
                Ok(Onward::Next) => pc += 1,
                Ok(Onward::Skip(to)) => pc = to as usize,
                Ok(Onward::Flow) => match self.flow(code, instr, pc, clock) {
                    Flow::Next => pc += 1,
                    Flow::Go(to) => {
                        // Straight-line code ends here: its blocks are paid for.
                        self.position.pay(work_before(code, pc + 1) - entered);
                        if self.is_cancelled() {
                            self.record(Trouble::Cancelled, code.block_at(pc as u32), clock.scan);
                            return Halt::Stopped;
                        }
                        pc = to as usize;
                        (entered, instrs) = stretch(code, pc, self.position.budget);
                    }
                    Flow::Halt(halt) => {
                        self.position.pay(work_before(code, pc + 1) - entered);
                        return halt;
                    }
                },
                Ok(Onward::Work(0)) => pc += 1,
                Ok(Onward::Work(blocks)) => {
                    pc += 1;
                    self.position.pay(work_before(code, pc) - entered);
                    if let Err(trouble) = self.pay_for_elements(blocks) {
                        self.record(trouble, code.block_at(pc as u32 - 1), clock.scan);
                        return Halt::Stopped;
                    }
                    (entered, instrs) = stretch(code, pc, self.position.budget);
                }
                Err(trouble) => pc = self.fault(code, pc, trouble, clock),
            }
        }
    }

    /// A block did something to many elements.
    fn pay_for_elements(&mut self, blocks: u32) -> Result<(), Trouble> {
        let blocks = u64::from(blocks);
        if blocks > self.position.budget {
            self.position.budget = 0;
            return Err(Trouble::Elements(self.watchdog));
        }
        self.position.pay(blocks);
        if self.is_cancelled() {
            return Err(Trouble::Cancelled);
        }
        Ok(())
    }

    /// Whether this scan takes long, and the caller wants it to stop.
    fn is_cancelled(&self) -> bool {
        self.watchdog - self.position.budget >= UNCANCELLED
            && self.cancel.as_ref().is_some_and(Cancel::is_cancelled)
    }

    /// A fault that the scan survives: the block has no power, and the code after it goes on.
    #[cold]
    fn fault(&mut self, code: &Code, pc: usize, trouble: Trouble, clock: Clock) -> usize {
        let block = code.block_at(pc as u32);
        let place = &code.blocks[block as usize];
        let is_signalled = place.controller == Controller::Banks && self.signal(code, trouble);
        if !is_signalled {
            let before = self.fault_now;
            self.record(trouble, block, clock.scan);
            if place.is_of_plant {
                self.fault_now = Faulted {
                    plants: true,
                    ..before
                };
            }
        }
        if trouble.is_remark() {
            self.ending = true;
            return place.end as usize;
        }
        if place.out != Bit::LOW && place.out != Bit::HIGH {
            self.memory.set_bit(place.out, false);
        }
        place.end as usize
    }

    /// Reports an error in the controller's relays; returns whether that is all there is to report. A function outside its
    /// domain stops the controller.
    fn signal(&mut self, code: &Code, trouble: Trouble) -> bool {
        let Some(relay) = Relay::of(trouble) else {
            return false;
        };
        let stops = relay == Relay::Math;
        let slots = [code.relays.slot(relay), code.relays.stop.filter(|_| stops)];
        for slot in slots.into_iter().flatten() {
            if self.memory.held.bits.get(slot.0 as usize) != Some(&1) {
                self.memory.set_bit(slot, true);
            }
        }
        self.ending |= stops;
        !stops
    }

    pub(crate) fn record(&mut self, trouble: Trouble, block: u32, scan: i64) {
        self.fault_now.program = true;
        // A fault that stops the simulation is always kept: it is why nothing moves any more.
        if self.faults.len() == self.faults.capacity() {
            self.faults_lost += 1;
            if !trouble.stops() {
                return;
            }
            self.faults.pop();
        }
        self.faults.push(FaultRecord {
            trouble,
            block,
            scan: scan - 1,
        });
    }
}

/// The code that may run on from an instruction before the watchdog must be asked, and the work of what is before
/// it.
fn stretch(code: &Code, pc: usize, budget: u64) -> (u64, &[Instr]) {
    let before = work_before(code, pc);
    let most = before.saturating_add(budget);
    let all = code.work_through.last().map_or(0, |&work| u64::from(work));
    if most >= all {
        return (before, &code.instrs);
    }
    let end = code.work_through.partition_point(|&work| u64::from(work) <= most);
    (before, &code.instrs[..end])
}

/// What the blocks count that begin before an instruction.
fn work_before(code: &Code, pc: usize) -> u64 {
    match pc {
        0 => 0,
        _ => u64::from(code.work_through[pc - 1]),
    }
}

/// The first block that is too much, if blocks may count so much from the beginning of the code.
fn first_beyond(code: &Code, most: u64) -> u32 {
    code.blocks
        .partition_point(|block| u64::from(block.work_through) <= most) as u32
}
