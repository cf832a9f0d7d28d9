//! What was given from outside, scan by scan, since the program began: for as long as the session lasts, since a user
//! presses much more seldom than scans run.

use super::Session;
use crate::memory::{Bit, Memory};
use crate::simulation::Simulation;
use crate::tags::{Point, power};
use ladder_analysis::program::Program;
use ladder_analysis::values::value::Value;
use std::collections::HashMap;
use std::sync::Arc;

/// This many values are kept at most.
pub(crate) const MOST_GIVEN: usize = 100_000;

/// A value that was given.
#[derive(Debug)]
struct One {
    /// Before this scan.
    scan: u64,
    /// While the program was changed, before anything ran with the new one.
    at_change: bool,
    /// Among the points that anything was given to.
    point: usize,
    /// None: it is given back to the plant that drives it.
    value: Option<Value>,
}

/// Why it is not known what was given.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum NotKnown {
    /// No scans are kept, so nothing is held against anything.
    NoHistory,
    /// The session began after the first scan.
    LateStart,
    /// More than [`MOST_GIVEN`] values.
    TooMany,
}

/// All that was given since the start.
#[derive(Debug)]
pub(crate) struct AllGiven {
    points: Vec<Point>,
    /// The newest point of each name.
    by_name: HashMap<String, usize>,
    /// The oldest first.
    values: Vec<One>,
    /// Of points that a plant drives, which of the values are theirs.
    held: HashMap<usize, Vec<usize>>,
    not_known: Option<NotKnown>,
}

impl AllGiven {
    /// What a program holds before its first scan that is not its initial value was given to it.
    pub(super) fn at_start(simulation: &Simulation, has_history: bool) -> AllGiven {
        let mut all = AllGiven {
            points: Vec::new(),
            by_name: HashMap::new(),
            values: Vec::new(),
            held: HashMap::new(),
            not_known: match () {
                () if !has_history => Some(NotKnown::NoHistory),
                () if simulation.machine.scan != 0 => Some(NotKnown::LateStart),
                () => None,
            },
        };
        all.take(simulation, true, |point| {
            Some((point, &simulation.compiled.initial))
        });
        all
    }

    /// Before which scans what was given to which points, the oldest first. No value: the point is given back to the plant.
    pub(crate) fn values(&self) -> impl Iterator<Item = (u64, &Point, Option<&Value>)> {
        self.values
            .iter()
            .map(|one| (one.scan, &self.points[one.point], one.value.as_ref()))
    }

    /// A scan begins: what is known of it and of later ones happened on a way that is not gone any more.
    fn forget_from(&mut self, scan: u64) {
        let is_gone = |last: &One| last.scan > scan || (last.scan == scan && !last.at_change);
        while let Some(last) = self.values.pop_if(|last| is_gone(last)) {
            let own = self.held.get_mut(&last.point);
            own.and_then(|values| values.pop_if(|value| *value == self.values.len()));
        }
    }

    /// Takes what a simulation holds before its next scan that differs from what was there before: what each point was, and
    /// where, if it is known.
    fn take<'a>(
        &mut self,
        simulation: &'a Simulation,
        at_change: bool,
        before: impl Fn(&'a Point) -> Option<(&'a Point, &'a Memory)>,
    ) {
        let memory = &simulation.machine.memory;
        for point in simulation.points() {
            if before(point).is_none_or(|before| point.is_as(memory, before)) || simulation.is_driven(point) {
                continue;
            }
            self.push(simulation, at_change, point, Some(point.read(memory)));
        }
    }

    /// Takes the supply of power, and what holds against the plants, or does not any more: its value need not differ from theirs.
    fn take_held(&mut self, simulation: &Simulation) {
        let memory = &simulation.machine.memory;
        let has_power = memory.bit(Bit::POWER);
        if has_power != memory.bit(Bit::HAD_POWER) {
            self.push(simulation, false, &power(), Some(Value::Bool(has_power)));
        }
        if simulation.program().plants.is_empty() {
            return;
        }
        let points = simulation.points().iter();
        for point in points.filter(|point| simulation.is_driven(point)) {
            let held = simulation.is_forced(point).then(|| point.read(memory));
            let index = self.index_of(point);
            let last = self.held.get(&index).and_then(|values| values.last());
            let last = last.and_then(|last| self.values[*last].value.as_ref());
            if last != held.as_ref() && self.not_known.is_none() {
                self.held.entry(index).or_default().push(self.values.len());
                self.push(simulation, false, point, held);
            }
        }
    }

    fn push(&mut self, simulation: &Simulation, at_change: bool, point: &Point, value: Option<Value>) {
        if self.values.len() == MOST_GIVEN {
            self.not_known = Some(NotKnown::TooMany);
            self.values = Vec::new();
            self.held = HashMap::new();
        }
        if self.not_known.is_some() {
            return;
        }
        let index = self.index_of(point);
        self.values.push(One {
            scan: simulation.machine.scan as u64,
            at_change,
            point: index,
            value,
        });
    }

    fn index_of(&mut self, point: &Point) -> usize {
        if let Some(&index) = self.by_name.get(&point.name)
            && self.points[index] == *point
        {
            return index;
        }
        self.points.push(point.clone());
        let index = self.points.len() - 1;
        self.by_name.insert(point.name.clone(), index);
        index
    }
}

impl Session {
    /// What was given since the start, also before scans that were stepped back from.
    pub(crate) fn given(&self) -> Result<&AllGiven, NotKnown> {
        self.given.not_known.map_or(Ok(&self.given), Err)
    }

    /// A scan begins, for which something was given or not.
    pub(super) fn note_given(&mut self) {
        self.given.forget_from(self.simulation.machine.scan as u64);
        if self.changed {
            let before = &self.history.banks.memory;
            self.given
                .take(&self.simulation, false, |point| Some((point, before)));
            self.given.take_held(&self.simulation);
        }
    }

    /// Another program goes on: what the world gave that no scan has run with. The rest the change carries over.
    pub(super) fn note_given_at_change(&mut self, new: &Simulation) {
        self.given.forget_from(new.machine.scan as u64);
        let is_input = |point: &&Point| point.is_input;
        let before = self.simulation.points().iter().filter(is_input);
        let before: HashMap<&str, &Point> = before.map(|point| (point.name.as_str(), point)).collect();
        let memory = &self.history.banks.memory;
        self.given.take(new, true, |point| {
            let before = before.get(point.name.as_str()).filter(|_| is_input(&point));
            before.map(|before| (*before, memory))
        });
    }

    /// The newest program, wherever the session was stepped back to.
    pub(crate) fn newest_program(&self) -> &Arc<Program> {
        let newest = self.later.first().map(super::change::Era::parts);
        newest
            .map_or(&self.simulation, |(simulation, _)| simulation)
            .program()
    }
}
