//! Program flow (LANGUAGE §5.5): jumps, calls, loops, rails.

use super::{Halt, Machine};
use crate::code::{Code, Instr, NOTHING_SAVED};
use crate::fault::Trouble;
use crate::timers::Clock;
use crate::work::CALL_DEPTH;

/// Where a scan goes on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Flow {
    /// After this instruction.
    Next,
    /// At another instruction.
    Go(u32),
    /// Nowhere.
    Halt(Halt),
}

/// A loop that is being run: code from `body` up to `after`.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Loop {
    body: u32,
    after: u32,
    /// Turns that follow this one; none runs if both ends are 0.
    left: i64,
    /// The number of this turn, from 1.
    turn: i64,
}

impl Loop {
    fn holds(self, pc: u32) -> bool {
        (self.body..self.after).contains(&pc)
    }
}

/// What a call, or the body of a user-defined block, has of its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Frame {
    /// Where the caller goes on.
    pub(super) back: u32,
    rail: bool,
    turning: Loop,
    /// So many loops run around that one.
    around: usize,
    /// Turns that a `<FOR>` has noted for the end of its network.
    noted: i64,
    saved: u32,
}

impl Frame {
    pub(super) fn new(back: u32, saved: u32) -> Frame {
        Frame {
            back,
            rail: true,
            turning: Loop::default(),
            around: 0,
            noted: 0,
            saved,
        }
    }

    /// Ends the innermost loop that runs. `outer` are those around the innermost ones of all frames.
    fn end_loop(&mut self, outer: &mut Vec<Loop>) {
        self.turning = match self.around.checked_sub(1) {
            Some(around) => {
                self.around = around;
                outer.pop().unwrap_or_default()
            }
            None => Loop::default(),
        };
    }
}

impl Machine {
    /// Executes an instruction that concerns where the scan goes on, or what it has open. Those that ask for EN come
    /// here with EN high only.
    pub(super) fn flow(&mut self, code: &Code, instr: &Instr, pc: usize, clock: Clock) -> Flow {
        let frame = &mut self.position.frame;
        match *instr {
            Instr::Network { network } => {
                self.reached[network as usize] = clock.scan;
                self.left_at[network as usize] = u32::MAX;
            }
            Instr::Rail { out } => self.memory.set_bit(out, frame.rail),
            Instr::Mcr { en } => frame.rail = self.memory.bit(en),
            Instr::Left { step, network } => self.left_at[network as usize] = step,
            Instr::Jump {
                to, step, network, ..
            } => {
                self.left_at[network as usize] = step;
                frame.noted = 0;
                while frame.turning != Loop::default() && !frame.turning.holds(to) {
                    frame.end_loop(&mut self.outer_loops);
                }
                return Flow::Go(to);
            }
            Instr::Call { to, saved, .. } => {
                if self.position.calls == CALL_DEPTH {
                    self.record(Trouble::CallDepth, code.block_at(pc as u32), clock.scan);
                    return Flow::Halt(Halt::Stopped);
                }
                self.position.calls += 1;
                if saved != NOTHING_SAVED {
                    let powers = &code.saved[saved as usize];
                    let bits = &self.memory.bits;
                    self.saved
                        .extend(powers.iter().map(|power| bits[power.0 as usize]));
                }
                let callee = Frame::new(pc as u32 + 1, saved);
                self.frames.push(std::mem::replace(frame, callee));
                return Flow::Go(to);
            }
            Instr::Return { step, network, .. } => {
                self.left_at[network as usize] = step;
                return self.go_back(code);
            }
            Instr::Finish => return self.go_back(code),
            Instr::End { step, network, .. } => {
                self.left_at[network as usize] = step;
                return Flow::Halt(Halt::Ended);
            }
            Instr::For { en, turns } => {
                frame.noted = if self.memory.bit(en) {
                    self.memory.word(turns)
                } else {
                    0
                };
            }
            Instr::Enter { body, after } => {
                let turns = std::mem::take(&mut frame.noted);
                if turns <= 0 {
                    return Flow::Go(after);
                }
                if frame.turning != Loop::default() {
                    self.outer_loops.push(frame.turning);
                    frame.around += 1;
                }
                frame.turning = Loop {
                    body,
                    after,
                    left: turns - 1,
                    turn: 1,
                };
            }
            Instr::Turn { to, width } => {
                self.memory.words[to.0 as usize] = width.wrap(frame.turning.turn);
            }
            // Its own loop does not run where a jump came into it.
            Instr::Again { body } if frame.turning.body != body => {}
            Instr::Again { body } => {
                if frame.turning.left > 0 {
                    frame.turning.left -= 1;
                    frame.turning.turn += 1;
                    frame.noted = 0;
                    return Flow::Go(body);
                }
                frame.end_loop(&mut self.outer_loops);
            }
            Instr::EnterBody => {
                let body = Frame::new(0, NOTHING_SAVED);
                self.frames.push(std::mem::replace(frame, body));
            }
            Instr::LeaveBody => {
                if let Some(outer) = self.frames.pop() {
                    let around = frame.around;
                    *frame = outer;
                    self.outer_loops.truncate(self.outer_loops.len() - around);
                }
            }
            _ => debug_assert!(false, "{instr:?} runs straight through"),
        }
        Flow::Next
    }

    /// To the caller; the main program has none and is done.
    fn go_back(&mut self, code: &Code) -> Flow {
        let Some(caller) = self.frames.pop() else {
            return Flow::Halt(Halt::Done);
        };
        self.position.calls -= 1;
        let callee = std::mem::replace(&mut self.position.frame, caller);
        self.outer_loops.truncate(self.outer_loops.len() - callee.around);
        self.come_back(code, callee);
        Flow::Go(callee.back)
    }

    /// Restores the powers of a caller.
    fn come_back(&mut self, code: &Code, frame: Frame) {
        if frame.saved != NOTHING_SAVED {
            let powers = &code.saved[frame.saved as usize];
            let start = self.saved.len() - powers.len();
            for (power, value) in powers.iter().zip(self.saved.drain(start..)) {
                self.memory.bits[power.0 as usize] = value;
            }
        }
    }
}
