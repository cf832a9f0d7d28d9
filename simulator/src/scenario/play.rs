//! A scenario played step by step, for those who look into it while it runs.

use super::bind::{Case, Give, Target};
use super::run::is_met;
use crate::session::Session;
use crate::simulation::{Simulation, Status};
use crate::value_text;
use ladder_analysis::values::value::Value;
use ladder_syntax::TextRange;

/// An expectation that is not met.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unmet {
    /// The tag.
    pub tag: String,
    /// Where the value is that was expected.
    pub range: TextRange,
    /// What is wrong, in words.
    pub message: String,
}

impl Case {
    /// The step whose first scan this is; none if it is within a step, or after the last.
    pub fn step_before(&self, scan: u64) -> Option<usize> {
        let step = self.steps.at(scan);
        (self.steps.begin(step) == scan && scan < self.scans()).then_some(step)
    }

    /// The step whose last scan was the one before this; none if it is within a step.
    pub fn step_after(&self, scan: u64) -> Option<usize> {
        let step = self.steps.at(scan.checked_sub(1)?);
        (self.steps.begin(step + 1) == scan).then_some(step)
    }

    /// Provides what is before a step.
    pub fn give(&self, step: usize, session: &mut Session) {
        for row in &self.given {
            match (&row.target, row.values.get(step)) {
                (Target::Point(point), Some(Some(Give::Value(value)))) => {
                    // What could be refused was found when the row was read.
                    let _ = session.set(point, value.clone());
                }
                (Target::Point(point), Some(Some(Give::Back))) => session.unforce(point),
                (Target::Serial, Some(Some(Give::Value(Value::Text(bytes))))) => session.feed_serial(bytes),
                _ => {}
            }
        }
    }

    /// Where the first value of a step is, or the scenario's name.
    pub fn place_of(&self, step: usize) -> TextRange {
        let values = self.expected.iter().find_map(|row| row.values.get(step));
        values.map_or(self.range, |(_, place)| *place)
    }

    /// What is not as expected at the end of a step; `sent` is what the program sent through the serial port
    /// meanwhile.
    pub fn unmet(&self, step: usize, simulation: &Simulation, sent: &[u8]) -> Vec<Unmet> {
        let stopped = simulation.status() == Status::Faulted;
        let has_power = simulation.had_power();
        let mut unmet = Vec::new();
        for row in self.expected.iter().filter(|row| has_power || row.is_of_plant) {
            let Some((Some(wanted), range)) = row.values.get(step) else {
                continue;
            };
            let got = match &row.target {
                // A scan that would follow would see it.
                Target::Point(point) if stopped && point.name == "SYS.FAULT" => Some(Value::Bool(true)),
                _ if stopped => None,
                Target::Point(point) => Some(simulation.value(point)),
                Target::Serial => Some(Value::Text(sent.into())),
            };
            if got.as_ref().is_some_and(|got| is_met(row, wanted, got)) {
                continue;
            }
            let shown = |value: &Value| value_text::display(value, row.target.ty());
            let got = got
                .as_ref()
                .map_or("nothing, for a fault stopped the program".to_owned(), shown);
            unmet.push(Unmet {
                tag: row.name.clone(),
                range: *range,
                message: format!("{} is {got}, expected {}", row.name, shown(wanted)),
            });
        }
        unmet
    }
}
