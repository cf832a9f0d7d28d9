//! A run as a scenario: what goes in, and what came of it. It passes as it is, and becomes a test of the repaired program when
//! what came is replaced by what is to come.

use crate::answer::Verdict;
use crate::divergence::{Divergence, Which};
use crate::replay::Shown;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_simulator::scenario::{self, Form, RunCell, RunRow, run_text};
use ladder_simulator::value_text;

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
        .map(|(point, values)| row((&point.name, point.ty), values, false))
        .collect();
    if is_about_faults {
        add_scan(&mut rows);
        let mut cells = vec![RunCell::Nothing; shown.scans()];
        cells.push(RunCell::New("TRUE".to_owned()));
        rows.push(level_expected(&shown.fault_tag, cells));
    } else {
        let seen = shown
            .seen
            .iter()
            .map(|(point, values)| row((&point.name, point.ty), values, true));
        rows.extend(seen);
        if shown.seen.is_empty() {
            // A scenario expects something.
            rows.push(match shown.given.first() {
                Some((point, values)) => row((&point.name, point.ty), values, true),
                None => level_expected("SYS.ON", vec![RunCell::New("TRUE".to_owned()); shown.scans()]),
            });
        }
    }
    run_text(rows, interval, &name)
}

/// A scan more, in which all stays as it is: SYS.FAULT shows a fault one scan later.
fn add_scan(rows: &mut [RunRow]) {
    for row in rows {
        row.cells.extend(row.cells.last().cloned());
    }
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

fn row((name, ty): (&str, Scalar), values: &[Value], is_expected: bool) -> RunRow {
    let cell = |(scan, value): (usize, &Value)| {
        let text = value_text::display(value, ty);
        let is_still = scan > 0 && values[scan - 1] == *value;
        if is_still {
            RunCell::Still(text)
        } else {
            RunCell::New(text)
        }
    };
    RunRow {
        name: name.to_owned(),
        is_expected,
        is_level: ty == Scalar::Bool,
        goes_on: true,
        cells: values.iter().enumerate().map(cell).collect(),
    }
}

fn given(run: &Divergence) -> Vec<RunRow> {
    let rows = run.given.iter();
    rows.map(|given| row((&given.name, given.ty), &given.values, false))
        .collect()
}

/// A run in which two programs differ as a scenario of this name, with what one of them shows: that one passes it. None: no
/// scenario shows that only one program comes to its end.
pub fn scenario_of_difference(name: &str, run: &Divergence, which: Which) -> Option<String> {
    let number = usize::from(which == Which::New);
    let mut rows = given(run);
    if run.differs.is_empty() {
        if run.faults[0] == run.faults[1] {
            return None;
        }
        add_scan(&mut rows);
        let faults = std::iter::once(&false).chain(&run.faults[number]);
        let values: Vec<Value> = faults.map(|faulted| Value::Bool(*faulted)).collect();
        rows.push(row(("SYS.FAULT", Scalar::Bool), &values, true));
    }
    rows.extend(run.differs.iter().map(|tag| {
        let values = [&tag.old, &tag.new][number];
        row((&tag.name, tag.ty), values, true)
    }));
    Some(run_text(rows, run.interval, name))
}

/// The rows of a run in which two programs differ: what goes in, and of each tag that differs what both show, the old one first.
pub fn rows_of(run: &Divergence) -> Vec<String> {
    let mut rows = given(run);
    for tag in &run.differs {
        for values in [&tag.old, &tag.new] {
            rows.push(row((&tag.name, tag.ty), values, true));
        }
    }
    if rows.is_empty() {
        return Vec::new();
    }
    let text = run_text(rows, run.interval, "s");
    let mut is_new = false;
    let rows = text.lines().skip(1).map(|line| {
        if !line.contains("=>") {
            return line.to_owned();
        }
        let which = if is_new { "new" } else { "old" };
        is_new = !is_new;
        format!("{line}  ({which})")
    });
    rows.collect()
}

/// A scenario file of these scenarios, in its layout. `head` are its lines about the program and what runs beside it, `interval` is
/// in nanoseconds.
pub fn scenario_file(head: &str, interval: i64, scenarios: &[String]) -> String {
    let interval = value_text::duration(interval);
    let mut text = format!("{head}interval {interval}\n");
    for scenario in scenarios {
        text.push('\n');
        text.push_str(scenario);
    }
    scenario::layout(&text)
}
