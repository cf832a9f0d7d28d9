//! A run as a scenario: what goes in, and what came of it. It passes as it is, and becomes a test of the repaired program when
//! what came is replaced by what is to come.

use crate::replay::Shown;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_simulator::{Point, scenario, value_text};
use std::fmt::Write;

/// A scenario of this name, one column a scan.
pub fn scenario_of(name: &str, shown: &Shown, is_about_faults: bool) -> String {
    let name: String = name.chars().filter(|c| *c != '"' && !c.is_control()).collect();
    let mut text = format!("scenario \"{name}\"\n");
    // SYS.FAULT shows the fault one scan later.
    let later = usize::from(is_about_faults);
    let mut rows = 0;
    for (point, values) in &shown.given {
        let last = values.last().cloned();
        let values: Vec<Value> = values
            .iter()
            .cloned()
            .chain(last.into_iter().take(later))
            .collect();
        row(&mut text, point, "", &values);
    }
    if is_about_faults {
        let before = ".".repeat(shown.scans());
        let _ = writeln!(text, "SYS.FAULT => {before}-");
        return text;
    }
    for (point, values) in &shown.seen {
        row(&mut text, point, "=> ", values);
        rows += 1;
    }
    if rows == 0 {
        // A scenario expects something.
        match shown.given.first() {
            Some((point, values)) => row(&mut text, point, "=> ", values),
            None => {
                let _ = writeln!(text, "SYS.ON => {}", "-".repeat(shown.scans()));
            }
        }
    }
    text
}

fn row(text: &mut String, point: &Point, arrow: &str, values: &[Value]) {
    let cells: Vec<String> = values
        .iter()
        .map(|value| match value {
            Value::Bool(high) => String::from(if *high { "-" } else { "_" }),
            value => value_text::display(value, point.ty),
        })
        .collect();
    let between = if point.ty == Scalar::Bool { "" } else { " " };
    let _ = writeln!(text, "{} {arrow}{}", point.name, cells.join(between));
}

/// A scenario file of these scenarios, in its layout.
pub fn scenario_file(program: &str, interval: i64, scenarios: &[String]) -> String {
    let mut text = format!("program {program}\ninterval {}\n", value_text::duration(interval));
    for scenario in scenarios {
        text.push('\n');
        text.push_str(scenario);
    }
    scenario::layout(&text)
}
