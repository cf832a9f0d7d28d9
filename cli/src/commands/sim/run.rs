//! A run: scan after scan, with what is given to the program and what it complains about.

use super::inputs::Inputs;
use crate::findings::Source;
use crate::terminal;
use ladder_simulator::{Fault, Simulation};

/// A program on its way through a number of scans.
pub(super) struct Run<'s> {
    pub(super) simulation: Simulation,
    pub(super) inputs: Inputs,
    pub(super) source: &'s Source,
    /// How many scans to run.
    pub(super) scans: u64,
}

impl Run<'_> {
    /// Runs the next scan. False if all have been run, or if the program did not come to the end of this one.
    pub(super) fn scan(&mut self) -> bool {
        let scan = self.simulation.scans();
        if scan >= self.scans {
            return false;
        }
        self.inputs.give(scan, &mut self.simulation);
        let ran = self.simulation.scan();
        for fault in self.simulation.take_faults() {
            self.report(&fault);
        }
        ran
    }

    /// Faults go to stderr, each on a line of its own, in the form that editors and terminals find places in.
    fn report(&self, fault: &Fault) {
        let place = super::place(self.source, fault.location);
        terminal::plain(&format_args!(
            "{place}: fault in scan {}: {}",
            fault.scan, fault.message
        ));
    }
}
