//! What was given from outside, scan by scan, since the program began.

use super::Session;
use super::history::History;
use crate::simulation::Simulation;
use crate::tags::Point;
use ladder_analysis::program::{Program, Role};
use ladder_analysis::value::Value;
use std::collections::HashMap;
use std::sync::Arc;

/// What was given before a scan.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct GivenBefore {
    pub(crate) scan: u64,
    pub(crate) values: Vec<(Point, Value)>,
}

impl Session {
    /// What was given before each of the scans up to here, the oldest first. None if the first of them are not kept any
    /// more.
    pub(crate) fn given(&self) -> Option<Vec<GivenBefore>> {
        let eras = self.earlier.iter().map(super::change::Era::parts);
        let eras: Vec<_> = eras.chain([(&self.simulation, &self.history)]).collect();
        let (first, first_history) = eras.first()?;
        if !first_history.is_on() || !first_history.is_from_the_start || first_history.base.scan != 0 {
            return None;
        }
        let mut all = Vec::new();
        let initial = |point: &Point| point.read(&first.compiled.initial);
        let mut before: HashMap<String, Value> = first
            .points()
            .iter()
            .map(|point| (point.name.clone(), initial(point)))
            .collect();
        for (simulation, history) in eras {
            let points = simulation.points();
            let base = history.values_at_base(simulation, points);
            // What the world gave while the program was changed; the rest the change has carried over.
            let since = points.iter().zip(&base).filter(|(point, value)| {
                let is_first = history.base.scan == 0;
                (is_first || point.role == Role::Input)
                    && before.get(&point.name).is_some_and(|before| before != *value)
            });
            let values: Vec<_> = since
                .map(|(point, value)| (point.clone(), value.clone()))
                .collect();
            if !values.is_empty() {
                all.push(GivenBefore {
                    scan: history.base.scan as u64,
                    values,
                });
            }
            all.extend(history.given_by_scan(simulation, points));
            before = history.values_at_end(simulation, points);
        }
        all.retain(|given| !given.values.is_empty());
        Some(all)
    }

    /// The newest program, wherever the session was stepped back to.
    pub(crate) fn newest_program(&self) -> &Arc<Program> {
        let newest = self.later.first().map(super::change::Era::parts);
        newest
            .map_or(&self.simulation, |(simulation, _)| simulation)
            .program()
    }
}

impl History {
    /// What points held before the oldest scan, and before anything was given for it.
    fn values_at_base(&self, simulation: &Simulation, points: &[Point]) -> Vec<Value> {
        let mut rewind = self.rewind(simulation);
        loop {
            rewind.undo_given();
            if !rewind.undo_scan() {
                return points.iter().map(|point| rewind.value(point)).collect();
            }
        }
    }

    /// What they hold after the last scan.
    fn values_at_end(&self, simulation: &Simulation, points: &[Point]) -> HashMap<String, Value> {
        let mut rewind = self.rewind(simulation);
        rewind.undo_given();
        let values = points
            .iter()
            .map(|point| (point.name.clone(), rewind.value(point)));
        values.collect()
    }

    /// What was given before each scan.
    fn given_by_scan(&self, simulation: &Simulation, points: &[Point]) -> Vec<GivenBefore> {
        let mut all = Vec::new();
        let mut rewind = self.rewind(simulation);
        rewind.undo_given();
        while rewind.undo_scan() {
            if !rewind.has_given() {
                rewind.undo_given();
                continue;
            }
            let after: Vec<Value> = points.iter().map(|point| rewind.value(point)).collect();
            rewind.undo_given();
            let pairs = points.iter().zip(after);
            let given = pairs.filter(|(point, after)| rewind.value(point) != *after);
            all.push(GivenBefore {
                scan: self.clock_before(rewind.entry()).0,
                values: given.map(|(point, after)| (point.clone(), after)).collect(),
            });
        }
        all.reverse();
        all
    }
}
