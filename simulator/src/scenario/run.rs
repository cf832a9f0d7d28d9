//! Playing a scenario.

use super::bind::{Case, Expected, Give, Target};
use super::monitor::Watched;
use super::tolerance::Tolerance;
use super::watch::{Outside, Violation, Watch};
use crate::fault::Fault;
use crate::simulation::{Simulation, Status};
use ladder_analysis::values::value::Value;
use ladder_syntax::TextRange;

/// A scenario may do the work of this many blocks.
pub(super) const MOST_BLOCKS: u64 = 10_000_000_000;

/// What came of a scenario.
#[derive(Debug, Clone, PartialEq)]
pub struct Ran {
    /// For each row that expects something, what was there at the end of each step; none after a fault that
    /// stopped the simulation.
    pub(super) got: Vec<Vec<Option<Value>>>,
    /// In which steps the controller had no power.
    pub(super) off: Vec<bool>,
    /// What is not as expected, row by row.
    pub differences: Vec<Difference>,
    /// The properties that it violates, in the order of the file.
    pub violations: Vec<Violation>,
    /// Where it leaves what is assumed of what goes in.
    pub outside: Option<Outside>,
    /// The faults that were recorded, in their order.
    pub faults: Vec<Fault>,
    /// How many scans were run.
    pub scans: u64,
    /// The step in which a fault stopped the simulation, from 0, if that was not expected.
    pub stopped: Option<usize>,
}

impl Ran {
    /// Whether all is as expected, and no property is violated.
    pub fn passed(&self) -> bool {
        self.differences.is_empty() && self.violations.is_empty() && self.stopped.is_none()
    }
}

/// A row that is not as expected.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Difference {
    /// The row, among those that expect something.
    pub(super) row: usize,
    /// The tag.
    pub tag: String,
    /// Where the first value is that is not met.
    pub range: TextRange,
    /// The steps that differ, from 0, in their order.
    pub steps: Vec<usize>,
    /// Where their values are; those that touch are one place.
    pub places: Vec<TextRange>,
}

/// Runs a scenario from a cold start, and watches the properties of its file. `scan` runs each scan, as
/// [`Simulation::scan`] does.
pub fn run(
    case: &Case,
    watched: &mut Watched,
    simulation: &mut Simulation,
    scan: impl FnMut(&mut Simulation) -> bool,
) -> Ran {
    run_within(MOST_BLOCKS, case, watched, simulation, scan)
}

/// Runs a scenario that may do the work of this many blocks.
pub fn run_within(
    most: u64,
    case: &Case,
    watched: &mut Watched,
    simulation: &mut Simulation,
    mut scan: impl FnMut(&mut Simulation) -> bool,
) -> Ran {
    simulation.unforce_all();
    simulation.reset();
    simulation.take_faults();
    simulation.take_serial();
    let mut watch = Watch::new(watched);
    let mut ran = Ran {
        got: vec![Vec::with_capacity(case.steps()); case.expected.len()],
        off: Vec::with_capacity(case.steps()),
        differences: Vec::new(),
        violations: Vec::new(),
        outside: None,
        faults: Vec::new(),
        scans: 0,
        stopped: None,
    };
    let begun = simulation.work();
    for step in 0..case.steps() {
        give(case, step, simulation);
        for _ in case.steps.begin(step)..case.steps.begin(step + 1) {
            let faults = simulation.fault_count();
            if !scan(simulation) {
                break;
            }
            watch.scan(simulation, step, simulation.fault_count() > faults);
            if simulation.work() - begun > most {
                simulation.exhaust(most);
                break;
            }
        }
        watch.step(simulation, step);
        ran.off.push(!simulation.had_power());
        ran.faults.extend(simulation.take_faults());
        let stopped = simulation.status() == Status::Faulted;
        if stopped && ran.stopped.is_none() {
            ran.stopped = Some(step);
        }
        let sent = simulation.take_serial();
        for (row, got) in case.expected.iter().zip(&mut ran.got) {
            got.push(match &row.target {
                // A scan that would follow would see it.
                Target::Point(point) if stopped && point.name == "SYS.FAULT" => Some(Value::Bool(true)),
                _ if stopped => None,
                Target::Point(point) => Some(simulation.value(point)),
                Target::Serial => Some(Value::Text(sent.as_slice().into())),
            });
        }
    }
    ran.scans = simulation.scans();
    ran.outside = watch.outside;
    ran.violations = watch.violations();
    compare(case, &mut ran);
    ran
}

fn give(case: &Case, step: usize, simulation: &mut Simulation) {
    for row in &case.given {
        let Some(Some(value)) = row.values.get(step) else {
            continue;
        };
        match (&row.target, value) {
            (Target::Point(point), Give::Value(value)) => {
                // What could be refused was found when the row was read.
                let _ = simulation.set(point, value.clone());
            }
            (Target::Point(point), Give::Back) => simulation.unforce(point),
            (Target::Serial, Give::Value(Value::Text(bytes))) => simulation.feed_serial(bytes),
            (Target::Serial, _) => {}
        }
    }
}

/// Whether a value is what a row expects, or near enough.
pub(super) fn is_met(row: &Expected, wanted: &Value, got: &Value) -> bool {
    let allows = |tolerance: Tolerance| tolerance.allows(wanted, got, row.target.ty());
    got == wanted || row.tolerance.is_some_and(allows)
}

fn compare(case: &Case, ran: &mut Ran) {
    for (index, (row, got)) in case.expected.iter().zip(&ran.got).enumerate() {
        let mut range = row.range;
        let mut steps = Vec::new();
        let mut places: Vec<TextRange> = Vec::new();
        for (step, ((wanted, place), got)) in row.values.iter().zip(got).enumerate() {
            let Some(wanted) = wanted else {
                continue;
            };
            if ran.off[step] && !row.is_of_plant {
                continue;
            }
            if got.as_ref().is_some_and(|got| is_met(row, wanted, got)) {
                continue;
            }
            if steps.is_empty() {
                range = *place;
            }
            steps.push(step);
            match places.last_mut() {
                Some(last) if last.end() == place.start() => *last = last.cover(*place),
                _ => places.push(*place),
            }
        }
        if !steps.is_empty() {
            ran.differences.push(Difference {
                row: index,
                tag: row.name.clone(),
                range,
                steps,
                places,
            });
        }
    }
    // A scenario that says when the fault comes has asked for it.
    let Some(step) = ran.stopped else {
        return;
    };
    let asked_for = case.expected.iter().any(|row| {
        row.name == "SYS.FAULT"
            && row
                .values
                .get(step)
                .is_some_and(|(wanted, _)| *wanted == Some(Value::Bool(true)))
    });
    if asked_for {
        ran.stopped = None;
    }
}
