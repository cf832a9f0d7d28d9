//! A run as a scenario: what goes in, and what came of it. It passes as it is, and becomes a test of the repaired program when
//! what came is replaced by what is to come.

use crate::answer::Verdict;
use crate::replay::Shown;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_simulator::scenario::{self, Form, RunCell, RunRow, run_text};
use ladder_simulator::{Point, value_text};

/// The run that was found for a property, as a scenario. `interval` is the time from scan to scan, in nanoseconds. None where
/// none was found.
pub fn found_scenario<E>(property: &str, form: &Form<E>, verdict: &Verdict, interval: i64) -> Option<String> {
    let (word, shown) = match verdict {
        Verdict::Violated(shown) => ("violated", shown),
        Verdict::Possible(shown) => ("possible", shown),
        _ => return None,
    };
    let is_about_faults = matches!(form, Form::NoFaults);
    let name = format!("{property} is {word}");
    Some(scenario_of(&name, shown, interval, is_about_faults))
}

fn scenario_of(name: &str, shown: &Shown, interval: i64, is_about_faults: bool) -> String {
    let name: String = name.chars().filter(|c| *c != '"' && !c.is_control()).collect();
    let mut rows: Vec<RunRow> = shown
        .given
        .iter()
        .map(|(point, values)| row(point, values, false))
        .collect();
    if is_about_faults {
        for row in &mut rows {
            row.cells.extend(row.cells.last().cloned());
        }
        // It shows the fault one scan later.
        let mut cells = vec![RunCell::Nothing; shown.scans()];
        cells.push(RunCell::New("TRUE".to_owned()));
        rows.push(level_expected("SYS.FAULT", cells));
    } else {
        let seen = shown.seen.iter().map(|(point, values)| row(point, values, true));
        rows.extend(seen);
        if shown.seen.is_empty() {
            // A scenario expects something.
            rows.push(match shown.given.first() {
                Some((point, values)) => row(point, values, true),
                None => level_expected("SYS.ON", vec![RunCell::New("TRUE".to_owned()); shown.scans()]),
            });
        }
    }
    run_text(rows, interval, &name)
}

fn level_expected(tag: &str, cells: Vec<RunCell>) -> RunRow {
    RunRow {
        name: tag.to_owned(),
        is_expected: true,
        is_level: true,
        goes_on: true,
        cells,
    }
}

fn row(point: &Point, values: &[Value], is_expected: bool) -> RunRow {
    let cell = |(scan, value): (usize, &Value)| {
        let text = value_text::display(value, point.ty);
        let is_still = scan > 0 && values[scan - 1] == *value;
        if is_still {
            RunCell::Still(text)
        } else {
            RunCell::New(text)
        }
    };
    RunRow {
        name: point.name.clone(),
        is_expected,
        is_level: point.ty == Scalar::Bool,
        goes_on: true,
        cells: values.iter().enumerate().map(cell).collect(),
    }
}

/// A scenario file of these scenarios, in its layout. `interval` is in nanoseconds.
pub fn scenario_file(program: &str, interval: i64, scenarios: &[String]) -> String {
    let mut text = format!("program {program}\ninterval {}\n", value_text::duration(interval));
    for scenario in scenarios {
        text.push('\n');
        text.push_str(scenario);
    }
    scenario::layout(&text)
}
