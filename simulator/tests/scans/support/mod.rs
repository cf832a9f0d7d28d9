//! Programs as text, inputs and traces as rows of a timing diagram.
#![allow(dead_code, reason = "each test file takes what it needs")]

use ladder_analysis::program::Program;
use ladder_analysis::{AnalyzeOptions, Exported, NotWhole, analyze, exports, link};
use ladder_simulator::value_text::{cell, parse};
use ladder_simulator::{Options, Simulation};
use ladder_syntax as syntax;
use std::sync::Arc;

/// The program of a text without errors.
pub(crate) fn simulation(text: &str) -> Simulation {
    simulation_with(text, Options::default())
}

/// The same with options.
pub(crate) fn simulation_with(text: &str, options: Options) -> Simulation {
    let analysis = Arc::new(analyze(&Arc::new(syntax::parse(text)), "test.clad"));
    match link(&analysis, &|_| None) {
        Ok(program) => Simulation::new(program, options).unwrap_or_else(|error| panic!("{error}")),
        Err(_) => {
            let messages: Vec<&str> = analysis
                .diagnostics()
                .iter()
                .map(|d| d.message.as_str())
                .collect();
            panic!("errors in the program:\n{}\n{text}", messages.join("\n"));
        }
    }
}

/// The program of the first of several files, each with its name and text.
pub(crate) fn linked(files: &[(&str, &str)]) -> Result<Arc<Program>, NotWhole> {
    let parsed: Vec<_> = files
        .iter()
        .map(|(name, text)| (*name, Arc::new(syntax::parse(text))))
        .collect();
    let summaries = parsed.iter().map(|(name, parse)| Arc::new(exports(parse, name)));
    let exported = Arc::new(Exported::new(summaries.collect()));
    let analysis = |wanted: &str| {
        let (name, parse) = parsed.iter().find(|(name, _)| *name == wanted)?;
        Some(Arc::new(analyze(
            parse,
            AnalyzeOptions::new(name).among(&exported.others_of(name)),
        )))
    };
    let own = analysis(files[0].0).expect("the first file is one of them");
    link(&own, &analysis)
}

/// A simulation of the first of several files.
pub(crate) fn simulation_of(files: &[(&str, &str)]) -> Simulation {
    let program = linked(files).unwrap_or_else(|not_whole| panic!("{not_whole:?}"));
    Simulation::new(program, Options::default()).unwrap_or_else(|error| panic!("{error}"))
}

/// Assigns a tag as a person would.
pub(crate) fn set(simulation: &mut Simulation, tag: &str, value: &str) {
    let point = simulation.resolve(tag).unwrap_or_else(|error| panic!("{error}"));
    let value = parse(value, point.ty).unwrap_or_else(|error| panic!("{error}"));
    simulation
        .set(&point, value)
        .unwrap_or_else(|error| panic!("{error}"));
}

/// Forces a tag as a person would.
pub(crate) fn force(simulation: &mut Simulation, tag: &str, value: &str) {
    let point = simulation.resolve(tag).unwrap_or_else(|error| panic!("{error}"));
    let value = parse(value, point.ty).unwrap_or_else(|error| panic!("{error}"));
    simulation
        .force(&point, value)
        .unwrap_or_else(|error| panic!("{error}"));
}

/// Lets a tag go.
pub(crate) fn unforce(simulation: &mut Simulation, tag: &str) {
    let point = simulation.resolve(tag).unwrap_or_else(|error| panic!("{error}"));
    simulation.unforce(&point);
}

/// What a tag holds, as a trace writes it.
pub(crate) fn get(simulation: &Simulation, tag: &str) -> String {
    let point = simulation.resolve(tag).unwrap_or_else(|error| panic!("{error}"));
    cell(&simulation.value(&point), point.ty)
}

/// Rows of inputs, one column a scan: `start _-__` for a BOOL, `level 1 2 . 4` for anything else; `.` leaves a tag
/// as it is. Without rows a number of scans.
pub(crate) fn stimulus(text: &str) -> (usize, Vec<(String, Vec<String>)>) {
    if let Ok(scans) = text.trim().parse() {
        return (scans, Vec::new());
    }
    let rows: Vec<(String, Vec<String>)> = text
        .lines()
        .filter_map(|line| line.trim().split_once(char::is_whitespace))
        .map(|(name, cells)| {
            let cells = cells.trim();
            let wave = cells.chars().all(|c| matches!(c, '_' | '-' | '.'));
            let cells = if wave {
                let level = |c| match c {
                    '_' => "0",
                    '-' => "1",
                    _ => ".",
                };
                cells.chars().map(|c| level(c).to_owned()).collect()
            } else {
                cells.split_whitespace().map(str::to_owned).collect()
            };
            (name.to_owned(), cells)
        })
        .collect();
    (rows.iter().map(|(_, cells)| cells.len()).max().unwrap_or(0), rows)
}

/// Runs a program and shows the tags that are watched, one column a scan: BOOLs as waves, the rest as numbers. Faults
/// are below.
pub(crate) fn trace(simulation: &mut Simulation, inputs: &str, watch: &str) -> String {
    let (scans, rows) = stimulus(inputs);
    let points: Vec<_> = watch
        .split_whitespace()
        .map(|tag| {
            (
                tag,
                simulation.resolve(tag).unwrap_or_else(|error| panic!("{error}")),
            )
        })
        .collect();
    let mut columns: Vec<Vec<String>> = vec![Vec::new(); points.len()];
    let mut faults = Vec::new();
    for scan in 0..scans {
        for (tag, cells) in &rows {
            if let Some(value) = cells.get(scan).filter(|cell| *cell != ".") {
                set(simulation, tag, value);
            }
        }
        let ran = simulation.scan();
        for fault in simulation.take_faults() {
            faults.push(format!(
                "scan {} at {}: {}",
                fault.scan,
                usize::from(fault.location.range.start()),
                fault.message
            ));
        }
        if !ran {
            break;
        }
        for ((_, point), column) in points.iter().zip(&mut columns) {
            column.push(cell(&simulation.value(point), point.ty));
        }
    }
    let width = points.iter().map(|(tag, _)| tag.len()).max().unwrap_or(0);
    let mut text = String::new();
    for ((tag, point), column) in points.iter().zip(columns) {
        let cells = if point.ty == ladder_analysis::values::types::Scalar::Bool {
            column
                .iter()
                .map(|cell| if cell == "1" { '-' } else { '_' })
                .collect()
        } else {
            column.join(" ")
        };
        text.push_str(&format!("{tag:width$}  {cells}\n"));
    }
    for fault in faults {
        text.push_str(&format!("{fault}\n"));
    }
    text
}

/// Runs a text and compares the trace.
#[track_caller]
#[allow(clippy::needless_pass_by_value)]
pub(crate) fn check(text: &str, inputs: &str, watch: &str, expected: expect_test::Expect) {
    expected.assert_eq(&trace(&mut simulation(text), inputs, watch));
}
