//! Where a scan is that is not finished, and where it is to halt.

use super::Machine;
use super::flow::Frame;
use crate::code::{Code, NOTHING_SAVED, stop};

/// Where a scan goes on. A scan that runs through keeps this in the machine's locals.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Position {
    /// The next instruction.
    pub(super) pc: usize,
    pub(super) frame: Frame,
    pub(super) calls: usize,
    /// Blocks that may still be evaluated.
    pub(super) budget: u64,
    /// The kinds of stop that were made in front of the next instruction.
    pub(super) passed: u8,
}

impl Position {
    /// Before the first instruction.
    pub(super) fn start(watchdog: u64) -> Position {
        Position {
            pc: 0,
            frame: Frame::new(0, NOTHING_SAVED),
            calls: 0,
            budget: watchdog,
            passed: 0,
        }
    }

    /// Blocks have been evaluated.
    pub(super) fn pay(&mut self, blocks: u64) {
        self.budget = self.budget.saturating_sub(blocks);
    }
}

/// How far a scan runs on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Until {
    /// To its end.
    End,
    /// In front of the next block.
    Block,
    /// In front of the next network.
    Network,
    /// In front of whichever of them comes first.
    BlockOrNetwork,
    /// In front of the next instruction that is marked.
    Marked,
}

impl Until {
    /// The kinds of stop at which it halts.
    const fn kinds(self) -> u8 {
        match self {
            Until::End => 0,
            Until::Block => stop::BLOCK,
            Until::Network => stop::NETWORK,
            Until::BlockOrNetwork => stop::BLOCK | stop::NETWORK,
            Until::Marked => stop::MARK,
        }
    }

    /// What comes after a stop of this kind: a network begins before its first block does.
    pub(super) const fn passed(self) -> u8 {
        match self {
            Until::End => 0,
            Until::Block | Until::BlockOrNetwork => stop::BLOCK | stop::NETWORK,
            Until::Network => stop::NETWORK,
            Until::Marked => stop::MARK,
        }
    }

    /// Whether to halt in front of an instruction.
    #[inline]
    pub(super) fn halts(self, code: &Code, pc: usize, passed: u8) -> bool {
        let kinds = self.kinds();
        kinds != 0 && code.stops[pc] & kinds & !passed != 0
    }
}

/// What a scan that halted has open: instructions that all lie in different activations, the innermost first. What
/// is before them in their networks has run.
#[derive(Debug, Clone, Copy)]
pub(crate) struct OpenScan<'m> {
    machine: &'m Machine,
}

impl OpenScan<'_> {
    /// The instruction that runs next.
    pub(crate) fn pc(self) -> u32 {
        self.machine.position.pc as u32
    }

    /// Blocks that may still be evaluated.
    pub(crate) fn budget(self) -> u64 {
        self.machine.position.budget
    }

    /// The instruction that runs next, then those through which each routine that is open was called, from the inside
    /// out. The bodies of user-defined blocks are none of their own.
    pub(crate) fn activations(self) -> impl Iterator<Item = u32> {
        let frames = std::iter::once(&self.machine.position.frame).chain(self.machine.frames.iter().rev());
        let calls = frames.filter(|frame| frame.back > 0).map(|frame| frame.back - 1);
        std::iter::once(self.pc()).chain(calls)
    }

    /// How far the main program has come.
    pub(crate) fn main(self) -> u32 {
        let mut frames =
            std::iter::once(&self.machine.position.frame).chain(self.machine.frames.iter().rev());
        // The outermost call.
        let call = frames.rfind(|frame| frame.back > 0);
        call.map_or(self.pc(), |frame| frame.back - 1)
    }

    /// The instruction up to which a stretch of code has run, if it is open.
    pub(crate) fn within(self, start: u32, end: u32) -> Option<u32> {
        let frames = self.machine.frames.iter().rev();
        let callers = std::iter::once(&self.machine.position.frame).chain(frames);
        // A caller goes on after its call, whose power is not there yet. The main program and bodies have no caller.
        let calls = callers.filter(|frame| frame.back > 0).map(|frame| frame.back - 1);
        std::iter::once(self.pc())
            .chain(calls)
            .find(|pc| (start..end).contains(pc))
    }
}

impl Machine {
    /// Counts the stops in front of the next instruction as made.
    pub(crate) fn pass_stops(&mut self) {
        self.position.passed = stop::BLOCK | stop::NETWORK;
    }

    /// Moves a scan that a fault has stopped to the same place in plain code, if it ran fused code.
    pub(crate) fn move_to_plain(&mut self, ran: Option<&Code>, plain: &Code) {
        if let Some(fault) = self.faults.last() {
            self.position.pc = plain.blocks[fault.block as usize].start as usize;
        }
        let Some(fused) = ran else { return };
        for frame in std::iter::once(&mut self.position.frame).chain(&mut self.frames) {
            if frame.back > 0 {
                let call = fused.block_at(frame.back - 1);
                frame.back = plain.blocks[call as usize].end;
            }
        }
    }

    /// What is open in the scan that was begun and not finished.
    pub(crate) fn open_scan(&self) -> OpenScan<'_> {
        OpenScan { machine: self }
    }
}
