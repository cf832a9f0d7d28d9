//! What a point held after each of the kept scans.

use super::Session;
use super::change::Era;
use super::history::History;
use super::rewind::Rewind;
use crate::simulation::Simulation;
use crate::tags::Point;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;

impl Session {
    /// What points held after each of the last scans, the oldest first: for each point up to `scans` values, of which
    /// the last is from the scan that the simulation is after. What was given since is not in it. Only kept
    /// scans are known, so there may be fewer, equally many for all points. Where the program was changed a point is the
    /// one of that name, whichever its tag has now, and type; what there was none of before shows nothing, or 0.
    pub fn past(&self, points: &[Point], scans: usize) -> Vec<Vec<Value>> {
        let mut past: Vec<Vec<Value>> = vec![Vec::new(); points.len()];
        let known = self.history.known().min(scans);
        let now: Vec<_> = points
            .iter()
            .map(|point| (point.ty, Some(point.clone())))
            .collect();
        note(&self.history, &self.simulation, &now, 0, known, &mut past);
        let mut known = known;
        for era in self.earlier.iter().rev() {
            // An era ends with the scan that the next one begins after.
            let (simulation, history) = era.parts();
            let more = history.known().saturating_sub(1).min(scans - known);
            if known == 0 || more == 0 {
                break;
            }
            let then = self.points_of(simulation, points);
            note(history, simulation, &then, 1, more, &mut past);
            known += more;
        }
        for values in &mut past {
            values.reverse();
        }
        past
    }

    /// What points hold after each of the scans that were stepped back from, the oldest first: for each point as many
    /// values as there are such scans. Where the program is changed in them a point is the one of that name and type.
    pub fn future(&self, points: &[Point]) -> Vec<Vec<Value>> {
        let mut future: Vec<Vec<Value>> = vec![Vec::new(); points.len()];
        let here = (&self.simulation, &self.history);
        let later = self.later.iter().rev().map(Era::parts);
        for (simulation, history) in std::iter::once(here).chain(later) {
            let then = self.points_of(simulation, points);
            history.look_ahead(|memory| {
                for ((ty, point), values) in then.iter().zip(future.iter_mut()) {
                    let value = point.as_ref().map(|point| point.read(memory));
                    values.push(value.unwrap_or_else(|| Value::zero(*ty)));
                }
            });
        }
        future
    }

    /// The points of those names and types in a program, each with its type.
    fn points_of(&self, simulation: &Simulation, points: &[Point]) -> Vec<(Scalar, Option<Point>)> {
        let found = points.iter().map(|point| {
            let then = self.find_in(simulation, &point.name).ok();
            (point.ty, then.filter(|then| then.ty == point.ty))
        });
        found.collect()
    }
}

/// Goes back and notes values after this many scans, but for the newest few.
fn note(
    history: &History,
    simulation: &Simulation,
    points: &[(Scalar, Option<Point>)],
    skipped: usize,
    count: usize,
    past: &mut [Vec<Value>],
) {
    let mut rewind = Rewind::new(history, simulation);
    for scan in 0..skipped + count {
        rewind.undo_given();
        if scan >= skipped {
            for ((ty, point), values) in points.iter().zip(past.iter_mut()) {
                let value = point.as_ref().map(|point| rewind.value(point));
                values.push(value.unwrap_or_else(|| Value::zero(*ty)));
            }
        }
        if !rewind.undo_scan() {
            break;
        }
    }
}
