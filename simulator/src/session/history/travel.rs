//! The way over the kept scans, back and forward again.

use super::super::delta::{Bytes, Way};
use super::History;
use crate::memory::Memory;
use crate::simulation::Simulation;

impl History {
    /// Goes back up to this many scans; how many it were. What was given since the last scan (`changed`) is kept for
    /// when the simulation comes forward again.
    pub(in crate::session) fn back(
        &mut self,
        simulation: &mut Simulation,
        scans: usize,
        changed: bool,
    ) -> usize {
        let scans = scans.min(self.here);
        if scans == 0 {
            return 0;
        }
        if changed {
            let given = self.take_up(simulation);
            self.take_back(&given);
            self.waiting = given;
        }
        for _ in 0..scans {
            self.here -= 1;
            let entry = &self.entries[self.here];
            let (given, ran) = (entry.given as usize, entry.ran as usize);
            self.serial.back(entry.sent);
            if let Some(change) = &entry.forces {
                self.forces.clone_from(&change.0);
            }
            self.bytes_here -= ran;
            self.go(self.bytes_here, ran, Way::Back);
            self.bytes_here -= given;
            self.go(self.bytes_here, given, Way::Back);
        }
        self.restore(simulation);
        scans
    }

    /// Goes forward one kept scan. None if there is none; else whether something was given after it, which is
    /// given again now.
    pub(in crate::session) fn forward(&mut self, simulation: &mut Simulation) -> Option<bool> {
        (self.forward_by(simulation, 1) == 1).then(|| self.give_what_waits(simulation))
    }

    /// Goes forward up to this many kept scans; how many it were. What was given after the newest one still waits.
    pub(in crate::session) fn forward_by(&mut self, simulation: &mut Simulation, scans: usize) -> usize {
        let scans = scans.min(self.ahead());
        for _ in 0..scans {
            let entry = &self.entries[self.here];
            let (given, ran) = (entry.given as usize, entry.ran as usize);
            self.serial.forward(entry.sent);
            if let Some(change) = &entry.forces {
                self.forces.clone_from(&change.1);
            }
            self.here += 1;
            self.go(self.bytes_here, given, Way::Forward);
            self.bytes_here += given;
            self.go(self.bytes_here, ran, Way::Forward);
            self.bytes_here += ran;
        }
        if scans > 0 {
            self.restore(simulation);
        }
        scans
    }

    /// Looks at the memory of tags after each of the scans ahead, without moving the history.
    pub(in crate::session) fn look_ahead(&self, mut look: impl FnMut(&Memory)) {
        let mut banks = self.banks.clone();
        let (mut start, mut bytes) = (self.bytes_here, Vec::new());
        for entry in self.entries.iter().skip(self.here) {
            let end = start + entry.bytes();
            bytes.clear();
            bytes.extend(self.bytes.range(start..end));
            let (given, ran) = bytes.split_at(entry.given as usize);
            for part in [given, ran] {
                if !part.is_empty() {
                    banks.go_over_tags(&mut Bytes(part), Way::Forward);
                }
            }
            look(&banks.memory);
            start = end;
        }
    }

    /// Applies again what was given before the scan ahead.
    pub(in crate::session) fn give_next(&mut self, simulation: &mut Simulation) {
        let Some(entry) = self.entries.get(self.here) else {
            return;
        };
        if let Some(change) = &entry.forces {
            simulation.restore_forces(&change.1);
        }
        let given = entry.given as usize;
        self.go(self.bytes_here, given, Way::Forward);
        self.banks.restore(&mut simulation.machine);
        self.go(self.bytes_here, given, Way::Back);
    }

    /// What was given after the newest scan is set aside, for when the simulation comes forward again: it leaves this
    /// history.
    pub(in crate::session) fn set_aside(&mut self, simulation: &Simulation) {
        let given = self.take_up(simulation);
        self.take_back(&given);
        self.waiting = given;
    }

    /// Applies what was set aside, if the simulation is after the newest scan again. Whether that is anything.
    pub(in crate::session) fn give_what_waits(&mut self, simulation: &mut Simulation) -> bool {
        if self.ahead() > 0 || self.waiting.is_nothing() {
            return false;
        }
        let given = std::mem::take(&mut self.waiting);
        if let Some(change) = &given.forces {
            simulation.restore_forces(&change.1);
        }
        let mut then = self.banks.clone();
        then.go(Bytes(&given.bytes), Way::Forward);
        then.restore(&mut simulation.machine);
        true
    }

    /// Moves the banks over a part of the bytes.
    fn go(&mut self, start: usize, len: usize, way: Way) {
        if len == 0 {
            return;
        }
        self.scratch.clear();
        self.scratch.extend(self.bytes.range(start..start + len));
        self.banks.go(Bytes(&self.scratch), way);
    }

    /// Makes the simulation be here.
    pub(in crate::session) fn restore(&self, simulation: &mut Simulation) {
        simulation.restore_forces(&self.forces);
        self.banks.restore(&mut simulation.machine);
        self.moment().restore(simulation);
    }
}
