//! What the watched tags held, scan by scan: the stuff that waveforms are drawn from.

use ladder_analysis::value::Value;
use ladder_simulator::Point;
use std::collections::VecDeque;

/// So many scans are remembered of each tag: eleven minutes of scans that are 10 ms apart.
const MOST: usize = 1 << 16;

/// The watched tags with their past.
#[derive(Debug, Clone, Default)]
pub(super) struct Record {
    tracks: Vec<Track>,
}

/// One watched tag.
#[derive(Debug, Clone)]
pub(super) struct Track {
    pub(super) point: Point,
    /// One for each scan, the newest last; a text has none.
    samples: VecDeque<f64>,
}

/// The least and the greatest of some scans, and the last.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bucket {
    pub(super) least: f64,
    pub(super) greatest: f64,
    pub(super) last: f64,
}

impl Record {
    /// The watched tags, in the order in which they were added.
    pub(super) fn tracks(&self) -> &[Track] {
        &self.tracks
    }

    /// Whether a tag is watched.
    pub(super) fn watches(&self, point: &Point) -> bool {
        self.tracks.iter().any(|track| track.point.name == point.name)
    }

    /// Watches a tag, with what is known of its past.
    pub(super) fn add(&mut self, point: Point, past: &[Value]) {
        if self.watches(&point) {
            return;
        }
        self.tracks.push(Track {
            point,
            samples: past.iter().map(sample).collect(),
        });
    }

    /// Watches a tag no more.
    pub(super) fn remove(&mut self, point: &Point) {
        self.tracks.retain(|track| track.point.name != point.name);
    }

    /// Goes on with another program: a tag that it does not have is watched no more.
    pub(super) fn rebind(&mut self, find: impl Fn(&Point) -> Option<Point>) {
        self.tracks.retain_mut(|track| match find(&track.point) {
            Some(point) => {
                track.point = point;
                true
            }
            None => false,
        });
    }

    /// A scan has been run.
    pub(super) fn take(&mut self, value: impl Fn(&Point) -> Value) {
        for track in &mut self.tracks {
            if track.samples.len() == MOST {
                track.samples.pop_front();
            }
            track.samples.push_back(sample(&value(&track.point)));
        }
    }

    /// Some scans were taken back.
    pub(super) fn take_back(&mut self, scans: usize) {
        for track in &mut self.tracks {
            track.samples.truncate(track.samples.len().saturating_sub(scans));
        }
    }

    /// The program begins again.
    pub(super) fn clear(&mut self) {
        for track in &mut self.tracks {
            track.samples.clear();
        }
    }
}

impl Track {
    /// The newest scans in `count` buckets of `scans` each, the oldest first; none where nothing is known. Buckets
    /// begin at whole multiples of their length, so that the picture does not flicker while it moves. `now` is
    /// how many scans have been run.
    pub(super) fn buckets(&self, count: usize, scans: u64, now: u64) -> Vec<Option<Bucket>> {
        let first = now - (self.samples.len() as u64).min(now);
        let newest = now.saturating_sub(1) / scans;
        (0..count as u64)
            .rev()
            .map(|back| {
                let bucket = newest.checked_sub(back)?;
                let range = (bucket * scans).max(first)..((bucket + 1) * scans).min(now);
                if range.is_empty() {
                    return None;
                }
                let range = (range.start - first) as usize..(range.end - first) as usize;
                let mut found: Option<Bucket> = None;
                for &value in self.samples.range(range) {
                    let bucket = found.get_or_insert(Bucket {
                        least: value,
                        greatest: value,
                        last: value,
                    });
                    bucket.least = bucket.least.min(value);
                    bucket.greatest = bucket.greatest.max(value);
                    bucket.last = value;
                }
                found
            })
            .collect()
    }
}

fn sample(value: &Value) -> f64 {
    match value {
        Value::Bool(high) => f64::from(u8::from(*high)),
        Value::Int(number) => *number as f64,
        Value::Real(real) => *real,
        Value::Text(_) => 0.0,
    }
}
