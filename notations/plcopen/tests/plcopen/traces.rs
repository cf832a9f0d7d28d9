//! Projects run as other tools ran them: each is fed with its inputs, and compared scan by scan.

use crate::corpus::{converted, files, others, own, stem};
use ladder_analysis::analyze;
use ladder_analysis::values::value::Value;
use ladder_simulator::{Options, Simulation};
use std::fs;
use std::path::Path;
use std::sync::Arc;

/// The time of a row, in nanoseconds.
const STEP: i64 = 100_000_000;

#[test]
fn own_traces() {
    compare_all(&own());
}

#[test]
fn traces_of_others() {
    if let Some(folder) = others("plcopen-xml") {
        compare_all(&folder);
    }
}

#[track_caller]
fn compare_all(projects: &Path) {
    let mut different = Vec::new();
    let mut count = 0;
    for trace in files(&own(), "csv") {
        let name = stem(&trace);
        let project = projects.join(format!("{name}.xml"));
        if !trace.to_string_lossy().ends_with(".expected.csv") || !project.exists() {
            continue;
        }
        count += 1;
        if let Err(why) = compare(&project, &trace) {
            different.push(format!("{name}: {why}"));
        }
    }
    assert!(count > 0, "there is no trace");
    assert!(
        different.is_empty(),
        "{} of {count} differ:\n{}",
        different.len(),
        different.join("\n")
    );
}

fn compare(project: &Path, trace: &Path) -> Result<(), String> {
    let converted = converted(project);
    let ladder = &converted.written.text;
    let analysis = analyze(&ladder_syntax::parse(ladder).into(), "test.clad");
    let errors: Vec<String> = analysis.errors().map(|error| error.message.clone()).collect();
    let Some(program) = analysis.program() else {
        return Err(format!("it has errors: {errors:?}\n{ladder}"));
    };
    let options = Options {
        interval: STEP,
        ..Options::default()
    };
    let mut simulation = Simulation::new(Arc::clone(program), options).map_err(|error| error.message)?;
    let expected = fs::read_to_string(trace).map_err(|error| error.to_string())?;
    let inputs = trace.to_string_lossy().replace(".expected.csv", ".in.csv");
    let inputs = fs::read_to_string(inputs).map_err(|error| error.to_string())?;
    let mut inputs = inputs.lines();
    let fed: Vec<&str> = inputs.next().unwrap_or_default().split(',').collect();
    let mut rows = expected.lines();
    let names: Vec<&str> = rows.next().unwrap_or_default().split(',').skip(2).collect();
    for (scan, row) in rows.enumerate() {
        let given = inputs.next().unwrap_or_default().split(',').zip(&fed);
        for (value, name) in given
            .map(|(value, name)| (value.trim_matches('"'), name))
            .filter(|(value, _)| !value.is_empty())
        {
            let point = simulation.resolve(name).map_err(|error| error.message)?;
            let set = simulation.set(&point, Value::Bool(value == "1"));
            set.map_err(|error| format!("{error:?}"))?;
        }
        simulation.scan();
        for (expected, name) in row.split(',').skip(2).zip(&names) {
            let point = simulation
                .resolve(name)
                .map_err(|error| format!("{}\n{ladder}", error.message))?;
            let value = match simulation.value(&point) {
                Value::Bool(value) => u8::from(value).to_string(),
                // The traces have times in milliseconds, and no numbers as large.
                Value::Int(value) if value.abs() >= 1_000_000 => (value / 1_000_000).to_string(),
                Value::Int(value) => value.to_string(),
                value => format!("{value:?}"),
            };
            if value != expected {
                return Err(format!(
                    "scan {scan}: {name} is {value}, not {expected}\n{ladder}"
                ));
            }
        }
    }
    Ok(())
}
