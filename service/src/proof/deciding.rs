//! Asks the prover.

use ladder_analysis::Cancel;
use ladder_host::Clock;
use ladder_prover::{
    Answer, Basis, Clock as ProofClock, Options, drawn, found_scenario, prove, scenario_file,
};
use ladder_simulator::Simulation;
use ladder_simulator::scenario::{self, Monitor, Suite};

use super::{Found, LeftOpen, PropertyProved};
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
) -> Result<Found, String> {
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
    let mut answers = prove(simulation, &mut watched, options.clone()).map_err(|refuted| {
        format!(
            "the prover found a run for \"{}\" that does not happen in the simulator: this is an error in the prover, please \
             report it with the program",
            refuted.name
        )
    })?;
    let basis = Basis::of(suite, simulation, &watched, &mut answers, &options);
    let interval = simulation.options().interval;
    let head = scenario::head(suite);
    let properties = watched.properties.iter().zip(answers);
    Ok(Found {
        properties: properties
            .map(|(property, answer)| proved(files, property, &answer, (&basis, &head), interval))
            .collect(),
        plants: basis.plants,
        unchanging: basis.unchanging,
    })
}

fn proved(
    files: &Files<'_>,
    property: &Monitor,
    answer: &Answer,
    (basis, head): (&Basis, &str),
    interval: i64,
) -> PropertyProved {
    let word = answer.verdict.word();
    let told = [word.to_owned(), answer.note(interval), basis.told(answer)];
    let told: Vec<String> = told.into_iter().filter(|told| !told.is_empty()).collect();
    let scenario = found_scenario(&property.name, &property.form, &answer.verdict, interval);
    let open = answer.open.iter().map(|(what, location)| LeftOpen {
        message: what.clone(),
        range: location.and_then(|location| files.own(location)),
    });
    PropertyProved {
        name: property.name.clone(),
        range: files.scenarios.range(property.range),
        verdict: word.to_owned(),
        message: told.join(" "),
        scan: answer.verdict.scan(),
        times: answer.verdict.times().map(str::to_owned),
        never_triggered: answer.never_triggered,
        needs_plant: answer.needs_plant,
        open: open.collect(),
        diagram: scenario.as_deref().map(drawn).unwrap_or_default(),
        scenario: scenario.map_or(String::new(), |scenario| {
            scenario_file(head, interval, &[scenario])
        }),
    }
}
