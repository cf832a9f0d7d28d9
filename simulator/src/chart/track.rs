//! What one tag held, scan by scan.

use super::{Tick, scale};
use crate::tags::Point;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use std::cell::Cell;
use std::collections::VecDeque;

/// This many changes of a tag are kept: of one that changes in every scan those of eleven minutes at 10 ms.
const MOST_CHANGES: usize = 1 << 16;

/// A text takes the place of a change for this many of its bytes.
const BYTES_OF_CHANGE: usize = 32;

/// How a tag is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// High and low.
    Bit,
    /// As a line over a scale.
    Number,
    /// As words in a band: texts and dates.
    Text,
}

/// A value, and the scan from which on it held.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Change {
    pub(super) scan: u64,
    pub(super) value: Value,
}

/// A tag with its past. Only changes are kept, so that what stays the same takes no room.
#[derive(Debug)]
pub struct Track {
    /// The tag.
    pub point: Point,
    /// The first of them is where the record begins.
    changes: VecDeque<Change>,
    /// How much room the changes take.
    cost: usize,
    /// The least and the greatest number of all, if that is known.
    range: Cell<Option<(f64, f64)>>,
}

impl Track {
    /// A tag of which nothing is known.
    pub(super) fn new(point: Point) -> Track {
        Track {
            point,
            changes: VecDeque::new(),
            cost: 0,
            range: Cell::new(None),
        }
    }

    /// How it is drawn.
    pub fn kind(&self) -> Kind {
        match self.point.ty {
            Scalar::Bool => Kind::Bit,
            ty if ty.is_date() || ty.is_string() => Kind::Text,
            _ => Kind::Number,
        }
    }

    /// The first scan that is known.
    pub fn first(&self) -> Option<u64> {
        self.changes.front().map(|change| change.scan)
    }

    /// What the tag held when this many scans were done; none where that is not known. What it held last holds for all scans
    /// after it.
    pub fn at(&self, scan: u64) -> Option<&Value> {
        let after = self.changes_until(scan);
        let last = after.checked_sub(1)?;
        self.change(last).map(|change| &change.value)
    }

    /// A value as a number that can be drawn: TIME in milliseconds. None if it is not one.
    pub(crate) fn number(&self, value: &Value) -> Option<f64> {
        let number = match (value, self.point.ty) {
            (Value::Int(number), Scalar::Ulint | Scalar::Lword) => *number as u64 as f64,
            (Value::Int(nanoseconds), Scalar::Time) => *nanoseconds as f64 / 1e6,
            (Value::Int(number), _) => *number as f64,
            (Value::Real(real), _) => *real,
            (Value::Bool(_) | Value::Text(_), _) => return None,
        };
        number.is_finite().then_some(number)
    }

    /// The least and the greatest of all numbers that are kept; none if there is no number.
    pub fn range(&self) -> Option<(f64, f64)> {
        if self.range.get().is_none() {
            let numbers = self
                .changes
                .iter()
                .filter_map(|change| self.number(&change.value));
            let range = numbers.fold(None, |range: Option<(f64, f64)>, it| match range {
                Some((least, greatest)) => Some((least.min(it), greatest.max(it))),
                None => Some((it, it)),
            });
            self.range.set(range);
        }
        self.range.get()
    }

    /// Ticks of the scale that it is drawn over, at most this many and one more.
    pub fn ticks(&self, most: u64) -> Vec<Tick> {
        match (self.kind(), self.range()) {
            (Kind::Number, Some((least, greatest))) => scale::ticks(least, greatest, most, self.point.ty),
            _ => Vec::new(),
        }
    }

    /// How many changes there are up to a scan.
    pub(super) fn changes_until(&self, scan: u64) -> usize {
        self.changes.partition_point(|change| change.scan <= scan)
    }

    pub(super) fn change(&self, at: usize) -> Option<&Change> {
        self.changes.get(at)
    }

    /// The next scan has been run: this is what the tag holds.
    pub(super) fn push(&mut self, scan: u64, value: Value) {
        if self.changes.back().is_some_and(|last| last.value == value) {
            return;
        }
        if let (Some((least, greatest)), Some(number)) = (self.range.get(), self.number(&value)) {
            self.range.set(Some((least.min(number), greatest.max(number))));
        }
        self.cost += cost(&value);
        self.changes.push_back(Change { scan, value });
        while self.cost > MOST_CHANGES && self.changes.len() > 1 {
            if let Some(oldest) = self.changes.pop_front() {
                self.forget(&oldest.value);
            }
        }
    }

    /// What happened after this many scans no longer holds.
    pub(super) fn truncate(&mut self, scans: u64) {
        let kept = self.changes_until(scans);
        while self.changes.len() > kept {
            if let Some(last) = self.changes.pop_back() {
                self.forget(&last.value);
            }
        }
    }

    /// Nothing is known any more.
    pub(super) fn clear(&mut self) {
        *self = Track::new(self.point.clone());
    }

    fn forget(&mut self, value: &Value) {
        self.cost -= cost(value);
        let number = self.number(value);
        let is_inside = |(least, greatest): (f64, f64)| number.is_none_or(|it| least < it && it < greatest);
        if !self.range.get().is_some_and(is_inside) {
            self.range.set(None);
        }
    }
}

fn cost(value: &Value) -> usize {
    match value {
        Value::Text(bytes) => 1 + bytes.len() / BYTES_OF_CHANGE,
        _ => 1,
    }
}
