//! How instructions and routines use the cells of memory.

use crate::memory::{Bit, Word};

/// How a cell is used.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Access {
    /// Its value is asked for.
    Read,
    /// Written in any case where the instruction runs.
    Write,
    /// Written where something holds, or read before.
    Change,
}

/// A cell of memory.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Cell {
    /// A bit.
    Bit(Bit),
    /// A word.
    Word(Word),
    /// What a timer is doing, and since when: by its first bit.
    Timer(Bit),
    /// The ET of a timer, which it writes.
    Elapsed(Word),
    /// Any: it is not known which.
    Unknown,
}

impl From<Bit> for Cell {
    fn from(bit: Bit) -> Cell {
        Cell::Bit(bit)
    }
}

impl From<Word> for Cell {
    fn from(word: Word) -> Cell {
        Cell::Word(word)
    }
}
