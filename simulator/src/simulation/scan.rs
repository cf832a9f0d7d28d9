//! Scans: whole, or in steps.

use super::{Simulation, Status};
use crate::code::{Instr, stop};
use crate::machine::{Halt, Until};
use crate::memory::{Bit, Word};
use crate::system::{Moment, System};
use ladder_analysis::Cancel;
use ladder_analysis::program::Location;

/// Where a step in a scan led.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stepped {
    /// In front of this block or network, which runs next.
    At(Location),
    /// The scan is over. [`Simulation::status`] shows whether another can follow.
    Done,
    /// A fault stopped the program within this scan.
    Stopped,
}

impl Simulation {
    /// Runs one scan; the rest of it, if one is open. False, and nothing happens, if the program has ended or a
    /// fault stopped it; false also if a fault stops it now, in the middle of this scan. The scan that reaches
    /// `<END>` counts as run.
    pub fn scan(&mut self) -> bool {
        if self.open {
            return self.finish_scan();
        }
        if self.status != Status::Ready {
            return false;
        }
        self.start();
        self.ran_plain = !self.forces.is_empty();
        let halt = if self.is_off() {
            Halt::Done
        } else if self.ran_plain {
            self.machine.run::<true>(&self.compiled.code, Until::End)
        } else {
            self.machine.run::<false>(&self.compiled.fused.code, Until::End)
        };
        self.end_scan(halt) == Stepped::Done
    }

    /// Time passes without a scan: so many intervals, for which a run in real time came too late. The next scan has them in
    /// `SYS.SCAN_TIME`, and timers have them, too.
    pub fn pass(&mut self, intervals: u64) {
        let passed = i64::try_from(intervals).unwrap_or(i64::MAX);
        let passed = passed.saturating_mul(self.options.interval);
        self.passed = self.passed.saturating_add(passed);
        self.machine.now = self.machine.now.saturating_add(passed);
    }

    /// Runs up to this many scans; fewer if the program stops, or when that is cancelled. How many were run.
    pub fn run(&mut self, scans: u64, cancel: &Cancel) -> u64 {
        (0..scans)
            .take_while(|_| !cancel.is_cancelled() && self.scan())
            .count() as u64
    }

    /// Begins a scan that is to be run in steps: it is in front of the first network. False if the program has
    /// ended or a fault stopped it. Nothing happens if one is open.
    ///
    /// What of it has run shows in [`Self::value`] and [`Self::power`]; what is set or forced now waits for its end.
    pub fn begin_scan(&mut self) -> bool {
        if self.open {
            return true;
        }
        if self.status != Status::Ready {
            return false;
        }
        self.start();
        self.machine.memory.make_room_for_forces();
        self.ran_plain = true;
        self.open = true;
        true
    }

    /// Whether a scan was begun and is not finished.
    pub fn is_open(&self) -> bool {
        self.open
    }

    /// The block that runs next in the scan that is open; none after the last one.
    pub fn next_block(&self) -> Option<Location> {
        let code = &self.compiled.code;
        let pc = self.open.then(|| self.machine.open_scan().pc())?;
        code.block_from(pc).map(|block| block.location)
    }

    /// Goes on up to the next block, into called functions and the bodies of user-defined blocks too. Blocks that do
    /// nothing when they run (`<LBL>`, `<FUN>`, `<NEXT>`, `[PERSIST]`) are passed by. Begins a scan if none is open:
    /// then it is in front of the first block.
    pub fn step_block(&mut self) -> Stepped {
        self.step(Until::Block)
    }

    /// Goes on up to the next network, likewise.
    pub fn step_network(&mut self) -> Stepped {
        self.step(Until::Network)
    }

    /// Runs the rest of the scan that is open. False if a fault stops it, or if none is open.
    pub fn finish_scan(&mut self) -> bool {
        self.open && self.step(Until::End) == Stepped::Done
    }

    /// Marks the places from which a scan may come to the same code a second time: the ends of loops and functions, and
    /// jumps back. False if there are none, so that each network runs once in a scan.
    pub(crate) fn mark_turns(&mut self) -> bool {
        let code = &mut self.compiled.code;
        let ends_main = code.instrs.iter().position(|instr| *instr == Instr::Finish);
        let mut is_marked = false;
        for (at, (instr, stops)) in code.instrs.iter().zip(&mut code.stops).enumerate() {
            let leads_back = match *instr {
                Instr::Again { .. } | Instr::Return { .. } => true,
                Instr::Jump { to, .. } => to as usize <= at,
                Instr::Finish => ends_main != Some(at),
                _ => false,
            };
            if leads_back {
                *stops |= stop::MARK;
                is_marked = true;
            }
        }
        is_marked
    }

    /// Runs one scan as [`Self::scan`] does; `look` sees it at each mark.
    pub(crate) fn scan_by_turns(&mut self, mut look: impl FnMut(&Simulation)) -> bool {
        loop {
            match self.step(Until::Marked) {
                Stepped::At(_) => look(self),
                Stepped::Done => return true,
                Stepped::Stopped => return false,
            }
        }
    }

    pub(crate) fn step(&mut self, until: Until) -> Stepped {
        if !self.begin_scan() {
            return Stepped::Stopped;
        }
        let halt = if self.is_off() {
            Halt::Done
        } else {
            self.machine.run::<true>(&self.compiled.code, until)
        };
        if halt == Halt::Halted {
            return Stepped::At(self.is_at(until));
        }
        self.open = false;
        let stepped = self.end_scan(halt);
        self.take_pending();
        stepped
    }

    /// The network or block in front of which the scan has halted.
    fn is_at(&self, until: Until) -> Location {
        let code = &self.compiled.code;
        let pc = self.machine.open_scan().pc();
        let network = || {
            let network = code.network_at(pc).unwrap_or_default();
            self.program.networks[network].location
        };
        match until {
            Until::Block | Until::BlockOrNetwork => {
                code.block_from(pc).map_or_else(network, |block| block.location)
            }
            Until::Network | Until::Marked | Until::End => network(),
        }
    }

    /// Sets the system tags and begins.
    fn start(&mut self) {
        self.supply();
        let passed = std::mem::take(&mut self.passed);
        let machine = &mut self.machine;
        let moment = Moment {
            scan: machine.scan,
            now: machine.now,
            interval: self.options.interval.saturating_add(passed),
            faulted: machine.faulted.plants,
        };
        if let Some(plants) = &self.compiled.plants {
            plants.system.set(&mut machine.memory, moment);
        }
        let of_controller = Moment {
            scan: moment.scan - machine.memory.word(Word::POWERED_IN),
            now: moment.now - machine.memory.word(Word::POWERED_AT),
            faulted: machine.faulted.program,
            ..moment
        };
        System::CONTROLLER.set(&mut machine.memory, of_controller);
        machine.begin();
    }

    /// Nothing runs: the controller has no power, and there is no plant that goes on.
    fn is_off(&self) -> bool {
        !self.machine.memory.bit(Bit::POWER) && self.compiled.plants.is_none()
    }

    /// What the end of a scan means for the next one.
    fn end_scan(&mut self, halt: Halt) -> Stepped {
        if halt == Halt::Stopped {
            self.status = Status::Faulted;
            let fused = (!self.ran_plain).then_some(&self.compiled.fused.code);
            self.machine.move_to_plain(fused, &self.compiled.code);
            return Stepped::Stopped;
        }
        self.machine.finish(self.options.interval);
        let stops = self.compiled.code.relays.stops(&self.machine.memory);
        if halt == Halt::Ended || self.machine.ending || stops {
            self.status = Status::Ended;
        }
        Stepped::Done
    }
}
