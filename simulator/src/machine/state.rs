//! What of a machine is kept to be brought back.

use super::flow::{Frame, Loop};
use super::position::Position;
use super::{Faulted, Machine};
use crate::memory::Memory;

/// A machine at one moment, but for its faults.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct MachineState {
    pub(crate) memory: Memory,
    pub(crate) now: i64,
    pub(crate) scan: i64,
    pub(crate) faulted: Faulted,
    pub(crate) reached: Vec<i64>,
    pub(crate) left_at: Vec<u32>,
    pub(crate) rows: Vec<u8>,
    fault_now: Faulted,
    ending: bool,
    position: Position,
    frames: Vec<Frame>,
    saved: Vec<u8>,
    outer_loops: Vec<Loop>,
}

impl Machine {
    pub(crate) fn state(&self) -> MachineState {
        MachineState {
            memory: self.memory.clone(),
            now: self.now,
            scan: self.scan,
            faulted: self.faulted,
            reached: self.reached.clone(),
            left_at: self.left_at.clone(),
            rows: self.rows.clone(),
            fault_now: self.fault_now,
            ending: self.ending,
            position: self.position,
            frames: self.frames.clone(),
            saved: self.saved.clone(),
            outer_loops: self.outer_loops.clone(),
        }
    }

    pub(crate) fn state_into(&self, state: &mut MachineState) {
        state.memory.take_from(&self.memory);
        (state.now, state.scan) = (self.now, self.scan);
        (state.faulted, state.fault_now, state.ending) = (self.faulted, self.fault_now, self.ending);
        state.reached.clone_from(&self.reached);
        state.left_at.clone_from(&self.left_at);
        state.rows.clone_from(&self.rows);
        state.position = self.position;
        state.frames.clone_from(&self.frames);
        state.saved.clone_from(&self.saved);
        state.outer_loops.clone_from(&self.outer_loops);
    }

    /// False, and nothing happens, if the state does not fit the machine's program. The room that scans need is kept.
    pub(crate) fn restore(&mut self, state: &MachineState) -> bool {
        let fits = state.memory.has_room_of(&self.memory)
            && state.reached.len() == self.reached.len()
            && state.rows.len() == self.rows.len();
        if !fits {
            return false;
        }
        self.memory.take_from(&state.memory);
        (self.now, self.scan) = (state.now, state.scan);
        (self.faulted, self.fault_now, self.ending) = (state.faulted, state.fault_now, state.ending);
        self.reached.clone_from(&state.reached);
        self.left_at.clone_from(&state.left_at);
        self.rows.clone_from(&state.rows);
        self.position = state.position;
        self.frames.clone_from(&state.frames);
        self.saved.clone_from(&state.saved);
        self.outer_loops.clone_from(&state.outer_loops);
        true
    }
}
