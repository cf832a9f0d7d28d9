//! All that a scan can change, to be kept and brought back.

use super::{Change, Force, Simulation, Status};
use crate::machine::MachineState;
use std::collections::BTreeMap;

/// A simulation at one moment: tags, clock, timers and edges, ports, forces, and within a scan how far it has
/// come. Not the faults that wait to be taken.
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    pub(crate) machine: MachineState,
    pub(crate) status: Status,
    ran_plain: bool,
    open: bool,
    forces: BTreeMap<String, Force>,
    pending: Vec<Change>,
}

impl Simulation {
    /// Everything that a scan can change.
    pub fn state(&self) -> State {
        State {
            machine: self.machine.state(),
            status: self.status,
            ran_plain: self.ran_plain,
            open: self.open,
            forces: self.forces.clone(),
            pending: self.pending.clone(),
        }
    }

    /// The same into a state that is there already: it allocates nothing unless the simulation has grown.
    pub fn state_into(&self, state: &mut State) {
        self.machine.state_into(&mut state.machine);
        state.status = self.status;
        state.ran_plain = self.ran_plain;
        state.open = self.open;
        state.forces.clone_from(&self.forces);
        state.pending.clone_from(&self.pending);
    }

    /// Goes on from a state, exactly as it went on from there before. False, and nothing happens, if the state is
    /// one of another program.
    pub fn restore(&mut self, state: &State) -> bool {
        if !self.machine.restore(&state.machine) {
            return false;
        }
        self.status = state.status;
        self.ran_plain = state.ran_plain;
        self.open = state.open;
        self.forces.clone_from(&state.forces);
        self.pending.clone_from(&state.pending);
        true
    }
}
