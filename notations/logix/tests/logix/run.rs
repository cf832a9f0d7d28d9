//! Runs what a program becomes.

use ladder_analysis::values::value::Value;
use ladder_format::Options;
use ladder_notation::{Converted, Notation, Source, convert};
use ladder_simulator::{Inputs, Options as Run, Simulation};
use std::sync::Arc;

/// A file as ladder text, which must have no errors.
#[track_caller]
pub(crate) fn converted(notation: &dyn Notation, bytes: &[u8]) -> Converted {
    let converted = convert(notation, &Source::alone("prog", bytes), &Options::default());
    let converted = converted.unwrap_or_else(|error| panic!("{error}"));
    let errors = errors(&converted.written.text);
    assert!(
        errors.is_empty(),
        "{}\n{}",
        errors.join("\n"),
        converted.written.text
    );
    converted
}

/// The errors of a ladder text, each with its place.
pub(crate) fn errors(text: &str) -> Vec<String> {
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(text).into(), "prog.clad");
    let lines = ladder_notation::Lines::of(text);
    let error = |error: &ladder_analysis::Diagnostic| {
        let at = lines.place(text, error.range.start().into());
        format!("{at}: {}: {}", error.message, &text[error.range])
    };
    analysis.errors().map(error).collect()
}

/// The values of tags after each scan, as a table with their names above. The inputs are a table too, a row for each scan.
#[track_caller]
pub(crate) fn trace(text: &str, inputs: &str, scans: u64, watched: &str) -> String {
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(text).into(), "prog.clad");
    let program = analysis
        .program()
        .unwrap_or_else(|| panic!("{:?}\n{text}", errors(text)));
    let mut simulation = Simulation::new(Arc::clone(program), Run::default()).expect("it can be run");
    let inputs = match inputs {
        "" => Inputs::default(),
        inputs => Inputs::parse("in.csv", inputs, &simulation).unwrap_or_else(|error| panic!("{error}")),
    };
    let points = watched.split(',').map(|name| simulation.resolve(name));
    let points: Vec<_> = points
        .map(|point| point.unwrap_or_else(|error| panic!("{error}")))
        .collect();
    let mut out = watched.to_owned();
    for scan in 0..scans {
        inputs.give(scan, &mut simulation);
        assert!(simulation.scan(), "the scan ends");
        for fault in simulation.take_faults() {
            out.push_str(&format!("\n{scan}: {}", fault.message));
        }
        let shown = points.iter().map(|point| match simulation.value(point) {
            Value::Bool(high) => u8::from(high).to_string(),
            Value::Int(number) => number.to_string(),
            Value::Real(real) => format!("{real:?}"),
            text @ Value::Text(_) => format!("{text:?}"),
        });
        out.push('\n');
        out.push_str(&shown.collect::<Vec<_>>().join(","));
    }
    out
}
