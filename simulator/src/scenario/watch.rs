//! A scenario's run, watched for the properties that it violates.

use super::monitor::{Monitor, Watched};
use super::property::Form;
use crate::simulation::Simulation;
use crate::tags::Point;
use ladder_analysis::values::value::Value;
use ladder_syntax::TextRange;

/// A property that a run violates.
#[derive(Debug, Clone, PartialEq)]
pub struct Violation {
    /// What the property is called.
    pub name: String,
    /// Where its name is.
    pub range: TextRange,
    /// The first scan that violates it, from 0.
    pub scan: u64,
    /// How many scans violate it.
    pub scans: u64,
    /// The steps with such a scan, from 0, in their order.
    pub steps: Vec<usize>,
    /// The tags that it names, with what each was in each step.
    pub(super) seen: Vec<(Point, Vec<Value>)>,
}

/// An assumption that a run does not keep: from there on nothing was promised, and nothing is watched.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Outside {
    /// Which assumption, in the order of the file.
    pub assumption: usize,
    /// The scan that does not keep it, from 0.
    pub scan: u64,
}

/// What has been seen of a run.
pub(super) struct Watch<'w> {
    watched: &'w mut Watched,
    tracks: Vec<Track>,
    pub(super) outside: Option<Outside>,
}

/// What has been seen of a property.
struct Track {
    points: Vec<Point>,
    /// For each step: what the tags were in the first scan of it that violates the property, else in its last.
    values: Vec<Vec<Value>>,
    /// The scan and the number of all that violate it.
    violated: Option<(u64, u64)>,
    steps: Vec<usize>,
}

impl<'w> Watch<'w> {
    /// From a cold start.
    pub(super) fn new(watched: &'w mut Watched) -> Watch<'w> {
        watched.restart();
        let track = |monitor: &Monitor| Track {
            points: monitor.points(),
            values: Vec::new(),
            violated: None,
            steps: Vec::new(),
        };
        Watch {
            tracks: watched.properties.iter().map(track).collect(),
            watched,
            outside: None,
        }
    }

    /// Looks at what a scan of a step has left. `faulted`: a block has recorded a fault in it.
    pub(super) fn scan(&mut self, simulation: &Simulation, step: usize, faulted: bool) {
        let scan = simulation.scans().saturating_sub(1);
        if self.outside.is_some() {
            return;
        }
        if !simulation.had_power() {
            // It begins again when the power comes back.
            return self.watched.restart();
        }
        self.outside =
            (self.watched.broken_assumption(simulation)).map(|assumption| Outside { assumption, scan });
        if self.outside.is_some() {
            return;
        }
        for (monitor, track) in self.watched.properties.iter_mut().zip(&mut self.tracks) {
            let is_found = monitor.violates(simulation, faulted);
            // What is to be possible somewhere need not be so here.
            if !is_found || matches!(monitor.form, Form::Possible { .. }) {
                continue;
            }
            track.violated.get_or_insert((scan, 0)).1 += 1;
            if track.steps.last() != Some(&step) {
                track.steps.push(step);
                track.note(simulation);
            }
        }
    }

    /// Notes what the tags are at the end of a step.
    pub(super) fn step(&mut self, simulation: &Simulation, step: usize) {
        for track in &mut self.tracks {
            if track.values.len() <= step {
                track.note(simulation);
            }
        }
    }

    /// The properties that were violated.
    pub(super) fn violations(self) -> Vec<Violation> {
        let tracks = self.tracks.into_iter().zip(&self.watched.properties);
        let violated = tracks.filter_map(|(track, monitor)| {
            let (scan, scans) = track.violated?;
            let column = |n: usize| track.values.iter().map(|values| values[n].clone()).collect();
            let seen = track.points.iter().enumerate();
            Some(Violation {
                name: monitor.name.clone(),
                range: monitor.range,
                scan,
                scans,
                seen: seen.map(|(n, point)| (point.clone(), column(n))).collect(),
                steps: track.steps,
            })
        });
        violated.collect()
    }
}

impl Track {
    fn note(&mut self, simulation: &Simulation) {
        self.values
            .push(self.points.iter().map(|point| simulation.value(point)).collect());
    }
}
