//! What outputs do in a session that is played again, as little of it as a scenario needs: first when they change, and once
//! it is known where columns end, what they hold there.

use crate::simulation::Simulation;
use crate::tags::Point;
use ladder_analysis::program::Role;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use std::collections::BTreeSet;

/// With more rows than this only outputs are drawn.
const MOST_ROWS: usize = 8;

/// So many columns can be read: a tag that changes more often has none for each of its changes.
const READABLE: usize = 200;

/// What one point did.
#[derive(Debug)]
pub(super) struct Track {
    pub(super) point: Point,
    cold: Value,
    last: Value,
    /// The scans after which it held something else than before, up to as many as can be read.
    changes: Vec<u64>,
    /// What it held at the end of each column.
    pub(super) held: Vec<Value>,
}

impl Track {
    fn is_output(&self) -> bool {
        self.point.role == Role::Output
    }

    fn rests(&self) -> bool {
        self.held.iter().all(|held| *held == self.cold)
    }
}

/// What the tracks are of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Choice {
    /// The outputs, and a few other BOOLs that change; where there are none, whatever changes.
    Usual,
    /// A person chose them.
    Chosen,
}

/// What was played so far.
#[derive(Debug)]
pub(super) struct Played {
    pub(super) tracks: Vec<Track>,
    choice: Choice,
    /// Only outputs have columns for their changes.
    has_outputs: bool,
}

impl Played {
    /// Nothing yet.
    pub(super) fn new(simulation: &Simulation, points: Vec<Point>, choice: Choice) -> Played {
        let tracks = points.into_iter().map(|point| Track {
            cold: simulation.value(&point),
            last: simulation.value(&point),
            point,
            changes: Vec::new(),
            held: Vec::new(),
        });
        let mut tracks: Vec<Track> = tracks.collect();
        let has_outputs = choice == Choice::Usual && tracks.iter().any(Track::is_output);
        if has_outputs {
            tracks.retain(|track| track.is_output() || track.point.ty == Scalar::Bool);
        }
        Played {
            tracks,
            choice,
            has_outputs,
        }
    }

    /// Notes what changes with a scan, which was just run.
    pub(super) fn note(&mut self, simulation: &Simulation, scan: u64) {
        for track in &mut self.tracks {
            let counts = !self.has_outputs || track.is_output();
            if !counts || track.changes.len() > READABLE {
                continue;
            }
            let value = simulation.value(&track.point);
            if track.last != value {
                track.last = value;
                track.changes.push(scan);
            }
        }
    }

    /// The scans before which columns begin: those before which something is given, and those that change what is expected.
    /// Where these are too many, tags that change often are left out.
    pub(super) fn begins(&self, given: &BTreeSet<u64>) -> BTreeSet<u64> {
        let mut begins = given.clone();
        begins.insert(0);
        let mut tracks: Vec<&Track> = self.tracks.iter().collect();
        tracks.sort_by_key(|track| track.changes.len());
        for track in tracks {
            let mut more = begins.clone();
            more.extend(track.changes.iter().copied());
            if track.changes.len() > READABLE || more.len() > READABLE.max(begins.len()) {
                break;
            }
            begins = more;
        }
        begins
    }

    /// Notes what is held at the end of a column.
    pub(super) fn hold(&mut self, simulation: &Simulation) {
        for track in &mut self.tracks {
            track.held.push(simulation.value(&track.point));
        }
    }

    /// Next to the outputs only a few other tags are drawn, and of those only BOOLs that change: when there are too many of
    /// them, none is.
    pub(super) fn leave_out_what_rests(&mut self) {
        if self.choice == Choice::Chosen {
            return;
        }
        if !self.has_outputs {
            if !self.tracks.iter().all(Track::rests) {
                self.tracks.retain(|track| !track.rests());
            }
            return;
        }
        self.tracks.retain(|track| track.is_output() || !track.rests());
        if self.tracks.len() > MOST_ROWS {
            self.tracks.retain(Track::is_output);
        }
    }
}
