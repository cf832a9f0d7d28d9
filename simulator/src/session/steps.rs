//! One scan in parts: whole, by network, by block.

use super::{Session, collect_faults};
use crate::fault::Trouble;
use crate::machine::Until;
use crate::simulation::{Status, Stepped};

impl Session {
    /// Runs one scan, or the rest of the one that is open, or goes forward over one that was stepped back from and is
    /// still kept. Breakpoints are passed by. False, and nothing happens, if the program has ended or a fault
    /// stopped it; false also if a fault stops it now.
    pub fn scan(&mut self) -> bool {
        if self.simulation.is_open() {
            return self.go_on(Until::End) == Stepped::Done;
        }
        if let Some(given) = self.history.forward(&mut self.simulation) {
            self.changed = given;
            self.go_to_later();
            return self.simulation.status() != Status::Faulted;
        }
        if self.simulation.status() != Status::Ready {
            return false;
        }
        self.begin();
        let ran = self.simulation.scan();
        if self.was_cancelled() {
            self.give_up_scan();
        } else {
            self.finish();
        }
        ran
    }

    /// Goes on up to the next block, into functions and the bodies of user-defined blocks too; begins a scan if none is
    /// open. What is set or forced within a scan waits for its end.
    pub fn step_block(&mut self) -> Stepped {
        self.go_on(Until::Block)
    }

    /// Goes on up to the next network, likewise.
    pub fn step_network(&mut self) -> Stepped {
        self.go_on(Until::Network)
    }

    /// Whether a scan was begun and is not finished.
    pub fn is_open(&self) -> bool {
        self.simulation.is_open()
    }

    /// Goes on in the scan that is open, or begins one.
    pub(super) fn go_on(&mut self, until: Until) -> Stepped {
        if !self.open_scan() {
            return Stepped::Stopped;
        }
        self.unseen_network = false;
        // It waits for the end of the scan as the history has it, not for that of the machine.
        let waiting = std::mem::take(&mut self.simulation.pending);
        let stepped = self.simulation.step(until);
        if self.simulation.is_open() {
            if !self.repeats {
                collect_faults(&mut self.simulation, &mut self.faults);
            }
            self.simulation.pending = waiting;
            return stepped;
        }
        if self.was_cancelled() {
            self.give_up_scan();
            return stepped;
        }
        if self.repeats {
            // It was run before: exactly what was then, and the faults are known.
            self.repeats = false;
            self.simulation.machine.faults.clear();
            self.simulation.machine.memory.sent.clear();
            self.changed = self.history.forward(&mut self.simulation).unwrap_or(false);
            self.go_to_later();
        } else {
            self.finish();
        }
        if !waiting.is_empty() {
            self.simulation.pending = waiting;
            self.simulation.take_pending();
            self.goes_another_way();
        }
        stepped
    }

    /// Begins a scan in parts, if none is open. One that was stepped back from is run again with what was given then.
    pub(super) fn open_scan(&mut self) -> bool {
        if self.simulation.is_open() {
            return true;
        }
        if self.simulation.status() != Status::Ready {
            return false;
        }
        if self.history.ahead() > 0 {
            self.history.give_next(&mut self.simulation);
            self.repeats = true;
        } else {
            self.begin();
        }
        self.simulation.begin_scan()
    }

    /// Abandons the scan that is open: the simulation is at its start again, with what was given for it. What was
    /// given since is undone.
    pub(super) fn give_up_scan(&mut self) {
        self.simulation.open = false;
        self.simulation.pending.clear();
        self.simulation.machine.faults.clear();
        self.simulation.machine.memory.sent.clear();
        if self.repeats {
            self.repeats = false;
            self.history.restore(&mut self.simulation);
        } else {
            self.changed = self.history.give_up(&mut self.simulation);
            self.forget_faults_ahead();
        }
    }

    /// Whether the scan that was run was cancelled, and can be taken back.
    fn was_cancelled(&self) -> bool {
        let last = self.simulation.machine.faults.last();
        last.is_some_and(|fault| fault.trouble == Trouble::Cancelled) && self.history.is_on()
    }

    fn begin(&mut self) {
        self.note_given();
        self.history.begin(&self.simulation, self.changed);
        self.changed = false;
    }

    fn finish(&mut self) {
        collect_faults(&mut self.simulation, &mut self.faults);
        self.history.finish(&mut self.simulation);
        self.forget_oldest();
    }
}
