//! Runs of cases that contradict the verdict on them.

use super::case::Case;
use ladder_analysis::program::Role;
use ladder_generator::generator::Dice;
use ladder_generator::runs::{HELD, Inputs, SCANS};
use ladder_prover::Divergence;
use ladder_simulator::scenario::{Monitor, Watched, bind_properties, parse};
use ladder_simulator::{Simulation, Status};

/// A run that does what a property of the text says that none does: which property, and when. `said`: which are believed.
pub(crate) fn violated(case: &Case, properties: &str, told: &[bool], seed: u64) -> Option<String> {
    let mut simulation = case.running()?;
    let (mut watched, errors) = bind_properties(&parse(properties), &simulation);
    assert_eq!(errors, [], "{case}\n{properties}");
    for (run, held) in HELD.into_iter().enumerate() {
        simulation.reset();
        simulation.take_faults();
        watched.properties.iter_mut().for_each(Monitor::restart);
        let mut inputs = Inputs::new(&case.inputs, Dice::new(seed ^ run as u64), held);
        for scan in 0..SCANS {
            inputs.give(&mut [&mut simulation]);
            if !simulation.scan() {
                break;
            }
            if let Some(name) = violated_now(&mut simulation, &mut watched, told) {
                return Some(format!("\"{name}\" in run {run}, scan {scan}"));
            }
            if simulation.status() != Status::Ready {
                break;
            }
        }
    }
    None
}

fn violated_now(simulation: &mut Simulation, watched: &mut Watched, told: &[bool]) -> Option<String> {
    let faulted = !simulation.take_faults().is_empty();
    let mut found = None;
    for (monitor, told) in watched.properties.iter_mut().zip(told) {
        let violates = monitor.violates(simulation, faulted);
        if violates && *told {
            found.get_or_insert_with(|| monitor.name.clone());
        }
    }
    found
}

/// Plays a difference that was found, with what is shown of it and no more.
pub(crate) fn is_so(mut old: Simulation, mut new: Simulation, run: &Divergence) -> bool {
    let mut is_so = true;
    for simulation in [&mut old, &mut new] {
        simulation.reset();
        simulation.take_faults();
    }
    for scan in 0..run.scans {
        for simulation in [&mut old, &mut new] {
            for row in &run.given {
                let point = simulation.resolve(&row.name).ok();
                if let Some(point) = point.filter(|point| point.is_input) {
                    simulation.set(&point, row.values[scan].clone()).expect("it fits");
                }
            }
            is_so &= simulation.scan();
        }
        for differing in &run.differs {
            let value = |simulation: &Simulation| {
                simulation.value(&simulation.resolve(&differing.name).expect("both have it"))
            };
            is_so &= value(&old) == differing.old[scan] && value(&new) == differing.new[scan];
        }
        let faulted = [&mut old, &mut new].map(|simulation| !simulation.take_faults().is_empty());
        is_so &= faulted == [run.faults[0][scan], run.faults[1][scan]];
    }
    let last = run.scans - 1;
    let shows = run.differs.iter().any(|tag| tag.old[last] != tag.new[last]);
    is_so && (shows || run.faults[0][last] != run.faults[1][last] || run.ended.is_some())
}

/// A run in which two programs do not show the same: what differs, and when.
pub(crate) fn differing(old: &Case, new: &Case, seed: u64) -> Option<String> {
    let (mut was, mut is, seen) = (old.running()?, new.running()?, old.opened()?);
    let outputs = (was.points().iter())
        .filter(|point| point.role == Role::Output || point.name.starts_with(['y', 'Q']))
        .filter(|point| !point.ty.is_string() && seen.resolve(&point.name).is_ok())
        .filter_map(|point| Some((point.clone(), is.resolve(&point.name).ok()?)))
        .collect::<Vec<_>>();
    ladder_generator::runs::differing([&mut was, &mut is], &old.inputs, &outputs, seed)
}
