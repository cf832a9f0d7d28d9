//! Asks the prover.

use ladder_analysis::Cancel;
use ladder_host::Clock;
use ladder_prover::{Answer, Clock as ProofClock, Options, drawn, found_scenario, prove, scenario_file};
use ladder_simulator::Simulation;
use ladder_simulator::scenario::{self, Monitor, Suite};

use super::{LeftOpen, PropertyProved};
use crate::scenario_run::Files;

/// Decides the properties of a file, or one of them, for no longer than `ladder prove` does, unless it is cancelled.
///
/// # Errors
///
/// A sentence for the person where the file has an error, or no such property.
pub(crate) fn run(
    files: &Files<'_>,
    suite: &Suite,
    simulation: &mut Simulation,
    only: Option<&str>,
    clock: Clock,
    cancel: Cancel,
) -> Result<Vec<PropertyProved>, String> {
    let (mut watched, found) = scenario::bind_properties(suite, simulation);
    files.without_errors(suite.errors.iter().chain(&found))?;
    if let Some(only) = only {
        watched.properties.retain(|property| property.name == only);
    }
    if watched.properties.is_empty() {
        return Err(match only {
            Some(only) => format!("the file has no property \"{only}\" any more"),
            None => "there is no property in this file; write one, as in: never up and down".to_owned(),
        });
    }
    let options = Options {
        clock: ProofClock::new(move || clock.now()),
        cancel,
        ..Options::default()
    };
    let answers = prove(simulation, &mut watched, options).map_err(|refuted| {
        format!(
            "the prover found a run for \"{}\" that does not happen in the simulator: this is an error in the prover, please \
             report it with the program",
            refuted.name
        )
    })?;
    let interval = simulation.options().interval;
    let program = suite.program.as_ref().map_or("", |(name, _)| name);
    let properties = watched.properties.iter().zip(answers);
    Ok(properties
        .map(|(property, answer)| proved(files, property, &answer, program, interval))
        .collect())
}

fn proved(
    files: &Files<'_>,
    property: &Monitor,
    answer: &Answer,
    program: &str,
    interval: i64,
) -> PropertyProved {
    let word = answer.verdict.word();
    let scenario = found_scenario(&property.name, &property.form, &answer.verdict, interval);
    let open = answer.open.iter().map(|(what, location)| LeftOpen {
        message: what.clone(),
        range: location.and_then(|location| files.own(location)),
    });
    PropertyProved {
        name: property.name.clone(),
        range: files.scenarios.range(property.range),
        verdict: word.to_owned(),
        message: format!("{word} {}", answer.note(interval)).trim_end().to_owned(),
        scan: answer.verdict.scan(),
        times: answer.verdict.times().map(str::to_owned),
        never_triggered: answer.never_triggered,
        open: open.collect(),
        diagram: scenario.as_deref().map(drawn).unwrap_or_default(),
        scenario: scenario.map_or(String::new(), |scenario| {
            scenario_file(program, interval, &[scenario])
        }),
    }
}
