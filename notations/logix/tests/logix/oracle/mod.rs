//! The reader and the simulator next to an interpreter of neutral text that knows neither: random programs, scan by scan.
//!
//! `LADDER_LOGIX_PROGRAMS` is how many are tried.

mod files;
mod formula;
mod interpreter;
mod moves;
mod parts;
mod program;
mod timers;

use crate::back::back;
use crate::exports::whole;
use crate::run::{converted, errors};
use interpreter::Controller;
use ladder_analysis::values::value::Value;
use ladder_notation_logix::L5x;
use ladder_simulator::{Options, Simulation};
use program::{Dice, Program};
use std::sync::Arc;

/// A value of the simulation as the interpreter has it.
fn number(value: &Value) -> f64 {
    match value {
        Value::Bool(high) => f64::from(u8::from(*high)),
        Value::Int(number) => *number as f64,
        Value::Real(number) => *number,
        Value::Text(_) => f64::NAN,
    }
}

#[track_caller]
fn check(seed: u64) {
    let program = Program::new(&mut Dice(seed * 2 + 1));
    let tags: Vec<(&str, &str, &str)> = program
        .tags
        .iter()
        .map(|(n, t, v)| (n.as_str(), t.as_str(), v.as_str()))
        .collect();
    let rungs = |rungs: &'_ [String]| -> Vec<String> { rungs.to_vec() };
    let main = rungs(&program.main);
    let sub = rungs(&program.sub);
    let main: Vec<&str> = main.iter().map(String::as_str).collect();
    let sub: Vec<&str> = sub.iter().map(String::as_str).collect();
    let file = whole("", &tags, &[("Main", &main), ("Sub", &sub)]);
    let converted = converted(&L5x, file.as_bytes());
    let remarks: Vec<_> = converted.report.remarks().collect();
    assert!(remarks.is_empty(), "{remarks:?}");
    let text = converted.written.text;
    // The same program, and what is read of the file that is written of it.
    let (_, again) = back(&text).expect("it has no errors");
    let mut simulations = [simulation(&text), simulation(&again)];
    let mut controller = Controller::new(&program.tags, &[("Main", &program.main), ("Sub", &program.sub)]);
    controller.prescan();
    let watched = controller.names();
    let mut dice = Dice(seed + 77);
    for scan in 0..40 {
        for input in ["a", "b", "c"] {
            if dice.below(3) == 0 {
                let high = dice.below(2) == 1;
                controller.set(input, f64::from(u8::from(high)));
                for simulation in &mut simulations {
                    let point = simulation.resolve(input).expect("it is declared");
                    simulation
                        .set(&point, Value::Bool(high))
                        .expect("it takes a value");
                }
            }
        }
        controller.scan(10);
        for simulation in &mut simulations {
            assert!(simulation.scan(), "the scan ends");
            let faults = simulation.take_faults();
            assert!(faults.is_empty(), "{faults:?}\n{text}");
            for name in &watched {
                let point = simulation
                    .resolve(name)
                    .unwrap_or_else(|error| panic!("{error}\n{text}"));
                let (one, other) = (controller.get(name), number(&simulation.value(&point)));
                assert!(
                    (one - other).abs() <= 1e-6 * one.abs().max(1.0),
                    "seed {seed}, scan {scan}: {name} is {one}, and {other} here\n{}\n--\n{}\n{text}",
                    program.main.join("\n"),
                    program.sub.join("\n"),
                );
            }
        }
    }
}

#[track_caller]
fn simulation(text: &str) -> Simulation {
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(text).into(), "prog.clad");
    let ladder = analysis
        .program()
        .unwrap_or_else(|| panic!("{:?}\n{text}", errors(text)));
    Simulation::new(Arc::clone(ladder), Options::default()).expect("it can be run")
}

#[test]
fn random_programs_do_what_the_interpreter_says() {
    let count = std::env::var("LADDER_LOGIX_PROGRAMS").ok();
    let count = count.and_then(|count| count.parse().ok()).unwrap_or(40);
    for seed in 0..count {
        check(seed);
    }
}
