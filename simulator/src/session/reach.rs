//! Earlier moments, without going there: to run a scan again, or to see when a value came to be.

use super::banks::Banks;
use super::delta::{Bytes, Way, move_cells, move_texts};
use super::history::History;
use super::why::Change;
use crate::memory::Memory;
use crate::simulation::Simulation;

/// A scan.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Reach {
    /// The one that is open.
    Open,
    /// The last of so many kept ones.
    Behind(usize),
}

impl History {
    /// Makes a simulation stand at the start of a scan, with what was given for it. False if that is not kept. The
    /// history stays where it is.
    pub(super) fn put_at_start(&mut self, reach: Reach, simulation: &mut Simulation) -> bool {
        let entry = match reach {
            Reach::Open if self.ahead() > 0 => {
                self.restore(simulation);
                self.give_next(simulation);
                return true;
            }
            Reach::Open => {
                self.restore(simulation);
                return true;
            }
            Reach::Behind(0) => return false,
            Reach::Behind(entries) => entries - 1,
        };
        if entry >= self.here {
            return false;
        }
        let mut banks: Banks = self.banks.clone();
        let mut forces = self.forces.clone();
        self.undo_given_of_open(|bytes| banks.go(bytes, Way::Back));
        if let Some(change) = &self.given.forces {
            forces.clone_from(&change.0);
        }
        let mut number = self.here;
        self.back_from_here(|ran, given| {
            number -= 1;
            banks.go(ran, Way::Back);
            if number == entry {
                return false;
            }
            if !given.is_empty() {
                banks.go(given, Way::Back);
            }
            true
        });
        let later = self.entries.range(entry + 1..self.here);
        for later in later.rev() {
            if let Some(change) = &later.forces {
                forces.clone_from(&change.0);
            }
        }
        simulation.restore_forces(&forces);
        banks.restore(&mut simulation.machine);
        self.moment_before(entry).restore(simulation);
        true
    }

    /// The number of an entry's scan and its clock.
    pub(super) fn clock_before(&self, entry: usize) -> (u64, i64) {
        let moment = self.moment_before(entry);
        (moment.scan as u64, moment.now)
    }

    /// In which scan something came to be that is so at a moment in a scan, or at its end (`whole`).
    pub(super) fn last_change(&self, reach: Reach, whole: bool, is_so: impl Fn(&Memory) -> bool) -> Change {
        if !self.is_on() {
            return Change::NotKept;
        }
        let mut memory = Memory {
            bits: self.banks.bits.clone(),
            words: self.banks.words.clone(),
            texts: self.banks.texts.clone(),
            ..Memory::default()
        };
        let undo = |memory: &mut Memory, mut bytes: Bytes<'_>| {
            if !bytes.is_empty() {
                move_cells(&mut bytes, &mut memory.bits);
                move_cells(&mut bytes, &mut memory.words);
                move_texts(&mut bytes, &mut memory.texts, Way::Back);
            }
        };
        if reach == Reach::Open && !is_so(&memory) {
            return Change::In(self.here);
        }
        self.undo_given_of_open(|bytes| undo(&mut memory, bytes));
        if (reach == Reach::Open || (whole && reach == Reach::Behind(self.here))) && !is_so(&memory) {
            return Change::Given(self.here);
        }
        let first = match reach {
            Reach::Open => self.here,
            Reach::Behind(entries) => entries,
        };
        let mut change = if self.base.scan == 0 {
            Change::Never
        } else {
            Change::NotKept
        };
        let mut number = self.here;
        self.back_from_here(|ran, given| {
            number -= 1;
            undo(&mut memory, ran);
            if number < first && !is_so(&memory) {
                change = Change::In(number);
                return false;
            }
            undo(&mut memory, given);
            if number < first && !is_so(&memory) {
                change = Change::Given(number);
                return false;
            }
            true
        });
        change
    }

    /// What was given for a scan that is open is already in the banks.
    fn undo_given_of_open(&self, mut undo: impl FnMut(Bytes<'_>)) {
        if !self.given.bytes.is_empty() {
            undo(Bytes(&self.given.bytes));
        }
    }
}
