//! The runs of the scenarios, held on at their end: a change that shows only after a long time shows in one of them.

use super::fate::{Run, outputs};
use super::subject::{Subject, Tested};
use ladder_analysis::values::value::Value;
use ladder_simulator::scenario::{self, Given, Watched};
use ladder_simulator::{Point, Simulation};

/// For so many scans what goes in is held.
const HELD: usize = 40_000;
/// No longer run is begun with.
const MOST_SCANS: u64 = 100_000;

/// Runs in which a changed program does not do the same, of those.
pub(super) fn differences(
    subject: &Subject,
    (mut old, mut new): (Simulation, Simulation),
) -> impl Iterator<Item = Run> {
    let tested = &subject.tested[0];
    let (cases, _) = scenario::bind(&tested.suite, &old);
    (0..cases.len())
        .filter(move |n| cases[*n].scans() < MOST_SCANS)
        .filter_map(move |n| in_case(tested, n, (&mut old, &mut new)))
}

/// What goes in and comes out of a run.
struct Seen {
    inputs: Vec<Given>,
    outputs: Vec<(Point, Vec<Value>)>,
}

fn in_case(tested: &Tested, case: usize, (old, new): (&mut Simulation, &mut Simulation)) -> Option<Run> {
    let (before, after) = (seen(tested, case, old)?, seen(tested, case, new)?);
    let pairs = || before.outputs.iter().zip(&after.outputs);
    let length = |seen: &Seen| seen.outputs.first().map_or(0, |(_, values)| values.len());
    let scans = length(&before).min(length(&after));
    let differs = |scan: &usize| pairs().any(|((_, one), (_, other))| one[*scan] != other[*scan]);
    let first = (0..scans).find(differs)?;
    let shown = pairs().filter(|((_, one), (_, other))| one[first] != other[first]);
    let shown = shown.map(|((point, _), _)| point.clone()).collect();
    let mut given = before.inputs;
    for (_, values) in &mut given {
        values.truncate(first + 1);
    }
    // What stays as it is at the start needs no row.
    given.retain(|(_, values)| values.iter().any(|value| *value != Value::Bool(false)));
    Some(Run::new(given, first + 1, shown))
}

fn seen(tested: &Tested, case: usize, simulation: &mut Simulation) -> Option<Seen> {
    let (cases, _) = scenario::bind(&tested.suite, simulation);
    let inputs = simulation.points().iter().filter(|point| point.is_input).cloned();
    let mut seen = Seen {
        inputs: inputs.map(|point| (point, Vec::new())).collect(),
        outputs: outputs(simulation)
            .into_iter()
            .map(|point| (point, Vec::new()))
            .collect(),
    };
    let case = cases.get(case)?;
    scenario::run(case, &mut Watched::default(), simulation, |simulation| {
        seen.scan(simulation)
    });
    for _ in 0..HELD {
        if !seen.scan(simulation) {
            break;
        }
    }
    Some(seen)
}

impl Seen {
    fn scan(&mut self, simulation: &mut Simulation) -> bool {
        for (point, values) in &mut self.inputs {
            values.push(simulation.value(point));
        }
        let has_run = simulation.scan();
        for (point, values) in &mut self.outputs {
            values.push(simulation.value(point));
        }
        has_run
    }
}
