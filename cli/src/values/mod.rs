//! The values of a table, as those of a program's tags.

mod table;

use crate::outcome::Failure;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_simulator::{Point, Simulation, value_text};
use ladder_workspace::shown;
use std::collections::HashMap;
use std::path::Path;
use table::Row;

/// What a table says of a program.
pub(crate) struct Given {
    /// The tags that it has, with their values.
    pub(crate) values: Vec<(Point, Value)>,
    /// Names that the program does not have, with their lines.
    pub(crate) unknown: Vec<(u64, String)>,
    /// Constants of the program that have another value in the table.
    pub(crate) constants: Vec<String>,
}

impl Given {
    /// Reads a table.
    ///
    /// # Errors
    /// It cannot be read, a value is none of its tag's type, or a tag has two.
    pub(crate) fn read(file: &Path, simulation: &Simulation) -> Result<Given, Failure> {
        let text = ladder_workspace::read(file)?;
        let failed = |line: u64, message: &str| {
            let message = format!("{}: line {line}: {message}", shown::path(file));
            Failure::new(message)
        };
        let separator = ladder_simulator::separator(&text);
        let rows = table::parse(&text).map_err(|broken| failed(broken.line, &broken.message))?;
        let mut given = Given {
            values: Vec::new(),
            unknown: Vec::new(),
            constants: Vec::new(),
        };
        let mut lines: HashMap<String, (u64, Value)> = HashMap::new();
        for Row { line, name, value } in rows {
            let Ok(point) = simulation.resolve(&name) else {
                given.unknown.push((line, name));
                continue;
            };
            if NOTHING.contains(&value.as_str()) {
                continue;
            }
            let value = value_of(&value, point.ty, separator).map_err(|problem| failed(line, &problem))?;
            if let Some((first, other)) = lines.get(&point.name) {
                if *other != value {
                    return Err(failed(
                        line,
                        &format!("`{name}` has another value in line {first}"),
                    ));
                }
                continue;
            }
            lines.insert(point.name.clone(), (line, value.clone()));
            if !point.read_only {
                given.values.push((point, value));
            } else if simulation.value(&point) != value && !name.contains('.') {
                let own = value_text::display(&simulation.value(&point), point.ty);
                let table = value_text::display(&value, point.ty);
                given
                    .constants
                    .push(format!("{} is {own}, not {table} (line {line})", point.name));
            }
        }
        let bits = lines.iter().filter_map(|(name, bit)| {
            let point = simulation.resolve(name).ok()?;
            let (number, at) = point.bit_of()?;
            let (first, Value::Int(whole)) = lines.get(number)? else {
                return None;
            };
            let is_other = Value::Bool(whole >> at & 1 != 0) != bit.1;
            is_other.then_some((bit.0, name, number.to_owned(), *first))
        });
        match bits.min() {
            Some((line, name, number, first)) => Err(failed(
                line,
                &format!("`{name}` has another value in `{number}` of line {first}"),
            )),
            None => Ok(given),
        }
    }
}

/// What is in the place of a value that could not be read.
const NOTHING: [&str; 6] = ["?", "??", "???", "-", "--", "---"];

/// The words of switches.
const HIGH: [&str; 4] = ["on", "high", "yes", "set"];
const LOW: [&str; 4] = ["off", "low", "no", "reset"];

/// A value as controllers write it: `ON`, a duration as a number of milliseconds too, a number with a comma or with a unit.
fn value_of(text: &str, ty: Scalar, separator: char) -> Result<Value, String> {
    let is_one = |words: &[&str]| words.iter().any(|word| text.eq_ignore_ascii_case(word));
    if ty == Scalar::Bool && (is_one(&HIGH) || is_one(&LOW)) {
        return Ok(Value::Bool(is_one(&HIGH)));
    }
    if ty == Scalar::Time
        && let Ok(milliseconds) = text.parse::<i64>()
    {
        let nanoseconds = milliseconds.checked_mul(1_000_000).map(Value::Int);
        return nanoseconds.ok_or_else(|| format!("`{text}` milliseconds are more than a TIME holds"));
    }
    let wrong = match value_text::parse(text, ty) {
        Ok(value) => return Ok(value),
        Err(wrong) => wrong,
    };
    let number = if ty.is_real() || ty.is_integer() {
        without_unit(text)
    } else {
        text
    };
    value_text::parse(&ladder_simulator::with_point(number, ty, separator), ty).map_err(|_| wrong)
}

/// The number of `7 mm` or `12,5%`.
fn without_unit(text: &str) -> &str {
    let is_part = |c: char| c.is_ascii_digit() || matches!(c, '.' | ',' | '-' | '+' | '_');
    match text.split_once(char::is_whitespace) {
        Some((number, _)) => number,
        None => text.trim_end_matches(|c: char| !is_part(c)),
    }
}
