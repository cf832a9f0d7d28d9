//! Going back over the kept scans without moving the history: to run a scan again, or to see when a value came to be.

use super::banks::Banks;
use super::delta::{Bytes, Way};
use super::history::{Forces, History};
use super::touched::{Cells, SPAN};
use crate::simulation::Simulation;
use crate::tags::Point;
use ladder_analysis::values::value::Value;
use std::ops::Range;

/// A moment of the past. It is at the start of a scan, with what was given for it; from there
/// [`Rewind::undo_given`] leads to the end of the scan before, and [`Rewind::undo_scan`] to that one's start.
#[derive(Debug, Clone)]
pub(super) struct Rewind<'h> {
    history: &'h History,
    banks: Banks,
    forces: Forces,
    /// The scan that it is at the start of: an entry of the history, or the one after the last, which is open or
    /// has not begun.
    entry: usize,
    /// The end of the bytes of the entries before it.
    end: usize,
    /// The bytes of this entry, and how many of them are what was given.
    bytes: Vec<u8>,
    given: usize,
    /// The end of the scan before the present one.
    before_present: Option<(Banks, Forces)>,
}

impl<'h> Rewind<'h> {
    /// Is at the start of the open scan, or of the next one with what was given for it so far.
    pub(super) fn new(history: &'h History, simulation: &Simulation) -> Rewind<'h> {
        let then = (history.banks.clone(), history.forces.clone());
        let (start, before) = if !simulation.is_open() {
            let now = (Banks::of(&simulation.machine), simulation.forces.clone());
            (now, then)
        } else if history.ahead() > 0 {
            let mut start = then.clone();
            let given = history.given_ahead();
            if !given.is_empty() {
                start.0.go(Bytes(&given), Way::Forward);
            }
            if let Some(change) = &history.entries[history.here].forces {
                start.1.clone_from(&change.1);
            }
            (start, then)
        } else {
            let mut before = then.clone();
            if !history.given.bytes.is_empty() {
                before.0.go(Bytes(&history.given.bytes), Way::Back);
            }
            if let Some(change) = &history.given.forces {
                before.1.clone_from(&change.0);
            }
            (then, before)
        };
        Rewind {
            history,
            banks: start.0,
            forces: start.1,
            entry: history.here,
            end: history.bytes_here(),
            bytes: Vec::new(),
            given: 0,
            before_present: Some(before),
        }
    }

    /// The scan that it is at the start of, or before.
    pub(super) fn entry(&self) -> usize {
        self.entry
    }

    /// Goes to the end of the scan before.
    pub(super) fn undo_given(&mut self) {
        if let Some((banks, forces)) = self.before_present.take() {
            (self.banks, self.forces) = (banks, forces);
            return;
        }
        if self.given > 0 {
            self.banks.go(Bytes(&self.bytes[..self.given]), Way::Back);
        }
        if let Some(change) = &self.history.entries[self.entry].forces {
            self.forces.clone_from(&change.0);
        }
    }

    /// Goes to the start of that scan. False if it is not kept.
    pub(super) fn undo_scan(&mut self) -> bool {
        if self.entry == 0 {
            return false;
        }
        self.entry -= 1;
        self.end = self.history.bytes_before(self.end, self.entry, &mut self.bytes);
        self.given = self.history.entries[self.entry].given as usize;
        self.banks.go(Bytes(&self.bytes[self.given..]), Way::Back);
        true
    }

    /// From the end of the scan before, after [`Rewind::undo_given`]: goes back over whole spans of scans that nothing is
    /// looked for in, to the end of the scan before those. How many spans it were.
    pub(super) fn undo_spans(&mut self, passes: impl Fn(&Cells, Range<usize>) -> bool) -> usize {
        let mut count = 0;
        while let Some(span) = self.history.span_before(self.entry) {
            let first = self.entry - SPAN as usize;
            if !passes(&span.touched, first..self.entry) {
                break;
            }
            self.banks.go(Bytes(&span.bytes), Way::Back);
            if let Some(forces) = &span.forces {
                self.forces.clone_from(forces);
            }
            self.entry = first;
            self.end -= span.of_scans;
            count += 1;
        }
        count
    }

    /// What a point holds here.
    pub(super) fn value(&self, point: &Point) -> Value {
        point.read(&self.banks.memory)
    }

    /// Makes a simulation be here, at the start of the scan.
    pub(super) fn restore(&self, simulation: &mut Simulation) {
        simulation.restore_forces(&self.forces);
        self.banks.restore(&mut simulation.machine);
        self.history.moment_before(self.entry).restore(simulation);
    }
}
