//! What a program does with given inputs, as a scenario that expects just that.

use super::layout::layout;
use super::record::written;
use super::run_text::{self, Lengths, RunCell, RunRow, scenario};
use crate::simulation::Simulation;
use crate::tags::Point;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use std::collections::BTreeSet;

/// What goes into a tag: a value before each scan.
pub type Given = (Point, Vec<Value>);

/// What the columns of a scenario are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Columns {
    /// Steps as the file has them: what is given changes at their beginnings only.
    Steps,
    /// Stretches in which nothing changes.
    Stretches,
}

/// Runs a program from a cold start, and writes what it does as a scenario of this name: what is given, and what the tags `shown` hold
/// then. `step` is how many scans a step of the file has.
///
/// None: the program stops in the midst of it, or holds what cannot be written.
pub fn scenario_of_inputs(
    simulation: &mut Simulation,
    (given, scans): (&[Given], usize),
    shown: &[Point],
    name: &str,
    (step, columns): (u64, Columns),
) -> Option<String> {
    simulation.unforce_all();
    simulation.reset();
    let mut held: Vec<Vec<Value>> = vec![Vec::new(); shown.len()];
    for scan in 0..scans {
        for (point, values) in given {
            simulation.set(point, values.get(scan)?.clone()).ok()?;
        }
        if !simulation.scan() {
            return None;
        }
        for (point, held) in shown.iter().zip(&mut held) {
            held.push(simulation.value(point));
        }
    }
    let mut begins: BTreeSet<usize> = BTreeSet::from([0]);
    match columns {
        Columns::Steps => begins.extend((0..scans).step_by(usize::try_from(step).ok()?)),
        Columns::Stretches => {
            for values in given.iter().map(|(_, values)| values).chain(&held) {
                begins.extend((1..scans).filter(|&scan| values[scan] != values[scan - 1]));
            }
        }
    }
    let begins: Vec<usize> = begins.into_iter().collect();
    let ends: Vec<usize> = begins.iter().copied().skip(1).chain([scans]).collect();
    let columns = run_text::columns(&begins, scans);
    let mut rows = Vec::new();
    for (point, values) in given {
        let mut cells = Vec::new();
        for &begin in &begins {
            let text = written(&values[begin], point.ty)?;
            let is_new = begin == 0 || values[begin] != values[begin - 1];
            cells.push(match (is_new, point.ty) {
                (true, _) => RunCell::New(text),
                (false, Scalar::Bool) => RunCell::Still(text),
                (false, _) => RunCell::Nothing,
            });
        }
        rows.push(row(point, false, cells));
    }
    for (point, values) in shown.iter().zip(&held) {
        let cells = ends
            .iter()
            .map(|end| Some(RunCell::New(written(&values[end - 1], point.ty)?)));
        rows.push(row(point, true, cells.collect::<Option<_>>()?));
    }
    let lengths = Lengths {
        columns: &columns,
        interval: simulation.options().interval,
    };
    // Laid out alone, so that the rest of its file stays as it is.
    Some(layout(&scenario(&rows, lengths, name, step)))
}

fn row(point: &Point, is_expected: bool, cells: Vec<RunCell>) -> RunRow {
    let is_level = point.ty == Scalar::Bool;
    RunRow {
        name: point.name.clone(),
        is_expected,
        is_level,
        goes_on: is_level,
        cells,
    }
}
