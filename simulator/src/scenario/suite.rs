//! What a scenario file says, before anything is known of the program.

use super::error::ScenarioError;
use super::property::{Property, Written};
use super::tolerance::Tolerance;
use ladder_syntax::TextRange;

/// A scenario file.
#[derive(Debug, Clone, PartialEq)]
pub struct Suite {
    /// The program, as it is named, seen from the file's own folder.
    pub program: Option<(String, TextRange)>,
    /// The models of its machine that run beside it, in their order.
    pub plants: Vec<PlantLine>,
    /// What is connected though the names differ.
    pub connects: Vec<ConnectLine>,
    /// How long a step is, in nanoseconds. Without it a step is one scan.
    pub step: Option<(i64, TextRange)>,
    /// The time from one scan to the next, in nanoseconds.
    pub interval: Option<(i64, TextRange)>,
    /// For all reals that are expected, where a row does not have its own.
    pub tolerance: Option<Tolerance>,
    /// In the order of the file.
    pub scenarios: Vec<Scenario>,
    /// What is assumed of everything that goes into the program.
    pub assumptions: Vec<Written>,
    /// What must hold in every run, in the order of the file.
    pub properties: Vec<Property>,
    /// What could not be read.
    pub errors: Vec<ScenarioError>,
}

impl Suite {
    /// Both sides of each connection.
    pub fn connections(&self) -> Vec<(String, String)> {
        let sides = self.connects.iter().map(|connect| &connect.sides);
        sides
            .map(|[one, other]| (one.text.clone(), other.text.clone()))
            .collect()
    }
}

/// A line `plant`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PlantLine {
    /// Its file, as it is named, seen from the scenario file's own folder.
    pub file: String,
    /// Where that is.
    pub range: TextRange,
    /// What is before the names of its tags.
    pub name: String,
}

/// A line `connect`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ConnectLine {
    /// What is on both sides of `=`; one is a tag of a plant.
    pub sides: [Written; 2],
    /// All after `connect`.
    pub range: TextRange,
}

/// What the tags of a plant have before their names that has none of its own.
pub const PLANT: &str = "plant";

/// Both tags of a connection, which is written as `plant.sensor_1 = near`. None: a side is missing.
pub fn connected(text: &str) -> Option<(&str, &str)> {
    let (one, other) = text.split_once('=')?;
    let sides = (one.trim(), other.trim());
    (!sides.0.is_empty() && !sides.1.is_empty()).then_some(sides)
}

/// The file of a plant and what it is called, where they are written as `tank.clad as tank`.
pub fn plant_named(text: &str) -> (&str, &str) {
    let is_name = |name: &str| name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    let (file, name) = match text.rsplit_once(" as ") {
        Some((file, name)) if is_name(name.trim()) => (file, name.trim()),
        _ => (text, PLANT),
    };
    (file.trim().trim_matches('"'), name)
}

/// One scenario.
#[derive(Debug, Clone, PartialEq)]
pub struct Scenario {
    /// What it is called.
    pub name: String,
    /// Its name, with the quotes.
    pub range: TextRange,
    /// How many steps it has.
    pub steps: usize,
    /// Its rows, in the order of the file.
    pub rows: Vec<Row>,
    /// Its rows `time`, in the order of the file. With the second the steps go on below those of the rows above.
    pub times: Vec<TimeRow>,
}

impl Scenario {
    /// How long a step is, in nanoseconds, where a row `time` says it.
    pub fn time_of(&self, step: usize) -> Option<i64> {
        let row = self.times.iter().rev().find(|row| row.first <= step)?;
        row.cells.get(step - row.first)?.0
    }
}

/// A row `time`: how long each of the steps below it is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TimeRow {
    /// The word `time`.
    pub range: TextRange,
    /// The step of its first cell.
    pub first: usize,
    /// In nanoseconds, with its place; none for a dot, which is a step as the file has them. 0 where no duration is written.
    pub cells: Vec<(Option<i64>, TextRange)>,
}

/// A row: a tag, and a cell for each step.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// The tag as it is written.
    pub name: String,
    /// Where that is.
    pub range: TextRange,
    /// Whether it goes in or is expected to come out.
    pub direction: Direction,
    /// The step of its first cell.
    pub first: usize,
    /// One for each step, with its place.
    pub cells: Vec<(Cell, TextRange)>,
    /// What is after `±`.
    pub tolerance: Option<(String, TextRange)>,
}

/// Which way a row goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Direction {
    /// Into the program.
    Given,
    /// `=>`: out of it.
    Expected,
}

/// What a row has for a step.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Cell {
    /// `_`
    Low,
    /// `-`
    High,
    /// `.`: as before; not checked.
    Same,
    /// `~`: what the plant says.
    Plant,
    /// Anything else: a value as it is written.
    Value(String),
}
