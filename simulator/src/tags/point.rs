//! A value of a running program: what it is called, and where it lives.

use crate::layout::{self, Home};
use crate::memory::{Bit, Memory, TextSlot, Word};
use ladder_analysis::program::{Role, Tag};
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_instructions::StateType;

/// One value of a running program: an elementary tag, an element of an array, a member of a timer or counter, a
/// bit of a word, or a system tag.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// As declared, or as first written: `run`, `t1.ET`, `a[3]`.
    pub name: String,
    /// The type of its value.
    pub ty: Scalar,
    /// Input, output or neither, by its declaration, its name, or how its file uses it.
    pub role: Role,
    /// What is outside of the program gives it its value before each scan.
    pub is_input: bool,
    /// It cannot be set or forced: a constant or system tag.
    pub read_only: bool,
    pub(crate) within: Within,
    pub(crate) slot: PointSlot,
}

/// What a value is a part of that no force reaches (LANGUAGE §4).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Within {
    /// Of none: it is an elementary tag, member or element.
    None,
    /// It is a bit of a number.
    Number,
    /// Of a timer, counter or bistable.
    State(StateType),
    /// Of the state of a user-defined block.
    Block,
}

impl Within {
    pub(crate) fn of(tag: &Tag) -> Within {
        let is_inside = tag.block.is_some() || is_inside(tag);
        if is_inside { Within::Block } else { Within::None }
    }
}

/// Whether a tag is of the state of a user-defined block that is a tag.
pub(crate) fn is_inside(tag: &Tag) -> bool {
    (tag.column.as_ref()).is_some_and(|column| column.root < column.declared.0)
}

impl Point {
    /// Whether it can be forced: bits, and members of timers and blocks, can only be set.
    pub fn takes_force(&self) -> bool {
        !self.read_only && self.within == Within::None
    }

    /// Where it lives, for those who translate the compiled form.
    pub fn slot(&self) -> PointSlot {
        self.slot
    }

    /// The name of the number that it is a bit of, and which bit.
    pub fn bit_of(&self) -> Option<(&str, u8)> {
        let PointSlot::BitOf { bit, .. } = self.slot else {
            return None;
        };
        let (number, _) = self.name.rsplit_once('.')?;
        Some((number, bit))
    }

    /// Whether it is a system tag.
    pub(crate) fn is_system(&self) -> bool {
        self.name.starts_with("SYS.")
    }

    /// Whether it holds the same in every scan: a constant of the program, and the system tags for on and off.
    pub(crate) fn is_constant(&self) -> bool {
        let is_member = matches!(self.slot, PointSlot::Timing { .. });
        let is_fixed = matches!(self.name.as_str(), "SYS.ON" | "SYS.OFF");
        is_fixed || (self.read_only && !is_member && !self.is_system())
    }

    /// What it holds in a memory.
    pub(crate) fn read(&self, memory: &Memory) -> Value {
        match self.slot {
            PointSlot::Bit(slot) => Value::Bool(memory.bit(slot)),
            PointSlot::Word(slot) if self.ty.is_real() => Value::Real(memory.real(slot)),
            PointSlot::Word(slot) => Value::Int(memory.word(slot)),
            PointSlot::Text(slot) => Value::Text(memory.text(slot).into()),
            PointSlot::BitOf { word, bit, .. } => Value::Bool(memory.word(word) >> bit & 1 != 0),
            PointSlot::Timing { input, done } => Value::Bool(memory.bit(input) && !memory.bit(done)),
        }
    }

    /// Whether it holds in a memory what another point holds in another one.
    pub(crate) fn is_as(&self, memory: &Memory, (other, there): (&Point, &Memory)) -> bool {
        match (self.slot, other.slot) {
            // Reading a text makes a copy of it.
            (PointSlot::Text(slot), PointSlot::Text(other)) => memory.text(slot) == there.text(other),
            _ => self.read(memory) == other.read(there),
        }
    }
}

/// Where a point lives.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs, reason = "operands and members are described at what has them")]
pub enum PointSlot {
    Bit(Bit),
    Word(Word),
    Text(TextSlot),
    BitOf { word: Word, bit: u8, ty: Scalar },
    Timing { input: Bit, done: Bit },
}

impl Home {
    /// Whether a point is what lives here, or a part of it.
    pub(crate) fn holds(self, slot: PointSlot) -> bool {
        let bit = |slot: Bit, at: Bit, len: u32| (at.0..at.0 + len).contains(&slot.0);
        let word = |slot: Word, at: Word, len: u32| (at.0..at.0 + len).contains(&slot.0);
        match (self, slot) {
            (Home::Bits { at, len, .. }, PointSlot::Bit(slot)) => bit(slot, at, len),
            (Home::Words { at, len, .. }, PointSlot::Word(slot) | PointSlot::BitOf { word: slot, .. }) => {
                word(slot, at, len)
            }
            (Home::Texts { at, len, .. }, PointSlot::Text(TextSlot(slot))) => {
                (at.0..at.0 + len).contains(&slot)
            }
            (
                Home::State { state, bits, .. },
                PointSlot::Bit(slot) | PointSlot::Timing { input: slot, .. },
            ) => bit(slot, bits, layout::state_size(state).0),
            (Home::State { state, words, .. }, PointSlot::Word(slot)) => {
                word(slot, words, layout::state_size(state).1)
            }
            _ => false,
        }
    }
}
