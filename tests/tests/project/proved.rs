//! Verdicts of the prover next to random runs: what is proved, no run violates.

use crate::followed::{programs, value};
use ladder_analysis::program::Role;
use ladder_analysis::values::types::Scalar;
use ladder_invariants::generator::{Dice, Mode, program};
use ladder_invariants::trace::compile;
use ladder_prover::{Options, Verdict, prove};
use ladder_simulator::scenario::{bind_properties, parse};
use ladder_simulator::{Options as Running, Simulation, Status};
use std::time::Duration;

/// Properties of some pairs of a program's BOOLs.
fn properties(simulation: &Simulation, dice: &mut Dice) -> String {
    let points = simulation.points().iter();
    let names: Vec<&str> = points
        .filter(|point| point.ty == Scalar::Bool)
        .map(|point| point.name.as_str())
        .collect();
    let mut text = String::from("program p.clad\nno faults\n");
    if names.is_empty() {
        return text;
    }
    for number in 0..6 {
        let (a, b) = (dice.of(&names), dice.of(&names));
        let form = match number {
            0 => format!("never {a} and not {b}"),
            1 => format!("when rises({a}): {b}"),
            2 => format!("when {a}: not {b} until {b}"),
            3 => format!("after {a}: {b} or was({a})"),
            4 => format!("within 2 scans of {a}: {b}"),
            _ => format!("possible {a} and falls({b})"),
        };
        text.push_str(&format!("property \"{number}\"\n{form}\n"));
    }
    text
}

/// How many verdicts there were that runs could contradict, runs that were found, and properties.
fn check(text: &str, seed: u64) -> (usize, usize, usize) {
    let Some(program) = compile(text) else {
        return (0, 0, 0);
    };
    let running = Running {
        watchdog: 20_000,
        ..Running::default()
    };
    let Ok(mut simulation) = Simulation::new(program, running) else {
        return (0, 0, 0);
    };
    let mut dice = Dice::new(seed);
    let suite = parse(&properties(&simulation, &mut dice));
    assert_eq!(suite.errors, []);
    let (mut watched, errors) = bind_properties(&suite, &simulation);
    assert_eq!(errors, []);
    let options = Options {
        time: Duration::from_secs(5),
        scans: 12,
    };
    let answers = prove(&mut simulation, &mut watched, options)
        .unwrap_or_else(|refuted| panic!("seed {seed}: {} does not happen\n{text}", refuted.name));
    let is_never = |verdict: &Verdict| matches!(verdict, Verdict::Proved(_) | Verdict::Impossible(_));
    let inputs: Vec<_> = simulation
        .points()
        .iter()
        .filter(|point| point.role == Role::Input && !point.read_only)
        .cloned()
        .collect();
    for run in 0..5 {
        simulation.reset();
        simulation.take_faults();
        watched
            .properties
            .iter_mut()
            .for_each(ladder_simulator::scenario::Monitor::restart);
        for scan in 0..40 {
            for input in &inputs {
                if dice.one_in(4) {
                    let value = value(&mut dice, input.ty);
                    simulation.set(input, value).expect("it fits");
                }
            }
            if !simulation.scan() {
                break;
            }
            let faulted = !simulation.take_faults().is_empty();
            for (monitor, answer) in watched.properties.iter_mut().zip(&answers) {
                let violates = monitor.violates(&simulation, faulted);
                assert!(
                    !(violates && is_never(&answer.verdict)),
                    "seed {seed}, run {run}, scan {scan}: {} is {:?}\n{text}",
                    monitor.name,
                    answer.verdict
                );
            }
            if simulation.status() != Status::Ready {
                break;
            }
        }
    }
    let never = answers.iter().filter(|answer| is_never(&answer.verdict)).count();
    let found = answers
        .iter()
        .filter(|answer| matches!(answer.verdict, Verdict::Violated(_) | Verdict::Possible(_)));
    (never, found.count(), answers.len())
}

/// At least so many of each, and of a hundred properties so many are decided.
fn check_all(mode: Mode, least: usize, decided: usize) {
    let mut tally = (0, 0, 0);
    for seed in 0..programs() {
        let (never, found, all) = check(&program(seed, mode), seed);
        tally = (tally.0 + never, tally.1 + found, tally.2 + all);
    }
    println!("{mode:?}: {} never, {} found, of {}", tally.0, tally.1, tally.2);
    assert!(tally.0 >= least && tally.1 >= least, "{tally:?}");
    assert!((tally.0 + tally.1) * 100 >= tally.2 * decided, "{tally:?}");
}

#[test]
fn contacts_and_coils_are_decided_right() {
    check_all(Mode::Boolean, 10, 99);
}

#[test]
fn sensible_programs_are_decided_right() {
    check_all(Mode::Sensible, 10, 90);
}

#[test]
fn wild_programs_are_decided_right() {
    check_all(Mode::Wild, 5, 85);
}

#[test]
fn programs_with_types_are_decided_right() {
    check_all(Mode::Typed, 5, 80);
}
