//! Which cells have changed at all since the history began: of all others it is known at once that they have not.

use crate::memory::Memory;
use crate::tags::{Point, PointSlot};
use std::ops::Range;

/// A mark for each cell of the memory of tags.
#[derive(Debug)]
pub(super) struct Touched {
    bits: Vec<bool>,
    words: Vec<bool>,
    texts: Vec<bool>,
}

impl Touched {
    /// Nothing was touched yet.
    pub(super) fn nothing(memory: &Memory) -> Touched {
        Touched {
            bits: vec![false; memory.bits.len()],
            words: vec![false; memory.words.len()],
            texts: vec![false; memory.texts.len()],
        }
    }

    pub(super) fn mark_bits(&mut self, run: Range<usize>) {
        self.bits[run].fill(true);
    }

    pub(super) fn mark_words(&mut self, run: Range<usize>) {
        self.words[run].fill(true);
    }

    pub(super) fn mark_text(&mut self, at: usize) {
        self.texts[at] = true;
    }

    /// Whether what a point shows may have changed.
    pub(super) fn holds(&self, point: &Point) -> bool {
        match point.slot {
            PointSlot::Bit(slot) => self.bits[slot.0 as usize],
            PointSlot::Word(slot) | PointSlot::BitOf { word: slot, .. } => self.words[slot.0 as usize],
            PointSlot::Text(slot) => self.texts[slot.0 as usize],
            PointSlot::Timing { input, done } => self.bits[input.0 as usize] || self.bits[done.0 as usize],
        }
    }
}
