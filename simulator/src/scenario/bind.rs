//! Scenarios with a program: names become tags, and cells values of the tags' types.

use super::error::ScenarioError;
use super::parse::HEADINGS;
use super::steps::Steps;
use super::suite::{Cell, Direction, Row, Scenario, Suite};
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
    pub(super) steps: Steps,
    pub(super) given: Vec<Given>,
    pub(super) expected: Vec<Expected>,
}

impl Case {
    /// How many steps it has.
    pub const fn steps(&self) -> usize {
        self.steps.count()
    }

    /// How many scans it has.
    pub fn scans(&self) -> u64 {
        self.steps.begin(self.steps.count())
    }

    /// How many scans there are up to the end of a step, from 0.
    pub fn scans_to(&self, step: usize) -> u64 {
        self.steps.begin(step + 1)
    }

    /// The step that a scan belongs to, from 0; the last one for those after it.
    pub fn step_at(&self, scan: u64) -> usize {
        self.steps.at(scan)
    }
}

/// What is given to a tag.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Given {
    pub(super) name: String,
    pub(super) target: Target,
    /// One for each step, none where nothing is given.
    pub(super) values: Vec<Option<Give>>,
}

/// What is given before a step.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Give {
    Value(Value),
    /// `~`: the plant gives it again.
    Back,
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
    /// It is of a plant: compared also while the controller has no power.
    pub(super) is_of_plant: bool,
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
pub(super) const MOST_SCANS: u64 = 10_000_000;

/// Binds all scenarios of a file. With errors, those of the file itself included, none of them is to be run.
pub fn bind(suite: &Suite, simulation: &Simulation) -> (Vec<Case>, Vec<ScenarioError>) {
    let mut errors = Vec::new();
    let interval = simulation.options().interval;
    let scans = match suite.step {
        Some((step, range)) => whole_scans(step, interval, range).unwrap_or_else(|error| {
            errors.push(error);
            1
        }),
        None => 1,
    };
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

/// How many scans a step of this length has.
fn whole_scans(step: i64, interval: i64, range: TextRange) -> Result<u64, ScenarioError> {
    if step % interval == 0 {
        return Ok((step / interval) as u64);
    }
    let below = step / interval * interval;
    let near = if below == 0 { interval } else { below };
    Err(ScenarioError::new(
        range,
        format!(
            "a step is a whole number of scans, and {} is not a multiple of the scan interval {}",
            value_text::duration(step),
            value_text::duration(interval)
        ),
        format!(
            "write `step {}`, or give another scan interval, as in: interval 1ms",
            value_text::duration(near)
        ),
    ))
}

/// The first scenario that would take too long.
fn too_long(suite: &Suite, cases: &[Case]) -> Option<ScenarioError> {
    let case = cases.iter().find(|case| case.scans() > MOST_SCANS)?;
    let range = match (&case.steps, suite.step) {
        (Steps::Even { .. }, Some((_, range))) => range,
        _ => case.range,
    };
    Some(ScenarioError::new(
        range,
        format!(
            "\"{}\" would take {} scans, and a scenario has at most {MOST_SCANS}",
            case.name,
            case.scans()
        ),
        "shorten the step, or take a longer scan interval, as in: interval 1s",
    ))
}

struct Binder<'a> {
    suite: &'a Suite,
    simulation: &'a Simulation,
    errors: &'a mut Vec<ScenarioError>,
    /// Tags that have a row, by direction and the step with which it begins.
    rows: HashSet<(Direction, String, usize)>,
}

impl Binder<'_> {
    fn error(&mut self, range: TextRange, message: impl Into<String>, help: impl Into<String>) {
        self.errors.push(ScenarioError::new(range, message, help));
    }

    fn scenario(mut self, scenario: &Scenario, scans: u64) -> Case {
        let mut case = Case {
            name: scenario.name.clone(),
            range: scenario.range,
            steps: self.steps(scenario, scans),
            given: Vec::new(),
            expected: Vec::new(),
        };
        let count = case.steps.count();
        for row in &scenario.rows {
            let Some((name, target)) = self.target(row) else {
                continue;
            };
            let values = self.values(row, &name, target.ty());
            if !self.rows.insert((row.direction, name.clone(), row.first)) {
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
                Direction::Given => {
                    let known = case.given.iter().position(|given| given.name == name);
                    let at = known.unwrap_or_else(|| {
                        case.given.push(Given {
                            name,
                            target,
                            values: Vec::new(),
                        });
                        case.given.len() - 1
                    });
                    put(&mut case.given[at].values, row.first, values, None);
                }
                Direction::Expected => {
                    let values = self.without_plant(row, values);
                    let is_of_plant = self.simulation.program().plant_of(&name).is_some();
                    let known = case.expected.iter().position(|expected| expected.name == name);
                    let at = known.unwrap_or_else(|| {
                        case.expected.push(Expected {
                            name,
                            range: row.range,
                            target,
                            values: Vec::new(),
                            tolerance,
                            is_of_plant,
                        });
                        case.expected.len() - 1
                    });
                    if let Some((_, range)) = &row.tolerance
                        && case.expected[at].tolerance != tolerance
                    {
                        let problem = format!("{} has another tolerance above", row.name);
                        self.error(
                            *range,
                            problem,
                            "a tag has one tolerance in a scenario: write it in its first row",
                        );
                    }
                    let places = row.cells.iter().map(|cell| cell.1);
                    let cells = values.into_iter().zip(places).collect();
                    put(&mut case.expected[at].values, row.first, cells, (None, row.range));
                }
            }
        }
        // Tags whose rows end before the last step stay as they are, and are not checked any more.
        for given in &mut case.given {
            given.values.resize(count, None);
        }
        for expected in &mut case.expected {
            let last = expected.values.last().map_or(expected.range, |(_, range)| *range);
            expected.values.resize(count, (None, last));
        }
        case
    }

    /// How long the steps of a scenario are.
    fn steps(&mut self, scenario: &Scenario, scans: u64) -> Steps {
        if scenario.times.is_empty() {
            return Steps::Even {
                count: scenario.steps,
                scans,
            };
        }
        let interval = self.simulation.options().interval;
        let cells = scenario.times.iter().flat_map(|time| &time.cells);
        let lengths: Vec<u64> = cells
            .map(|(time, range)| match time {
                None => scans,
                Some(time) => whole_scans(*time, interval, *range).unwrap_or_else(|mut error| {
                    error.help = error.help.map(|help| help.replace("`step ", "`"));
                    self.errors.push(error);
                    1
                }),
            })
            .collect();
        // Rows above the first of them, and those that are too long, have steps as the file has them.
        let first = scenario.times.first().map_or(0, |time| time.first);
        let before = std::iter::repeat_n(scans, first);
        let missing = scenario.steps.saturating_sub(first + lengths.len());
        let after = std::iter::repeat_n(scans, missing);
        Steps::of_lengths(before.chain(lengths).chain(after), scans)
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
                let heading = HEADINGS.contains(&row.name.as_str());
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

    /// What is expected in each step; a plant gives nothing back there.
    fn without_plant(&mut self, row: &Row, values: Vec<Option<Give>>) -> Vec<Option<Value>> {
        if let Some((_, range)) = row.cells.iter().find(|(cell, _)| *cell == Cell::Plant) {
            let message = "`~` is for what is given: it gives an input back to the plant";
            self.error(*range, message, "write . where nothing is checked");
        }
        let values = values.into_iter().map(|value| match value {
            Some(Give::Value(value)) => Some(value),
            Some(Give::Back) | None => None,
        });
        values.collect()
    }

    /// Whether a plant drives what a row gives.
    fn is_driven(&self, row: &Row) -> bool {
        let point = self.simulation.resolve(&row.name);
        point.is_ok_and(|point| self.simulation.is_driven(&point))
    }

    /// A value for each step. After an error the rest of the row is read all the same.
    fn values(&mut self, row: &Row, name: &str, ty: Scalar) -> Vec<Option<Give>> {
        let mut complained = false;
        let mut values = Vec::with_capacity(row.cells.len());
        for (cell, range) in &row.cells {
            let level = |high| (ty == Scalar::Bool).then_some(Value::Bool(high));
            let value = match cell {
                Cell::Same => None,
                Cell::Plant => {
                    let is_wrong = row.direction == Direction::Given && !self.is_driven(row);
                    if is_wrong && !std::mem::replace(&mut complained, true) {
                        self.error(
                            *range,
                            format!("no plant drives {name}: `~` gives an input back to the plant"),
                            "write . where the tag stays as it is; `plant` and `connect` in the head of the file say what drives what",
                        );
                    }
                    values.push(Some(Give::Back));
                    continue;
                }
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
            values.push(value.map(Give::Value));
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

/// The values of a row among those of its tag: from this step on.
fn put<T: Clone>(all: &mut Vec<T>, first: usize, values: Vec<T>, nothing: T) {
    all.resize(first.max(all.len()), nothing);
    all.truncate(first);
    all.extend(values);
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
