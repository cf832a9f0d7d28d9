//! Places: reading and writing tags, elements, members and bits.

use super::range::constant;
use super::{Compiler, Result};
use crate::code::{ArrayPlace, Instr};
use crate::layout::{Borrowed, Home};
use crate::memory::{Bit, TextSlot, Word};
use crate::operation::{IntegerOp, Width};
use crate::system::SystemSlot;
use ladder_analysis::program::{Expr, Place, TagId};
use ladder_analysis::values::types::Scalar;

/// Where a value is read or written. What ends in `At` holds the slot's number in a word, which is known only
/// when the place is reached.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Spot {
    Bit(Bit),
    BitAt(Word),
    Word(Word),
    WordAt(Word),
    Text(TextSlot),
    TextAt {
        at: Word,
        max: u16,
    },
    BitOf {
        word: Word,
        bit: u8,
        width: Width,
    },
    BitOfAt {
        at: Word,
        bit: u8,
        width: Width,
    },
    /// A word that is known in another type: see [`Place::As`].
    As {
        word: Word,
        stored: Scalar,
        ty: Scalar,
    },
    /// A timer's `TT`.
    Timing {
        input: Bit,
        done: Bit,
    },
    /// The same, of one that a computed index chooses.
    TimingAt {
        input: Word,
        done: Word,
    },
}

/// A value in one of the banks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Slot {
    Bit(Bit),
    Word(Word),
    Text(TextSlot),
}

impl Slot {
    /// Its number in its bank, as routines take it.
    pub(super) const fn number(self) -> u32 {
        match self {
            Slot::Bit(slot) => slot.0,
            Slot::Word(slot) => slot.0,
            Slot::Text(slot) => slot.0,
        }
    }
}

impl Compiler<'_> {
    /// Finds a place. Emits what computes the index of an element, if that is not known yet.
    pub(super) fn spot(&mut self, place: &Place) -> Result<Spot> {
        Ok(match place {
            Place::Tag(tag) => spot_of(self.homes[tag.0 as usize]),
            Place::Chosen(chosen) => spot_of(self.chosen(chosen)?),
            Place::Element(tag, index) => self.element(*tag, index)?,
            Place::Member(tag, member) => self.member(self.homes[tag.0 as usize], *member),
            Place::ChosenMember(chosen, member) => {
                let home = self.chosen(chosen)?;
                self.member(home, *member)
            }
            Place::Bit(word, ty, bit) => match self.spot(word)? {
                Spot::Word(word) => Spot::BitOf {
                    word,
                    bit: *bit,
                    width: Width::of(*ty),
                },
                Spot::As { word, stored, .. } => Spot::BitOf {
                    word,
                    bit: *bit,
                    width: Width::of(stored),
                },
                Spot::WordAt(at) => Spot::BitOfAt {
                    at,
                    bit: *bit,
                    width: Width::of(*ty),
                },
                other => other,
            },
            Place::As(inner, stored, ty) => match self.spot(inner)? {
                Spot::Word(word) if Width::of(*stored) != Width::of(*ty) => Spot::As {
                    word,
                    stored: *stored,
                    ty: *ty,
                },
                other => other,
            },
            Place::System(tag) => match self.system.slot(*tag) {
                SystemSlot::Bit(bit) => Spot::Bit(bit),
                SystemSlot::Word(word) => Spot::Word(word),
            },
        })
    }

    fn element(&mut self, tag: TagId, index: &Expr) -> Result<Spot> {
        let (base, first, len, ty) = match self.homes[tag.0 as usize] {
            Home::Borrowed(Borrowed::Elements { at, first, len, ty }) => {
                let last = first + i64::from(len) - 1;
                if let Some(index) = constant(index).filter(|index| (first..=last).contains(index)) {
                    let to = self.slot_offset(at, (index - first) as u32);
                    return Ok(element_spot(to, ty));
                }
                let index = self.count(index)?;
                let to = self.layout.word();
                let array = self.array(ArrayPlace { base: 0, first, last });
                self.emit(Instr::Index { to, index, array });
                let to = self.integer(IntegerOp::Add, Scalar::Lint, to, at);
                return Ok(element_spot(to, ty));
            }
            Home::Bits { at, first, len } => (at.0, first, len, Scalar::Bool),
            Home::Words { at, first, len, ty } => (at.0, first, len, ty),
            Home::Texts { at, first, len, max } => (at.0, first, len, Scalar::String(max)),
            _ => return Ok(Spot::Bit(Bit::LOW)),
        };
        let last = first + i64::from(len) - 1;
        if let Some(index) = constant(index).filter(|index| (first..=last).contains(index)) {
            let slot = base + (index - first) as u32;
            return Ok(match ty {
                Scalar::Bool => Spot::Bit(Bit(slot)),
                Scalar::String(_) => Spot::Text(TextSlot(slot)),
                _ => Spot::Word(Word(slot)),
            });
        }
        let index = self.count(index)?;
        let to = self.layout.word();
        let array = self.array(ArrayPlace { base, first, last });
        self.emit(Instr::Index { to, index, array });
        Ok(element_spot(to, ty))
    }

    pub(super) fn array(&mut self, place: ArrayPlace) -> u32 {
        let arrays = &mut self.code.arrays;
        *self.arrays.entry(place).or_insert_with(|| {
            arrays.push(place);
            arrays.len() as u32 - 1
        })
    }

    /// Reads a place.
    pub(super) fn load(&mut self, spot: Spot) -> Slot {
        match spot {
            Spot::Bit(slot) => Slot::Bit(slot),
            Spot::Word(slot) => Slot::Word(slot),
            Spot::Text(slot) => Slot::Text(slot),
            Spot::BitAt(at) => {
                let to = self.layout.bit();
                self.emit(Instr::LoadBit { to, at });
                Slot::Bit(to)
            }
            Spot::WordAt(at) => {
                let to = self.layout.word();
                self.emit(Instr::LoadWord { to, at });
                Slot::Word(to)
            }
            Spot::TextAt { at, max } => {
                let to = self.layout.text(usize::from(max));
                self.emit(Instr::LoadText { to, at });
                Slot::Text(to)
            }
            Spot::BitOf { word, bit, .. } => {
                let to = self.layout.bit();
                self.emit(Instr::LoadBitOf { to, word, bit });
                Slot::Bit(to)
            }
            Spot::BitOfAt { at, bit, .. } => {
                let word = self.layout.word();
                self.emit(Instr::LoadWord { to: word, at });
                let to = self.layout.bit();
                self.emit(Instr::LoadBitOf { to, word, bit });
                Slot::Bit(to)
            }
            Spot::As { word, stored, ty } => self.pass(Slot::Word(word), stored, ty),
            Spot::Timing { input, done } => {
                let to = self.layout.bit();
                self.emit(Instr::NotBit { to, a: done });
                self.emit(Instr::AndBit { to, a: to, b: input });
                Slot::Bit(to)
            }
            Spot::TimingAt { input: at, done } => {
                let [input, to] = [self.layout.bit(), self.layout.bit()];
                self.emit(Instr::LoadBit { to: input, at });
                self.emit(Instr::LoadBit { to, at: done });
                self.emit(Instr::NotBit { to, a: to });
                self.emit(Instr::AndBit { to, a: to, b: input });
                Slot::Bit(to)
            }
        }
    }

    /// Writes a place.
    pub(super) fn store(&mut self, spot: Spot, value: Slot) {
        match (spot, value) {
            (Spot::Bit(to), Slot::Bit(from)) => self.emit(Instr::MoveBit { to, from }),
            (Spot::BitAt(at), Slot::Bit(from)) => self.emit(Instr::StoreBit { at, from }),
            (Spot::Word(to), Slot::Word(from)) => self.emit(Instr::Move { to, from }),
            (Spot::WordAt(at), Slot::Word(from)) => self.emit(Instr::StoreWord { at, from }),
            (Spot::Text(to), Slot::Text(from)) => self.emit(Instr::MoveText { to, from }),
            (Spot::TextAt { at, .. }, Slot::Text(from)) => self.emit(Instr::StoreText { at, from }),
            (Spot::BitOf { word, bit, width }, Slot::Bit(from)) => {
                self.emit(Instr::StoreBitOf {
                    word,
                    bit,
                    width,
                    from,
                });
            }
            (Spot::BitOfAt { at, bit, width }, Slot::Bit(from)) => {
                let word = self.layout.word();
                self.emit(Instr::LoadWord { to: word, at });
                self.emit(Instr::StoreBitOf {
                    word,
                    bit,
                    width,
                    from,
                });
                self.emit(Instr::StoreWord { at, from: word });
            }
            (Spot::As { word: to, stored, ty }, value @ Slot::Word(_)) => {
                if let Slot::Word(from) = self.pass(value, ty, stored) {
                    self.emit(Instr::Move { to, from });
                }
            }
            // Types were checked before; there is nothing else.
            _ => debug_assert!(false, "{value:?} does not fit {spot:?}"),
        }
    }
}

/// Where the value of an elementary tag is, or the first of an array.
const fn spot_of(home: Home) -> Spot {
    match home {
        Home::Bits { at, .. } => Spot::Bit(at),
        Home::Words { at, .. } => Spot::Word(at),
        Home::Texts { at, .. } => Spot::Text(at),
        Home::State { bits, .. } => Spot::Bit(bits),
        Home::Borrowed(borrowed) => match borrowed {
            Borrowed::Elements { at, ty, .. } => element_spot(at, ty),
            Borrowed::State { bits, .. } => Spot::BitAt(bits),
            Borrowed::BitOf { word, bit, width } => Spot::BitOf { word, bit, width },
            Borrowed::BitOfAt { at, bit, width } => Spot::BitOfAt { at, bit, width },
            Borrowed::As { word, stored, ty } => Spot::As { word, stored, ty },
            Borrowed::Unbound => Spot::Bit(Bit::LOW),
        },
    }
}

const fn element_spot(at: Word, ty: Scalar) -> Spot {
    match ty {
        Scalar::Bool => Spot::BitAt(at),
        Scalar::String(max) => Spot::TextAt { at, max },
        _ => Spot::WordAt(at),
    }
}
