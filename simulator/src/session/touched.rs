//! When each cell has changed last since the history began, roughly: of all others it is known at once that they have not,
//! and of those that changed before the kept scans that these need not be gone over.

use crate::memory::Memory;
use crate::tags::{Point, PointSlot};
use std::ops::Range;

/// So many scans have one mark.
const SPAN: i64 = 256;

/// A mark for each cell of the memory of tags: 0 if it has never changed.
#[derive(Debug)]
pub(super) struct Touched {
    bits: Vec<u32>,
    words: Vec<u32>,
    texts: Vec<u32>,
    /// The mark of what changes now.
    now: u32,
}

/// The mark of a scan.
fn mark_of(scan: i64) -> u32 {
    u32::try_from(scan / SPAN + 1).unwrap_or(u32::MAX)
}

impl Touched {
    /// Nothing was touched yet.
    pub(super) fn nothing(memory: &Memory) -> Touched {
        Touched {
            bits: vec![0; memory.bits.len()],
            words: vec![0; memory.words.len()],
            texts: vec![0; memory.texts.len()],
            now: mark_of(0),
        }
    }

    /// What is marked from here on has changed in this scan, or the one before it.
    pub(super) fn is_at(&mut self, scan: i64) {
        self.now = mark_of(scan);
    }

    pub(super) fn mark_bits(&mut self, run: Range<usize>) {
        self.bits[run].fill(self.now);
    }

    pub(super) fn mark_words(&mut self, run: Range<usize>) {
        self.words[run].fill(self.now);
    }

    pub(super) fn mark_text(&mut self, at: usize) {
        self.texts[at] = self.now;
    }

    /// Whether what a point shows may have changed.
    pub(super) fn holds(&self, point: &Point) -> bool {
        self.last(point) > 0
    }

    /// Whether what a point shows may have changed in this scan or behind it.
    pub(super) fn holds_since(&self, point: &Point, scan: i64) -> bool {
        self.last(point) >= mark_of(scan)
    }

    fn last(&self, point: &Point) -> u32 {
        match point.slot {
            PointSlot::Bit(slot) => self.bits[slot.0 as usize],
            PointSlot::Word(slot) | PointSlot::BitOf { word: slot, .. } => self.words[slot.0 as usize],
            PointSlot::Text(slot) => self.texts[slot.0 as usize],
            PointSlot::Timing { input, done } => self.bits[input.0 as usize].max(self.bits[done.0 as usize]),
        }
    }
}
