//! What outputs held after each scan of a session that is played again, as little of it as a scenario needs: changes, and of
//! those no more than its columns can show.

use crate::simulation::Simulation;
use crate::tags::Point;
use ladder_analysis::program::Role;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use std::collections::BTreeSet;

/// With more rows than this only outputs are drawn.
const MOST_ROWS: usize = 8;

/// This many columns can be read; with more a step takes no account of what the outputs do in between.
const READABLE: u64 = 200;

/// What one point held.
#[derive(Debug)]
pub(super) struct Track {
    pub(super) point: Point,
    cold: Value,
    /// From which scan on, the earliest first.
    changes: Vec<(u64, Value)>,
    /// Of what was given, and of these changes, all moments are a multiple of this many scans.
    moments: u64,
}

impl Track {
    fn last(&self) -> &Value {
        self.changes.last().map_or(&self.cold, |(_, value)| value)
    }

    /// What it held after scans, the earliest first.
    pub(super) fn at(&self, scans: impl Iterator<Item = u64>) -> impl Iterator<Item = &Value> {
        let mut next = 0;
        scans.map(move |scan| {
            while self.changes.get(next).is_some_and(|(from, _)| *from <= scan) {
                next += 1;
            }
            next.checked_sub(1)
                .map_or(&self.cold, |last| &self.changes[last].1)
        })
    }

    fn is_output(&self) -> bool {
        self.point.role == Role::Output
    }

    fn is_level(&self) -> bool {
        !self.is_output() && self.point.ty == Scalar::Bool
    }
}

/// What was played so far.
#[derive(Debug)]
pub(super) struct Played {
    /// How many scans.
    pub(super) scans: u64,
    pub(super) tracks: Vec<Track>,
    /// How many there are to play.
    whole: u64,
    /// Of what was given all moments are a multiple of this many scans.
    of_given: u64,
    /// There are too many columns for what the outputs do in between.
    is_coarse: bool,
}

impl Played {
    /// Nothing yet. `given` are the scans before which something will be given.
    pub(super) fn new(
        simulation: &Simulation,
        points: Vec<Point>,
        given: &BTreeSet<u64>,
        scans: u64,
    ) -> Played {
        let of_given = given.iter().fold(scans, |step, &moment| divisor(step, moment));
        let tracks = points.into_iter().map(|point| Track {
            cold: simulation.value(&point),
            point,
            changes: Vec::new(),
            moments: of_given,
        });
        let mut tracks: Vec<Track> = tracks.collect();
        if tracks.iter().any(Track::is_output) {
            tracks.retain(|track| track.is_output() || track.is_level());
        }
        Played {
            scans: 0,
            tracks,
            whole: scans,
            of_given,
            is_coarse: false,
        }
    }

    /// Notes what a simulation holds after its next scan.
    pub(super) fn note(&mut self, simulation: &Simulation) {
        let scan = self.scans;
        self.scans += 1;
        if !self.is_noted(scan) {
            return;
        }
        let mut has_changed = false;
        for track in &mut self.tracks {
            let value = simulation.value(&track.point);
            if *track.last() != value {
                has_changed = true;
                track.changes.push((scan, value));
                if scan > 0 {
                    track.moments = divisor(track.moments, scan);
                }
            }
        }
        if has_changed {
            self.leave_out_too_many();
            self.is_coarse |= self.whole / self.exact() > READABLE;
        }
    }

    /// Whether what was held after a scan is known. Once there are too many columns for what the outputs do in between,
    /// only the ends of columns are.
    pub(super) fn is_noted(&self, scan: u64) -> bool {
        !self.is_coarse || (scan + 1).is_multiple_of(self.of_given)
    }

    /// How many scans a column stands for: as many as all that happens is a multiple of.
    pub(super) fn step(&self) -> u64 {
        if self.is_coarse {
            self.of_given
        } else {
            divisor(self.exact(), self.scans)
        }
    }

    fn exact(&self) -> u64 {
        let moments = self.tracks.iter().map(|track| track.moments);
        moments.fold(self.of_given, divisor)
    }

    /// Next to the outputs only a few other tags are drawn: when there are too many of those that change, none is.
    fn leave_out_too_many(&mut self) {
        let outputs = self.tracks.iter().filter(|track| track.is_output()).count();
        let levels = self
            .tracks
            .iter()
            .filter(|track| track.is_level() && !track.changes.is_empty());
        if outputs > 0 && outputs + levels.count() > MOST_ROWS {
            self.tracks.retain(Track::is_output);
        }
    }

    /// Next to the outputs only those are drawn that change: BOOLs, or whatever there is where nothing else comes out of
    /// the program.
    pub(super) fn leave_out_what_rests(&mut self) {
        let has_outputs = self.tracks.iter().any(Track::is_output);
        let rests = self.tracks.iter().all(|track| track.changes.is_empty());
        self.tracks.retain(|track| {
            let changes = !track.changes.is_empty();
            track.is_output()
                || (has_outputs && changes && track.is_level())
                || (!has_outputs && (changes || rests))
        });
    }
}

pub(super) fn divisor(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { divisor(b, a % b) }
}
