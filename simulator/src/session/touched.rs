//! When each cell has changed last since the history began, roughly: of all others it is known at once that they have not,
//! and of those that changed before the kept scans that these need not be gone over.

use crate::memory::Memory;
use crate::tags::{Point, PointSlot};
use std::ops::Range;

/// This many scans have one mark.
pub(super) const SPAN: i64 = 256;

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

    /// What is marked from here on has changed in this scan.
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

    /// Whether what a point shows may have changed in this scan or after it.
    pub(super) fn holds_since(&self, point: &Point, scan: i64) -> bool {
        self.last(point) >= mark_of(scan)
    }

    /// What has the mark of now: what has changed in the scans that have it, and maybe what had in those that took place
    /// instead before a step back.
    pub(super) fn in_this_span(&self) -> Cells {
        let cells = |marks: &[u32]| Set::of(marks.iter().map(|mark| *mark == self.now));
        Cells {
            bits: cells(&self.bits),
            words: cells(&self.words),
            texts: cells(&self.texts),
        }
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

/// Some cells of the memory of tags.
#[derive(Debug)]
pub(super) struct Cells {
    bits: Set,
    words: Set,
    texts: Set,
}

impl Cells {
    /// Whether what a point shows is among them.
    pub(super) fn hold(&self, point: &Point) -> bool {
        match point.slot {
            PointSlot::Bit(slot) => self.bits.has(slot.0),
            PointSlot::Word(slot) | PointSlot::BitOf { word: slot, .. } => self.words.has(slot.0),
            PointSlot::Text(slot) => self.texts.has(slot.0),
            PointSlot::Timing { input, done } => self.bits.has(input.0) || self.bits.has(done.0),
        }
    }

    /// How many bytes they take.
    pub(super) fn size(&self) -> usize {
        [&self.bits, &self.words, &self.texts]
            .iter()
            .map(|set| set.0.len())
            .sum()
    }
}

/// A bit for each cell of a bank.
#[derive(Debug)]
struct Set(Box<[u8]>);

impl Set {
    fn of(cells: impl ExactSizeIterator<Item = bool>) -> Set {
        let mut bytes = vec![0; cells.len().div_ceil(8)];
        for (at, is_in) in cells.enumerate() {
            bytes[at / 8] |= u8::from(is_in) << (at % 8);
        }
        Set(bytes.into())
    }

    fn has(&self, cell: u32) -> bool {
        self.0[cell as usize / 8] >> (cell % 8) & 1 != 0
    }
}
