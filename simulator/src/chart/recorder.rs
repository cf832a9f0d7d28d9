//! Chosen tags with their past, as far as that is known.

use super::track::Track;
use crate::session::Session;
use crate::tags::Point;

/// Records what tags held, scan by scan.
#[derive(Debug, Default)]
pub struct Recorder {
    tracks: Vec<Track>,
    /// The newest scan that is recorded, stepped back from or not.
    newest: u64,
    /// How often what was recorded turned out not to be so.
    revision: u64,
    /// The program whose points the tracks have.
    generation: u64,
}

impl Recorder {
    /// The tags, in the order in which they were asked for.
    pub fn tracks(&self) -> &[Track] {
        &self.tracks
    }

    /// The newest scan that is recorded.
    #[cfg(test)]
    pub(super) fn newest(&self) -> u64 {
        self.newest
    }

    /// A number that changes whenever something that was recorded is not so any more: after a restart, or when something
    /// else happened in the past.
    pub fn revision(&self) -> u64 {
        self.revision
    }

    /// Records these tags from now on, and no others. Of new ones the history shows the past.
    pub fn watch(&mut self, points: Vec<Point>, session: &Session) {
        self.look(session);
        if self.tracks.is_empty() {
            self.newest = newest(session);
            self.generation = session.generation();
        }
        let mut known = std::mem::take(&mut self.tracks);
        let mut tracks = Vec::new();
        let mut fresh = Vec::new();
        for point in points {
            let same = |track: &Track| track.point.name == point.name && track.point.ty == point.ty;
            match known.iter().position(same) {
                Some(at) => tracks.push(known.swap_remove(at)),
                None => {
                    fresh.push((tracks.len(), point.clone()));
                    tracks.push(Track::new(point));
                }
            }
        }
        self.tracks = tracks;
        self.fill(&fresh, session);
    }

    /// Observes a session in which something may have happened. Each scan that came to its end must be observed, or else
    /// what is recorded starts again with what the history knows.
    pub fn look(&mut self, session: &Session) {
        if self.tracks.is_empty() {
            return;
        }
        self.follow(session);
        let end = newest(session);
        if end < self.newest {
            self.newest = end;
            self.revision += 1;
            for track in &mut self.tracks {
                track.truncate(end);
            }
        }
        if end == self.newest {
            return;
        }
        let simulation = session.simulation();
        if end == self.newest + 1 && simulation.scans() == end && !simulation.is_open() {
            self.newest = end;
            self.take(end, session);
            return;
        }
        self.begin_again(session);
    }

    /// What the tags held when this scan, the last one, was done.
    fn take(&mut self, scan: u64, session: &Session) {
        if !session.is_given() {
            for track in &mut self.tracks {
                track.push(scan, session.simulation().value(&track.point));
            }
            return;
        }
        // What was given within the scan holds already.
        let points: Vec<Point> = self.tracks.iter().map(|track| track.point.clone()).collect();
        for (track, mut values) in self.tracks.iter_mut().zip(session.past(&points, 1)) {
            if let Some(value) = values.pop() {
                track.push(scan, value);
            }
        }
    }

    /// Another program runs: its tags are found by name, also by one that was changed, and type.
    fn follow(&mut self, session: &Session) {
        if self.generation == session.generation() {
            return;
        }
        self.generation = session.generation();
        let count = self.tracks.len();
        self.tracks.retain_mut(|track| {
            let found = session.find(&track.point.name).ok();
            let found = found.filter(|point| point.ty == track.point.ty);
            found.is_some_and(|point| {
                track.point = point;
                true
            })
        });
        self.revision += u64::from(self.tracks.len() < count);
    }

    fn begin_again(&mut self, session: &Session) {
        self.newest = newest(session);
        self.revision += 1;
        let all = self.tracks.iter_mut().enumerate().map(|(at, track)| {
            track.clear();
            (at, track.point.clone())
        });
        let all: Vec<_> = all.collect();
        self.fill(&all, session);
    }

    /// What the history knows of tracks that are empty.
    fn fill(&mut self, fresh: &[(usize, Point)], session: &Session) {
        if fresh.is_empty() {
            return;
        }
        let points: Vec<Point> = fresh.iter().map(|(_, point)| point.clone()).collect();
        let here = session.simulation().scans();
        let past = session.past(&points, usize::MAX);
        let future = session.future(&points);
        for ((at, _), (past, future)) in fresh.iter().zip(past.into_iter().zip(future)) {
            let track = &mut self.tracks[*at];
            let first = (here + 1).saturating_sub(past.len() as u64);
            let all = past.into_iter().chain(future);
            for (scan, value) in (first..).zip(all) {
                track.push(scan, value);
            }
        }
    }
}

/// The newest scan that was run, stepped back from or not.
fn newest(session: &Session) -> u64 {
    session.simulation().scans() + session.scans_ahead() as u64
}
