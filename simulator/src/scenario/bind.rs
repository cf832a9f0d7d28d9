//! Scenarios with a program: names become tags, and cells values of the tags' types.

use super::error::ScenarioError;
use super::parse::{Cell, Direction, Row, Scenario, Suite};
use super::tolerance::Tolerance;
use crate::simulation::Simulation;
use crate::tags::Point;
use crate::value_text;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_analysis::with_article;
use ladder_syntax::TextRange;
use std::collections::HashSet;

/// A scenario that can be run.
#[derive(Debug, Clone, PartialEq)]
pub struct Case {
    /// What it is called.
    pub name: String,
    /// Its name in the file.
    pub range: TextRange,
    /// How many steps it has.
    pub steps: usize,
    /// How many scans a step has.
    pub scans: u64,
    pub(super) given: Vec<Given>,
    pub(super) expected: Vec<Expected>,
}

/// What is given to a tag.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Given {
    pub(super) name: String,
    pub(super) target: Target,
    /// One for each step, none where nothing is given.
    pub(super) values: Vec<Option<Value>>,
}

/// What a tag is expected to hold.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Expected {
    pub(super) name: String,
    pub(super) range: TextRange,
    pub(super) target: Target,
    /// One for each step, none where nothing is checked, with their places.
    pub(super) values: Vec<(Option<Value>, TextRange)>,
    pub(super) tolerance: Option<Tolerance>,
}

/// What a row is about.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Target {
    Point(Point),
    /// `PORT.SERIAL`: bytes that come in, or those that were sent during the step.
    Serial,
}

impl Target {
    pub(super) fn ty(&self) -> Scalar {
        match self {
            Target::Point(point) => point.ty,
            Target::Serial => Scalar::String(u16::MAX),
        }
    }
}

/// A scenario runs at most this many scans: 27 hours at 10 ms.
const MOST_SCANS: u64 = 10_000_000;

/// Binds all scenarios of a file. With errors, those of the file itself included, none of them is to be run.
pub fn bind(suite: &Suite, simulation: &Simulation) -> (Vec<Case>, Vec<ScenarioError>) {
    let mut errors = Vec::new();
    let scans = scans_of_a_step(suite, simulation.options().interval).unwrap_or_else(|error| {
        errors.push(error);
        1
    });
    let cases: Vec<Case> = suite
        .scenarios
        .iter()
        .map(|scenario| {
            Binder {
                suite,
                simulation,
                errors: &mut errors,
                rows: HashSet::new(),
            }
            .scenario(scenario, scans)
        })
        .collect();
    errors.extend(too_long(suite, &cases));
    errors.sort_by_key(|error| error.range.start());
    (cases, errors)
}

fn scans_of_a_step(suite: &Suite, interval: i64) -> Result<u64, ScenarioError> {
    let Some((step, range)) = suite.step else {
        return Ok(1);
    };
    if step % interval == 0 {
        return Ok((step / interval) as u64);
    }
    let time = |nanoseconds: i64| {
        let text = value_text::display(&Value::Int(nanoseconds), Scalar::Time);
        text.trim_start_matches("T#").to_owned()
    };
    let below = step / interval * interval;
    let near = if below == 0 { interval } else { below };
    Err(ScenarioError::new(
        range,
        format!(
            "a step is a whole number of scans, and {} is not a multiple of the scan interval {}",
            time(step),
            time(interval)
        ),
        format!(
            "write `step {}`, or give another scan interval, as in: interval 1ms",
            time(near)
        ),
    ))
}

/// The first scenario that would take too long.
fn too_long(suite: &Suite, cases: &[Case]) -> Option<ScenarioError> {
    let scans = |case: &Case| case.scans.saturating_mul(case.steps as u64);
    let case = cases.iter().find(|case| scans(case) > MOST_SCANS)?;
    let range = suite.step.map_or(case.range, |(_, range)| range);
    Some(ScenarioError::new(
        range,
        format!(
            "\"{}\" would take {} scans, and a scenario has at most {MOST_SCANS}",
            case.name,
            scans(case)
        ),
        "shorten the step, or take a longer scan interval, as in: interval 1s",
    ))
}

struct Binder<'a> {
    suite: &'a Suite,
    simulation: &'a Simulation,
    errors: &'a mut Vec<ScenarioError>,
    /// Tags that have a row, by direction.
    rows: HashSet<(Direction, String)>,
}

impl Binder<'_> {
    fn error(&mut self, range: TextRange, message: impl Into<String>, help: impl Into<String>) {
        self.errors.push(ScenarioError::new(range, message, help));
    }

    fn scenario(mut self, scenario: &Scenario, scans: u64) -> Case {
        let mut case = Case {
            name: scenario.name.clone(),
            range: scenario.range,
            steps: scenario.steps,
            scans,
            given: Vec::new(),
            expected: Vec::new(),
        };
        for row in &scenario.rows {
            let Some((name, target)) = self.target(row) else {
                continue;
            };
            let values = self.values(row, &name, target.ty());
            if !self.rows.insert((row.direction, name.clone())) {
                let way = match row.direction {
                    Direction::Given => "is given by two rows",
                    Direction::Expected => "is expected by two rows",
                };
                self.error(
                    row.range,
                    format!("{name} {way} of this scenario"),
                    "leave only one of them",
                );
            }
            let tolerance = self.tolerance(row, target.ty());
            match row.direction {
                Direction::Given => case.given.push(Given { name, target, values }),
                Direction::Expected => case.expected.push(Expected {
                    name,
                    range: row.range,
                    target,
                    values: values
                        .into_iter()
                        .zip(row.cells.iter().map(|cell| cell.1))
                        .collect(),
                    tolerance,
                }),
            }
        }
        case
    }

    fn target(&mut self, row: &Row) -> Option<(String, Target)> {
        if row.name.eq_ignore_ascii_case("PORT.SERIAL") {
            if self.simulation.has_serial() {
                return Some(("PORT.SERIAL".to_owned(), Target::Serial));
            }
            self.error(
                row.range,
                "the program does not use PORT.SERIAL",
                "the blocks USND, URCV, FMT and SCANTIME without operand do",
            );
            return None;
        }
        let point = match self.simulation.resolve(&row.name) {
            Ok(point) => point,
            Err(unknown) => {
                // A heading that is too late.
                let heading = matches!(row.name.as_str(), "program" | "step" | "interval" | "tolerance");
                self.errors.push(ScenarioError {
                    range: row.range,
                    message: unknown.message,
                    help: heading.then(|| format!("`{}` is before the first scenario", row.name)),
                });
                return None;
            }
        };
        if row.direction == Direction::Given && point.read_only {
            self.error(
                row.range,
                format!("{} can only be read", point.name),
                format!("write `{} => ...` to expect values of it", point.name),
            );
            return None;
        }
        Some((point.name.clone(), Target::Point(point)))
    }

    /// A value for each step. After an error the rest of the row is read all the same.
    fn values(&mut self, row: &Row, name: &str, ty: Scalar) -> Vec<Option<Value>> {
        let mut complained = false;
        let mut values = Vec::with_capacity(row.cells.len());
        for (cell, range) in &row.cells {
            let level = |high| (ty == Scalar::Bool).then_some(Value::Bool(high));
            let value = match cell {
                Cell::Same => None,
                Cell::Low | Cell::High => {
                    let value = level(*cell == Cell::High);
                    // One error for such a row is enough.
                    if value.is_none() && !std::mem::replace(&mut complained, true) {
                        self.error(
                            *range,
                            format!(
                                "{name} is {}: _ and - are the levels of a BOOL",
                                with_article(ty.name())
                            ),
                            "give a value for each step, with blanks between them, as in: 0 1 2",
                        );
                    }
                    value
                }
                Cell::Value(text) => match value_text::parse(text, ty) {
                    Ok(value) => Some(value),
                    Err(problem) => {
                        let (problem, help) = explain(problem, text, ty);
                        self.error(*range, problem, help);
                        None
                    }
                },
            };
            values.push(value);
        }
        values
    }

    fn tolerance(&mut self, row: &Row, ty: Scalar) -> Option<Tolerance> {
        let Some((text, range)) = &row.tolerance else {
            return self.suite.tolerance.filter(|_| ty.is_real());
        };
        if row.direction == Direction::Given {
            self.error(
                *range,
                "what is given has no tolerance",
                "± is in rows with an arrow",
            );
            return None;
        }
        if !Tolerance::is_for(ty) {
            let problem = format!(
                "values of {} are equal or not: they have no tolerance",
                with_article(ty.name())
            );
            self.error(*range, problem, "take the ± away");
            return None;
        }
        match Tolerance::parse(text, ty) {
            Ok(tolerance) => Some(tolerance),
            Err(problem) => {
                self.error(
                    *range,
                    problem,
                    "the tolerance is last in the row, as in: level => 1.0 2.0 ± 0.01",
                );
                None
            }
        }
    }
}

/// A reader of values says `what is wrong: what to do`.
fn explain(problem: String, text: &str, ty: Scalar) -> (String, String) {
    let wave = text.chars().filter(|c| matches!(c, '_' | '-' | '.')).count();
    if ty == Scalar::Bool && wave > 0 {
        return (
            format!("`{text}` is not a waveform"),
            "its letters are _ low, - high and . as before".to_owned(),
        );
    }
    match problem.split_once(": ") {
        Some((what, help)) => (what.to_owned(), help.to_owned()),
        None => (problem, format!("write a value of type {}", ty.name())),
    }
}
