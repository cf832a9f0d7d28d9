//! One running program in the words of the messages: the place where the server meets the scan engine.

use std::sync::Arc;
use std::time::Duration;

use ladder_analysis::program::Role;
use ladder_analysis::value::Value;
use ladder_analysis::{Diagnostic, NotWhole, Severity};
use ladder_simulator::{Point, Simulation, Status};
use ladder_syntax::TextRange;
use serde_json::Value as Json;

use super::messages;
use super::request::Failure;
use super::value::{from_json, to_json};
use crate::document::Revision;
use crate::document::position::Range;

/// So many faults are reported: those that happened last.
const FAULTS: usize = 100;

/// The interval that may be asked for, in milliseconds: from a nanosecond to a day.
const INTERVAL: std::ops::RangeInclusive<f64> = 1e-6..=86_400_000.0;

/// A program that runs.
#[derive(Debug)]
pub(super) struct Engine {
    revision: Arc<Revision>,
    simulation: Simulation,
    /// What inputs hold from the first scan on.
    inputs: Vec<(Point, Value)>,
    /// Where the elements of the drawing stand, in the order in which the engine lists their power. Computed
    /// once, for the text that runs does not change.
    places: Vec<Range>,
    /// The newest last. A mistake that repeats in one place stands here once, with the scan it last happened in.
    faults: Vec<messages::Fault>,
}

impl Engine {
    /// The program of a text, before its first scan. Analyses and compiles: for a blocking thread.
    pub(super) fn start(revision: Arc<Revision>, options: &messages::Options) -> Result<Self, Failure> {
        let Some(analysis) = revision.analysis() else {
            return Err(Failure::Failed("the file is too large to be simulated".into()));
        };
        let program = match revision.program() {
            Some(Ok(program)) => program,
            Some(Err(NotWhole::Errors(file))) if *file != *analysis.whole().name => {
                return Err(Failure::Failed(format!(
                    "there are errors in {file}, which the program uses"
                )));
            }
            Some(Err(NotWhole::Missing(file))) => {
                return Err(Failure::Failed(format!(
                    "{file}, which the program uses, cannot be read"
                )));
            }
            _ => return Err(has_errors(&revision, analysis.diagnostics())),
        };
        let simulation = Simulation::new(program, engine_options(options)?)
            .map_err(|error| Failure::Failed(error.to_string()))?;
        let inputs = options.inputs.iter();
        let inputs = inputs
            .map(|(tag, value)| assignment(&simulation, tag, value))
            .collect::<Result<_, _>>()?;
        let places = power(&simulation)
            .map(|(place, _)| revision.range(place))
            .collect();
        let mut engine = Engine {
            revision,
            simulation,
            inputs,
            places,
            faults: Vec::new(),
        };
        engine.set_inputs()?;
        Ok(engine)
    }

    /// The text that runs.
    pub(super) fn revision(&self) -> &Revision {
        &self.revision
    }

    /// Runs one scan, unless the program has come to its end.
    pub(super) fn scan(&mut self) -> Status {
        self.simulation.scan();
        self.simulation.status()
    }

    /// Gives a tag a value.
    pub(super) fn set(&mut self, tag: &str, value: &Json) -> Result<(), Failure> {
        let (point, value) = assignment(&self.simulation, tag, value)?;
        self.simulation
            .set(&point, value)
            .map_err(|error| Failure::Failed(error.to_string()))
    }

    /// Holds a tag at a value.
    pub(super) fn force(&mut self, tag: &str, value: &Json) -> Result<(), Failure> {
        let (point, value) = assignment(&self.simulation, tag, value)?;
        self.simulation
            .force(&point, value)
            .map_err(|error| Failure::Failed(error.to_string()))
    }

    /// Lets a tag go, or all of them.
    pub(super) fn unforce(&mut self, tag: Option<&str>) -> Result<(), Failure> {
        match tag {
            Some(tag) => self.simulation.unforce(&point(&self.simulation, tag)?),
            None => self.simulation.unforce_all(),
        }
        Ok(())
    }

    /// Begins again from cold: as it was started. Forces stay.
    pub(super) fn reset(&mut self) -> Result<(), Failure> {
        self.simulation.reset();
        self.simulation.take_faults();
        self.faults.clear();
        self.set_inputs()
    }

    fn set_inputs(&mut self) -> Result<(), Failure> {
        for (point, value) in &self.inputs {
            let set = self.simulation.set(point, value.clone());
            set.map_err(|error| Failure::Failed(error.to_string()))?;
        }
        Ok(())
    }

    /// The time from one scan to the next.
    pub(super) fn interval(&self) -> Duration {
        Duration::from_nanos(self.simulation.options().interval.unsigned_abs())
    }

    /// How many scans are done.
    pub(super) fn scans(&self) -> u64 {
        self.simulation.scans()
    }

    /// The simulation's clock, in milliseconds.
    pub(super) fn time_ms(&self) -> f64 {
        self.simulation.time() as f64 / 1e6
    }

    /// Every scalar tag, then what else is forced (an element of an array, a bit of a word).
    pub(super) fn tags(&self) -> Vec<messages::Tag> {
        let points = self.simulation.points();
        let others = self.simulation.forced().filter(|forced| !points.contains(forced));
        points.iter().chain(others).map(|point| self.tag(point)).collect()
    }

    fn tag(&self, point: &Point) -> messages::Tag {
        messages::Tag {
            name: point.name.clone(),
            kind: point.ty.to_string(),
            value: to_json(&self.simulation.value(point), point.ty),
            role: match point.role {
                Role::Input => messages::Role::Input,
                Role::Output => messages::Role::Output,
                Role::Internal => messages::Role::Internal,
            },
            forced: self.simulation.is_forced(point),
        }
    }

    /// Every element of the drawing, with its power in the last scan.
    pub(super) fn power(&self) -> Vec<messages::Power> {
        let live = power(&self.simulation).map(|(_, on)| on);
        self.places
            .iter()
            .zip(live)
            .map(|(&range, on)| messages::Power { range, on })
            .collect()
    }

    /// What went wrong so far.
    pub(super) fn faults(&mut self) -> Vec<messages::Fault> {
        for fault in self.simulation.take_faults() {
            let program = self.simulation.program();
            let elsewhere = match fault.location.file {
                0 => None,
                file => {
                    let name = &program.files[file as usize];
                    self.revision.range_elsewhere(name, fault.location.range)
                }
            };
            let (uri, range) = match elsewhere {
                Some((uri, range)) => (Some(uri), range),
                None => (None, self.revision.range(fault.location.range)),
            };
            self.faults
                .retain(|old| old.range != range || old.message != fault.message || old.uri != uri);
            self.faults.push(messages::Fault {
                message: fault.message,
                uri,
                range,
                scan: fault.scan,
            });
        }
        self.faults.drain(..self.faults.len().saturating_sub(FAULTS));
        self.faults.clone()
    }
}

/// The elements that stand in the program's own file, which is the document.
fn power(simulation: &Simulation) -> impl Iterator<Item = (TextRange, bool)> {
    let own = simulation.power().filter(|(_, location, _)| location.file == 0);
    own.map(|(_, location, on)| (location.range, on))
}

fn point(simulation: &Simulation, tag: &str) -> Result<Point, Failure> {
    simulation
        .resolve(tag)
        .map_err(|error| Failure::Failed(error.to_string()))
}

fn assignment(simulation: &Simulation, tag: &str, value: &Json) -> Result<(Point, Value), Failure> {
    let point = point(simulation, tag)?;
    let value = from_json(value, point.ty)
        .map_err(|problem| Failure::Invalid(format!("{}: {problem}", point.name)))?;
    Ok((point, value))
}

fn engine_options(options: &messages::Options) -> Result<ladder_simulator::Options, Failure> {
    let mut engine = ladder_simulator::Options::default();
    if let Some(milliseconds) = options.interval_ms {
        if !INTERVAL.contains(&milliseconds) {
            return Err(Failure::Invalid(format!(
                "intervalMs is {milliseconds}; it must be more than 0 and at most a day (86400000)"
            )));
        }
        engine.interval = (milliseconds * 1e6).round() as i64;
    }
    if let Some(blocks) = options.watchdog {
        if blocks == 0 {
            return Err(Failure::Invalid(
                "watchdog is 0; it must let at least one block be evaluated".into(),
            ));
        }
        engine.watchdog = blocks;
    }
    Ok(engine)
}

/// Why a program with errors is not simulated: the first of them, and how many there are.
fn has_errors(revision: &Revision, found: &[Diagnostic]) -> Failure {
    let errors: Vec<_> = found
        .iter()
        .filter(|found| found.severity == Severity::Error)
        .collect();
    let Some(first) = errors.first() else {
        return Failure::Failed("the program cannot be simulated".into());
    };
    let line = revision.range(first.range).start.line + 1;
    let count = match errors.len() {
        1 => "an error".into(),
        more => format!("{more} errors, the first"),
    };
    Failure::Failed(format!(
        "the program has {count} in line {line}: {}",
        first.message
    ))
}
