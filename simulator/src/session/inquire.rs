//! Why a tag holds what it holds, asked of a session.

use super::Session;
use super::why::{Inquiry, Why, Writers};
use crate::tags::Point;

impl Session {
    /// Why a point holds what it holds now.
    pub fn why(&mut self, point: &Point) -> Why {
        self.inquire(point).0
    }

    /// The same, and how many kept scans were gone back over for it.
    pub(super) fn inquire(&mut self, point: &Point) -> (Why, usize) {
        let state = self.simulation.state();
        let faults = self.simulation.machine.faults.len();
        // The scans that are run again here came to their end before.
        let brake = self.simulation.machine.brake.take();
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
        self.simulation.machine.brake = brake;
        answer
    }
}
