//! The machine that runs flat code: one scan is one walk through it.

mod execute;
mod position;
mod state;

use crate::code::{Code, Instr, NOTHING_SAVED, Record};
use crate::fault::Trouble;
use crate::memory::{Bit, Memory};
use crate::timers::Clock;
use execute::execute;
use position::Position;
pub(crate) use position::Until;
pub(crate) use state::MachineState;

/// How deep calls may nest (LANGUAGE §5.5).
pub(crate) const CALL_DEPTH: usize = 64;

/// How a scan ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Halt {
    /// It ran to its end.
    Done,
    /// `<END>`: no scan follows.
    Ended,
    /// Watchdog or call depth: the scan was not finished.
    Stopped,
    /// It stands in front of a block or network where it was to halt, and can go on.
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

/// A loop that is being run: code from `body` up to `behind`.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
struct Loop {
    body: u32,
    behind: u32,
    /// Turns that follow this one; none runs if both ends are 0.
    left: i64,
}

/// What a call, or the body of a user-defined block, has of its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Frame {
    /// Where the caller goes on.
    back: u32,
    rail: bool,
    turning: Loop,
    /// Turns that a `<FOR>` has noted for the end of its network.
    noted: i64,
    saved: u32,
}

impl Frame {
    fn new(back: u32, saved: u32) -> Frame {
        Frame {
            back,
            rail: true,
            turning: Loop::default(),
            noted: 0,
            saved,
        }
    }
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
    /// Faults, at most as many as there is room for.
    pub(crate) faults: Vec<FaultRecord>,
    /// How many were not kept for want of room.
    pub(crate) faults_lost: u64,
    /// Whether the last scan recorded a fault.
    pub(crate) faulted: bool,
    /// Whether the scan that runs has recorded one.
    fault_now: bool,
    /// For each network the last scan that reached it, counted from 1; kept only where scans may skip it.
    pub(crate) reached: Vec<i64>,
    /// For each network the step at which it was last left early, else the largest number.
    pub(crate) left_at: Vec<u32>,
    /// For each record of fused code the row that it last took.
    pub(crate) rows: Vec<u8>,
    position: Position,
    frames: Vec<Frame>,
    saved: Vec<u8>,
}

/// Room for this many faults between two looks at them.
const FAULTS: usize = 4096;

impl Machine {
    pub(crate) fn new(memory: Memory, code: &Code, networks: usize, watchdog: u64) -> Machine {
        let widest = code.saved.iter().map(Vec::len).max().unwrap_or(0);
        Machine {
            memory,
            now: 0,
            scan: 0,
            watchdog,
            faults: Vec::with_capacity(FAULTS),
            faults_lost: 0,
            faulted: false,
            fault_now: false,
            position: Position::start(watchdog),
            reached: vec![0; networks],
            left_at: vec![u32::MAX; networks],
            rows: vec![0; code.records.len()],
            frames: Vec::with_capacity((CALL_DEPTH + 1) * (code.depth + 1)),
            saved: Vec::with_capacity(CALL_DEPTH * widest),
        }
    }

    /// Begins again with this memory.
    pub(crate) fn restart(&mut self, memory: &Memory) {
        self.memory.bits.copy_from_slice(&memory.bits);
        self.memory.words.copy_from_slice(&memory.words);
        self.memory.texts.clone_from(&memory.texts);
        self.memory.received.clear();
        self.memory.sent.clear();
        (self.now, self.scan, self.faulted) = (0, 0, false);
        self.faults.clear();
        self.faults_lost = 0;
        self.reached.fill(0);
        self.left_at.fill(u32::MAX);
    }

    /// Begins a scan.
    pub(crate) fn begin(&mut self) {
        self.frames.clear();
        self.saved.clear();
        self.fault_now = false;
        self.position = Position::start(self.watchdog);
    }

    /// Ends a scan that ran to an end of its own.
    pub(crate) fn finish(&mut self, interval: i64) {
        self.faulted = self.fault_now;
        self.scan += 1;
        self.now = self.now.saturating_add(interval);
    }

    /// Runs on in the scan that was begun. `PLAIN` code respects forces, and can halt; fused code is never asked to.
    pub(crate) fn run<const PLAIN: bool>(&mut self, code: &Code, until: Until) -> Halt {
        let clock = Clock {
            now: self.now,
            scan: self.scan + 1,
        };
        let Position {
            mut pc,
            mut frame,
            mut calls,
            mut budget,
            mut passed,
        } = self.position;
        // The stretch of code that may run before the watchdog must be asked again: where code runs straight on,
        // what is evaluated is known beforehand, so nothing is counted there.
        let (mut entered, mut instrs) = stretch(code, pc, budget);

        // Leaves straight-line code: pays for the blocks of the stretch, then goes on elsewhere.
        macro_rules! go {
            ($to:expr) => {{
                let paid = u64::from(code.blocks_through[pc]) - entered;
                budget = budget.saturating_sub(paid);
                pc = $to as usize;
                (entered, instrs) = stretch(code, pc, budget);
                continue;
            }};
        }
        macro_rules! fault {
            ($trouble:expr) => {{
                let block = block_at(code, pc);
                self.record($trouble, block, clock.scan);
                let place = &code.blocks[block as usize];
                if place.out != Bit::LOW && place.out != Bit::HIGH {
                    self.memory.set_bit(place.out, false);
                }
                pc = place.end as usize;
                continue;
            }};
        }
        loop {
            let Some(&instr) = instrs.get(pc) else {
                let block = entered + budget;
                self.record(Trouble::Watchdog(self.watchdog), block as u32, clock.scan);
                self.position.frame = frame;
                return Halt::Stopped;
            };
            if PLAIN {
                if until.halts(code, pc, passed) {
                    let paid = blocks_before(code, pc).saturating_sub(entered);
                    budget = budget.saturating_sub(paid);
                    passed = until.passed();
                    self.position = Position {
                        pc,
                        frame,
                        calls,
                        budget,
                        passed,
                    };
                    return Halt::Halted;
                }
                passed = 0;
            }
            let memory = &mut self.memory;
            match instr {
                Instr::Rail { out } => memory.set_bit(out, frame.rail),
                Instr::Powered { out, en, end } => {
                    let power = memory.bit(en);
                    memory.set_bit(out, power);
                    if !power {
                        pc = end as usize;
                        continue;
                    }
                }
                Instr::Records { start, count } => {
                    let run = start as usize..(start + count) as usize;
                    look_up(memory, &code.records[run.clone()], &mut self.rows[run]);
                }
                Instr::Network { network } => {
                    self.reached[network as usize] = clock.scan;
                    self.left_at[network as usize] = u32::MAX;
                }
                Instr::Left { step, network } => self.left_at[network as usize] = step,
                Instr::Jump {
                    en,
                    to,
                    step,
                    network,
                } => {
                    if memory.bit(en) {
                        self.left_at[network as usize] = step;
                        frame.noted = 0;
                        if to < frame.turning.body || to >= frame.turning.behind {
                            frame.turning = Loop::default();
                        }
                        go!(to);
                    }
                }
                Instr::Call { en, to, saved } => {
                    if memory.bit(en) {
                        if calls == CALL_DEPTH {
                            self.record(Trouble::CallDepth, block_at(code, pc), clock.scan);
                            self.position.frame = frame;
                            return Halt::Stopped;
                        }
                        calls += 1;
                        if saved != NOTHING_SAVED {
                            let powers = &code.saved[saved as usize];
                            self.saved
                                .extend(powers.iter().map(|power| memory.bits[power.0 as usize]));
                        }
                        self.frames.push(frame);
                        frame = Frame::new(pc as u32 + 1, saved);
                        go!(to);
                    }
                }
                Instr::Return { en, step, network } => {
                    if memory.bit(en) {
                        self.left_at[network as usize] = step;
                        let Some(caller) = self.frames.pop() else {
                            return Halt::Done;
                        };
                        calls -= 1;
                        let back = self.come_back(code, frame);
                        frame = caller;
                        go!(back);
                    }
                }
                Instr::End { en, step, network } => {
                    if memory.bit(en) {
                        self.left_at[network as usize] = step;
                        return Halt::Ended;
                    }
                }
                Instr::Finish => {
                    let Some(caller) = self.frames.pop() else {
                        return Halt::Done;
                    };
                    calls -= 1;
                    let back = self.come_back(code, frame);
                    frame = caller;
                    go!(back);
                }
                Instr::For { en, turns } => {
                    frame.noted = if memory.bit(en) { memory.word(turns) } else { 0 };
                }
                Instr::Enter { body, behind } => {
                    let turns = std::mem::take(&mut frame.noted);
                    if turns <= 0 {
                        go!(behind);
                    }
                    frame.turning = Loop {
                        body,
                        behind,
                        left: turns - 1,
                    };
                }
                Instr::Again => {
                    if frame.turning.left > 0 {
                        frame.turning.left -= 1;
                        frame.noted = 0;
                        go!(frame.turning.body);
                    }
                    frame.turning = Loop::default();
                }
                Instr::Mcr { en } => frame.rail = memory.bit(en),
                Instr::EnterBody => {
                    self.frames.push(frame);
                    frame = Frame::new(0, NOTHING_SAVED);
                }
                Instr::LeaveBody => {
                    if let Some(outer) = self.frames.pop() {
                        frame = outer;
                    }
                }
                straight => {
                    if let Err(trouble) = execute::<PLAIN>(memory, code, straight, clock) {
                        fault!(trouble);
                    }
                }
            }
            pc += 1;
        }
    }

    /// Gives a caller its powers back; where it goes on.
    fn come_back(&mut self, code: &Code, frame: Frame) -> u32 {
        if frame.saved != NOTHING_SAVED {
            let powers = &code.saved[frame.saved as usize];
            let start = self.saved.len() - powers.len();
            for (power, value) in powers.iter().zip(self.saved.drain(start..)) {
                self.memory.bits[power.0 as usize] = value;
            }
        }
        frame.back
    }

    fn record(&mut self, trouble: Trouble, block: u32, scan: i64) {
        self.fault_now = true;
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

/// The code that may run on from an instruction before the watchdog must be asked, and the number of blocks that
/// stand before it.
fn stretch(code: &Code, pc: usize, budget: u64) -> (u64, &[Instr]) {
    let before = blocks_before(code, pc);
    let most = before.saturating_add(budget);
    let all = code.blocks_through.last().map_or(0, |&blocks| u64::from(blocks));
    if most >= all {
        return (before, &code.instrs);
    }
    let end = code
        .blocks_through
        .partition_point(|&blocks| u64::from(blocks) <= most);
    (before, &code.instrs[..end])
}

/// How many blocks begin before an instruction.
fn blocks_before(code: &Code, pc: usize) -> u64 {
    match pc {
        0 => 0,
        _ => u64::from(code.blocks_through[pc - 1]),
    }
}

/// The innermost block that an instruction belongs to.
fn block_at(code: &Code, pc: usize) -> u32 {
    let pc = pc as u32;
    let mut block = code.blocks.partition_point(|block| block.start <= pc);
    while block > 1 && code.blocks[block - 1].end <= pc {
        block -= 1;
    }
    block.saturating_sub(1) as u32
}

/// Runs records: each looks up its result and notes the row.
fn look_up(memory: &mut Memory, records: &[Record], rows: &mut [u8]) {
    let bits = memory.bits.as_mut_slice();
    for (record, row) in records.iter().zip(rows) {
        let [a, b, c] = record.inputs;
        let index = bits[a.0 as usize] | bits[b.0 as usize] << 1 | bits[c.0 as usize] << 2;
        *row = index;
        bits[record.out.0 as usize] = record.truth >> (index & 7) & 1;
    }
}
