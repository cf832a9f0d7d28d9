//! Why a tag holds what it holds, asked of a session.

use super::Session;
use super::why::{Inquiry, Why, Writers};
use crate::tags::Point;
use ladder_analysis::program::Location;

impl Session {
    /// Why a point holds what it holds now.
    pub fn why(&mut self, point: &Point) -> Why {
        self.inquire(point).0
    }

    /// The blocks outside of bodies that may write a point, in the order of the program.
    pub fn writers_of(&self, point: &Point) -> Vec<Location> {
        let writers = self.writers.get_or_init(|| Writers::of(&self.simulation));
        let program = self.simulation.program();
        let blocks = writers.of_point(&self.simulation, point).into_iter();
        blocks
            .map(|at| program.networks[at.network].blocks[at.block].location)
            .collect()
    }

    /// Why a point holds what it holds, and how many kept scans were gone back over for it.
    pub(super) fn inquire(&mut self, point: &Point) -> (Why, usize) {
        let state = self.simulation.state();
        let faults = self.simulation.machine.faults.len();
        // The scans that are run again here came to their end before.
        let cancel = self.simulation.machine.cancel.take();
        let Session {
            simulation,
            history,
            writers,
            ..
        } = self;
        let writers = writers.get_or_init(|| Writers::of(simulation));
        let answer = Inquiry::answer(simulation, history, writers, point);
        self.simulation.restore(&state);
        self.simulation.machine.faults.truncate(faults);
        self.simulation.machine.cancel = cancel;
        answer
    }
}
