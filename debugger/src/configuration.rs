//! The configuration of a launch, as the client sends it.

use std::path::Path;

use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_simulator::value_text;
use serde::Deserialize;
use serde_json::{Map, Value as Json};

/// The configuration.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub(crate) struct Configuration {
    /// The program, or a file of scenarios.
    pub program: Option<String>,
    /// The scenario to run; without it the first of its file.
    pub scenario: Option<String>,
    /// Or the one that this line of the file belongs to, counted from 1.
    pub scenario_line: Option<u32>,
    /// The file of it; without it the one next to the program, of its name.
    pub scenario_file: Option<String>,
    /// The text of that file, in the place of what is on disk: a run that a proof has found.
    pub scenario_text: Option<String>,
    pub inputs: GivenInputs,
    /// What tags are held at.
    pub forces: Map<String, Json>,
    /// The file that keeps retentive tags.
    pub retain: Option<String>,
    /// The time from one scan to the next: `10ms`, or a number of milliseconds.
    pub cycle: Option<Json>,
    pub speed: Option<Speed>,
    pub stop_on_entry: bool,
    /// How many scans can be stepped back.
    pub history: Option<u64>,
    /// What a step back goes back by.
    pub step_back: Option<BackBy>,
    /// Breakpoints do not stop it.
    pub no_debug: bool,
}

/// What the world outside gives.
#[derive(Debug, Clone, Deserialize)]
#[serde(untagged)]
pub(crate) enum GivenInputs {
    /// A table in CSV with the values that tags are set to before each scan.
    Table(String),
    /// What tags hold from the first scan on.
    Held(Map<String, Json>),
}

impl Default for GivenInputs {
    fn default() -> GivenInputs {
        GivenInputs::Held(Map::new())
    }
}

/// How fast a run goes.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(untagged)]
pub(crate) enum Speed {
    /// How many times as fast as real time.
    Times(f64),
    Named(NamedSpeed),
}

#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum NamedSpeed {
    /// As fast as it goes.
    Max,
}

/// What a step back goes back by.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum BackBy {
    Block,
    #[default]
    Rung,
    Scan,
}

/// How fast a run may be.
const SPEEDS: std::ops::RangeInclusive<f64> = 0.001..=1000.0;

/// The longest time between two scans, in milliseconds: a day.
const LONGEST: f64 = 86_400_000.0;

impl Configuration {
    /// How many times as fast as real time; none for as fast as it goes.
    pub(crate) fn speed(&self) -> Result<Option<f64>, String> {
        match self.speed {
            Some(Speed::Named(NamedSpeed::Max)) => Ok(None),
            None if self.scenario_asked_for() => Ok(None),
            None => Ok(Some(1.0)),
            Some(Speed::Times(times)) if SPEEDS.contains(&times) => Ok(Some(times)),
            Some(Speed::Times(times)) => Err(format!(
                "speed is {times}: it is \"max\" or from 0.001 to 1000 times real time"
            )),
        }
    }

    /// Whether a scenario is to be run.
    pub(crate) fn scenario_asked_for(&self) -> bool {
        let is_file = self.program.as_deref().is_some_and(is_scenario_file);
        is_file || self.scenario.is_some() || self.scenario_line.is_some() || self.scenario_file.is_some()
    }

    /// The time from one scan to the next, in nanoseconds.
    pub(crate) fn interval(&self) -> Result<Option<i64>, String> {
        let wrong = || {
            "cycle: write the time from one scan to the next, such as \"10ms\", or milliseconds".to_owned()
        };
        let nanoseconds = match &self.cycle {
            None | Some(Json::Null) => return Ok(None),
            Some(Json::String(text)) => match value_text::parse(text, Scalar::Time) {
                Ok(Value::Int(nanoseconds)) => nanoseconds,
                Ok(_) => return Err(wrong()),
                Err(problem) => return Err(format!("cycle: {problem}")),
            },
            Some(number) => {
                let milliseconds = number.as_f64().ok_or_else(wrong)?;
                if !(1e-6..=LONGEST).contains(&milliseconds) {
                    return Err("cycle: it is more than 0 and at most a day".into());
                }
                (milliseconds * 1e6).round() as i64
            }
        };
        if nanoseconds > 0 {
            Ok(Some(nanoseconds))
        } else {
            Err("cycle: the time from one scan to the next must be longer than 0".into())
        }
    }
}

pub(crate) fn is_scenario_file(name: &str) -> bool {
    ladder_workspace::is_scenario(Path::new(name))
}
