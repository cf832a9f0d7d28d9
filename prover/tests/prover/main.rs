//! What the prover says.

mod equal;
mod open;
mod programs;
mod unread;
mod verdicts;

use ladder_prover::{Answer, Options, prove};
use ladder_simulator::scenario::{bind_properties, parse};
use ladder_simulator::{Options as Running, Simulation};
use std::sync::Arc;
use std::time::Duration;

/// A program, ready to run; none if it has errors.
fn simulation(program: &str, interval: i64) -> Option<Simulation> {
    let analysis = ladder_analysis::analyze(&Arc::new(ladder_syntax::parse(program)), "program.clad");
    let options = Running {
        interval,
        ..Running::default()
    };
    Some(Simulation::new(analysis.program()?.clone(), options).expect("it compiles"))
}

/// The answers to the properties of a text, with their names. None: the program has errors.
fn answers(program: &str, properties: &str) -> Option<Vec<(String, Answer)>> {
    let suite = parse(properties);
    assert_eq!(suite.errors, [], "{properties}");
    let interval = suite.interval.map_or(10_000_000, |(interval, _)| interval);
    let mut simulation = simulation(program, interval)?;
    let (mut watched, errors) = bind_properties(&suite, &simulation);
    assert_eq!(errors, [], "{properties}");
    let options = Options {
        time: Duration::from_secs(20),
        ..Options::default()
    };
    let answers = prove(&mut simulation, &mut watched, options).unwrap_or_else(|refuted| {
        panic!(
            "{}: a run was found that does not happen\n{program}",
            refuted.name
        )
    });
    let names = watched.properties.into_iter().map(|property| property.name);
    Some(names.zip(answers).collect())
}
