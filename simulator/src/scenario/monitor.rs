//! Properties with a program: their expressions become values of its tags, and a run is watched for what violates them.

use super::error::ScenarioError;
use super::property::{Form, Written};
use super::suite::Suite;
use crate::expression::Expression;
use crate::simulation::Simulation;
use crate::tags::Point;
use ladder_analysis::values::value::Value;
use ladder_syntax::TextRange;

/// The properties of a file, and what is assumed for them.
#[derive(Debug, Default)]
pub struct Watched {
    /// What goes into the program has this in every scan.
    pub assumptions: Vec<Expression>,
    /// In the order of the file.
    pub properties: Vec<Monitor>,
}

/// A property that is watched in a run.
#[derive(Debug)]
pub struct Monitor {
    /// What it is called.
    pub name: String,
    /// Where its name is.
    pub range: TextRange,
    /// What must hold.
    pub form: Form<Expression>,
    interval: i64,
    pending: Pending,
    /// See [`Monitor::faulted`].
    faulted: bool,
}

/// What a property waits for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
struct Pending {
    /// The condition was high in the scan before.
    armed: bool,
    /// For how many scans the earliest unanswered one waits.
    waits: Option<u64>,
}

/// What properties and assumptions know of the scans before: who goes back in a run puts back what they knew there.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Memory {
    pending: Vec<Pending>,
    before: Vec<Option<Value>>,
}

/// Binds the properties of a file. With errors, those of the file itself included, none of them is to be watched.
pub fn bind_properties(suite: &Suite, simulation: &Simulation) -> (Watched, Vec<ScenarioError>) {
    let mut errors = Vec::new();
    let mut expression = |written: &Written| {
        let found = Expression::condition(&written.text, simulation);
        found.map_err(|message| {
            errors.push(ScenarioError {
                range: written.range,
                message,
                help: None,
            });
        })
    };
    let assumptions = suite.assumptions.iter().flat_map(&mut expression).collect();
    let mut properties = Vec::new();
    for property in &suite.properties {
        if let Ok(form) = property.form.try_map(&mut expression) {
            properties.push(Monitor {
                name: property.name.clone(),
                range: property.range,
                form,
                interval: simulation.options().interval,
                pending: Pending::default(),
                faulted: false,
            });
        }
    }
    let watched = Watched {
        assumptions,
        properties,
    };
    (watched, errors)
}

impl Watched {
    /// Watches from a cold start.
    pub fn restart(&mut self) {
        self.assumptions.iter_mut().for_each(Expression::forget);
        self.properties.iter_mut().for_each(Monitor::restart);
    }

    /// What is known of the scans before.
    pub fn memory(&mut self) -> Memory {
        let mut before = Vec::new();
        self.for_each_before(&mut |it| before.push(it.clone()));
        Memory {
            pending: self.properties.iter().map(|property| property.pending).collect(),
            before,
        }
    }

    /// Knows of the scans before what it knew when this was taken.
    pub fn remember(&mut self, memory: &Memory) {
        for (property, pending) in self.properties.iter_mut().zip(&memory.pending) {
            property.pending = *pending;
        }
        let mut before = memory.before.iter();
        self.for_each_before(&mut |it| *it = before.next().cloned().flatten());
    }

    fn for_each_before(&mut self, each: &mut dyn FnMut(&mut Option<Value>)) {
        for assumption in &mut self.assumptions {
            assumption.for_each_before(each);
        }
        for property in &mut self.properties {
            property.for_each(&mut |expression| expression.for_each_before(each));
        }
    }

    /// The first assumption that a scan does not keep, in the order of the file. To be asked once after each scan.
    pub fn broken_assumption(&mut self, simulation: &Simulation) -> Option<usize> {
        let mut broken = None;
        for (n, assumption) in self.assumptions.iter_mut().enumerate() {
            if !assumption.holds(simulation).unwrap_or(false) && broken.is_none() {
                broken = Some(n);
            }
        }
        broken
    }
}

impl Monitor {
    /// The tags that it names.
    pub fn points(&self) -> Vec<Point> {
        let mut points: Vec<Point> = Vec::new();
        let mut add = |expression: &Expression| {
            expression.for_each_point(&mut |point| {
                if !points.iter().any(|known| known.name == point.name) {
                    points.push(point.clone());
                }
            });
            Ok::<(), ()>(())
        };
        let _: Result<Form<()>, ()> = self.form.try_map(&mut add);
        points
    }

    /// Watches from a cold start.
    pub fn restart(&mut self) {
        self.pending = Pending::default();
        self.for_each(&mut |expression| expression.forget());
    }

    fn for_each(&mut self, each: &mut dyn FnMut(&mut Expression)) {
        match &mut self.form {
            Form::Always(e) | Form::Never(e) | Form::Possible { what: e, .. } => each(e),
            Form::When {
                condition,
                then,
                until,
            } => {
                each(condition);
                each(then);
                until.as_mut().map(each);
            }
            Form::After { condition, then } | Form::Within { condition, then, .. } => {
                each(condition);
                each(then);
            }
            Form::NoFaults => {}
        }
    }

    /// Looks at what is there after a scan; returns whether that violates the property, and of one that is to be possible
    /// whether it is so. `faulted`: a block has recorded a fault in this scan.
    pub fn violates(&mut self, simulation: &Simulation, faulted: bool) -> bool {
        // A fault in an expression makes it FALSE.
        let mut fault = false;
        let mut holds = |expression: &mut Expression| {
            let holds = expression.holds(simulation);
            fault |= holds.is_err();
            holds.unwrap_or(false)
        };
        let violates = match &mut self.form {
            Form::Always(e) => !holds(e),
            Form::Never(e) | Form::Possible { what: e, .. } => holds(e),
            Form::When {
                condition,
                then,
                until,
            } => {
                let (condition, then) = (holds(condition), holds(then));
                let active = match until {
                    None => condition,
                    Some(until) => {
                        let ends = holds(until);
                        self.pending.armed = (self.pending.armed || condition) && !ends;
                        self.pending.armed
                    }
                };
                active && !then
            }
            Form::After { condition, then } => {
                let (condition, then) = (holds(condition), holds(then));
                std::mem::replace(&mut self.pending.armed, condition) && !then
            }
            Form::Within {
                span,
                condition,
                then,
            } => {
                let (condition, then) = (holds(condition), holds(then));
                let most = span.scans(self.interval);
                self.pending.waits = match self.pending.waits {
                    _ if then => None,
                    Some(scans) => Some(scans + 1),
                    None if condition => Some(0),
                    None => None,
                };
                self.pending.waits.is_some_and(|scans| scans >= most)
            }
            Form::NoFaults => faulted,
        };
        self.faulted = fault;
        violates
    }

    /// Whether a fault happened in one of its expressions after the last scan.
    pub const fn faulted(&self) -> bool {
        self.faulted
    }
}
