//! Where each tag lives in memory, and what memory holds at a cold start.

use crate::compile_error::CompileError;
use crate::memory::{Bit, Memory, Text, TextSlot, Word};
use crate::operation::Width;
use ladder_analysis::program::{Member, Tag};
use ladder_analysis::values::types::{Scalar, Type};
use ladder_analysis::values::value::Value;
use ladder_instructions::StateType;

/// Where a tag lives. An elementary tag is an array of one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Home {
    Bits {
        at: Bit,
        first: i64,
        len: u32,
    },
    Words {
        at: Word,
        first: i64,
        len: u32,
        ty: Scalar,
    },
    Texts {
        at: TextSlot,
        first: i64,
        len: u32,
        max: u16,
    },
    State {
        state: StateType,
        bits: Bit,
        words: Word,
    },
    /// A tag without memory of its own.
    Borrowed(Borrowed),
}

/// What a tag of a block's body is that has no memory of its own: an in-out parameter stands for a place of the caller.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Borrowed {
    /// It stands for elements of an array, or for one: the word holds the slot of the first.
    Elements {
        at: Word,
        first: i64,
        len: u32,
        ty: Scalar,
    },
    /// It stands for the state of a timer, counter or bistable: the words hold where that begins.
    State {
        state: StateType,
        bits: Word,
        words: Word,
    },
    /// It stands for one bit of a word.
    BitOf { word: Word, bit: u8, width: Width },
    /// The same, of an element of an array.
    BitOfAt { at: Word, bit: u8, width: Width },
    /// It stands for a tag at a direct address which is known in another type there.
    As { word: Word, stored: Scalar, ty: Scalar },
    /// It is not bound yet: each place where the block is has its own.
    Unbound,
}

/// Where parts of a timer's state lie after its first bit and word.
pub mod timer {
    pub const IN: u32 = 0;
    pub const Q: u32 = 1;
    pub const R: u32 = 2;
    /// What the timer is doing, see `timers`.
    pub const PHASE: u32 = 3;
    pub const BITS: u32 = 4;

    pub const PT: u32 = 0;
    pub const ET: u32 = 1;
    /// The instant it began, or of the last evaluation.
    pub const SINCE: u32 = 2;
    pub const WORDS: u32 = 3;
}

/// Where parts of a counter's state lie after its first bit and word.
pub mod counter {
    pub const CU: u32 = 0;
    pub const CD: u32 = 1;
    pub const R: u32 = 2;
    pub const LD: u32 = 3;
    /// Also QU.
    pub const Q: u32 = 4;
    pub const QD: u32 = 5;
    pub const CHANGED: u32 = 6;
    /// CU and CD at the last evaluation.
    pub const UP_BEFORE: u32 = 7;
    pub const DOWN_BEFORE: u32 = 8;
    pub const BITS: u32 = 9;

    pub const PV: u32 = 0;
    pub const CV: u32 = 1;
    pub const WORDS: u32 = 2;
}

/// How many bits and words the state of a type takes.
pub const fn state_size(state: StateType) -> (u32, u32) {
    if state.is_timer() {
        (timer::BITS, timer::WORDS)
    } else if state.is_counter() {
        (counter::BITS, counter::WORDS)
    } else {
        (1, 0)
    }
}

/// Where a member is: in the bits or in the words.
pub(crate) enum MemberSlot {
    Bit(Bit),
    Word(Word),
    /// `TT`: IN and not Q.
    Timing {
        input: Bit,
        done: Bit,
    },
}

/// The slot of a member; none if the type does not have it.
pub(crate) fn member(state: StateType, bits: Bit, words: Word, member: Member) -> Option<MemberSlot> {
    use MemberSlot as Slot;
    if state.is_timer() {
        return Some(match member {
            Member::In => Slot::Bit(bits.offset(timer::IN)),
            Member::Q => Slot::Bit(bits.offset(timer::Q)),
            Member::R => Slot::Bit(bits.offset(timer::R)),
            Member::Pt => Slot::Word(words.offset(timer::PT)),
            Member::Et => Slot::Word(words.offset(timer::ET)),
            Member::Timing => Slot::Timing {
                input: bits.offset(timer::IN),
                done: bits.offset(timer::Q),
            },
            _ => return None,
        });
    }
    if state.is_counter() {
        return Some(match member {
            Member::Cu | Member::In => Slot::Bit(bits.offset(counter::CU)),
            Member::Cd => Slot::Bit(bits.offset(counter::CD)),
            Member::R => Slot::Bit(bits.offset(counter::R)),
            Member::Ld => Slot::Bit(bits.offset(counter::LD)),
            Member::Q | Member::Qu => Slot::Bit(bits.offset(counter::Q)),
            Member::Qd => Slot::Bit(bits.offset(counter::QD)),
            Member::Changed => Slot::Bit(bits.offset(counter::CHANGED)),
            Member::Pv => Slot::Word(words.offset(counter::PV)),
            Member::Cv => Slot::Word(words.offset(counter::CV)),
            _ => return None,
        });
    }
    matches!(member, Member::Q1 | Member::Q).then_some(Slot::Bit(bits))
}

/// More elements than this in one bank are refused: a slip such as `ARRAY[0..2000000000]` would take all the
/// memory of the machine.
const MOST_SLOTS: usize = 1 << 26;
/// The same for the bytes of all texts.
const MOST_TEXT: usize = 1 << 28;

/// Memory while it is laid out; what it holds at the end is its state at a cold start.
#[derive(Debug)]
pub(crate) struct Layout {
    pub(crate) memory: Memory,
    /// Of each bit whether only code reads it: powers, and values on the way. No tags.
    pub(crate) temporary: Vec<bool>,
    text_bytes: usize,
}

impl Layout {
    pub(crate) fn new() -> Layout {
        let mut memory = Memory {
            bits: vec![0; Bit::RESERVED],
            words: vec![0; Word::RESERVED],
            ..Memory::default()
        };
        for high in [Bit::HIGH, Bit::POWER, Bit::HAD_POWER] {
            memory.set_bit(high, true);
        }
        Layout {
            memory,
            temporary: Vec::new(),
            text_bytes: 0,
        }
    }

    /// A bit for a power, or for a value on the way.
    pub(crate) fn bit(&mut self) -> Bit {
        self.temporary.resize(self.memory.bits.len(), false);
        self.memory.bits.push(0);
        self.temporary.push(true);
        Bit(self.memory.bits.len() as u32 - 1)
    }

    /// Something else than instructions reads this bit: it must always be written.
    pub(crate) fn keep(&mut self, bit: Bit) {
        if let Some(temporary) = self.temporary.get_mut(bit.0 as usize) {
            *temporary = false;
        }
    }

    pub(crate) fn word(&mut self) -> Word {
        self.constant(0)
    }

    /// A word that holds a value from the start.
    pub(crate) fn constant(&mut self, value: i64) -> Word {
        self.memory.words.push(value);
        Word(self.memory.words.len() as u32 - 1)
    }

    pub(crate) fn text(&mut self, max: usize) -> TextSlot {
        // The text itself takes room too, not only its bytes.
        self.text_bytes += max + size_of::<Text>();
        self.memory.texts.push(Text::new(max));
        TextSlot(self.memory.texts.len() as u32 - 1)
    }

    pub(crate) fn text_constant(&mut self, bytes: &[u8]) -> TextSlot {
        let slot = self.text(bytes.len());
        self.memory.texts[slot.0 as usize].set(bytes);
        slot
    }

    /// Whether memory has grown past what is allowed.
    pub(crate) fn is_too_large(&self) -> bool {
        let Memory {
            bits, words, texts, ..
        } = &self.memory;
        bits.len().max(words.len()).max(texts.len()) > MOST_SLOTS || self.text_bytes > MOST_TEXT
    }

    /// Makes room for a tag, with its initial value.
    pub(crate) fn tag(&mut self, tag: &Tag) -> Result<Home, CompileError> {
        let too_large = || CompileError {
            message: format!(
                "{} takes more memory than the simulator has; make it smaller",
                tag.name
            ),
            location: tag.location,
        };
        let (first, len, ty) = match tag.ty {
            Type::Scalar(ty) => (0, 1, ty),
            Type::Array { first, last, element } => {
                let len = (i128::from(last) - i128::from(first) + 1).max(0);
                (first, usize::try_from(len).map_err(|_| too_large())?, element)
            }
            // The tags of its body are the program's own.
            Type::Compound(_) => return Ok(Home::Borrowed(Borrowed::Unbound)),
            Type::State(state) => {
                let (bits, words) = state_size(state);
                let home = Home::State {
                    state,
                    bits: Bit(self.memory.bits.len() as u32),
                    words: Word(self.memory.words.len() as u32),
                };
                self.memory.bits.resize(self.memory.bits.len() + bits as usize, 0);
                self.memory
                    .words
                    .resize(self.memory.words.len() + words as usize, 0);
                return Ok(home);
            }
        };
        let bytes = match ty {
            Scalar::String(max) => usize::from(max),
            _ => 0,
        };
        let text_bytes = if bytes > 0 {
            len.saturating_mul(bytes + size_of::<Text>())
        } else {
            0
        };
        if len > MOST_SLOTS || text_bytes > MOST_TEXT {
            return Err(too_large());
        }
        let home = match ty {
            Scalar::Bool => {
                let at = Bit(self.memory.bits.len() as u32);
                let initial = |n| matches!(tag.initial.get(n), Some(Value::Bool(true)));
                self.memory.bits.extend((0..len).map(|n| u8::from(initial(n))));
                Home::Bits {
                    at,
                    first,
                    len: len as u32,
                }
            }
            Scalar::String(max) => {
                let at = TextSlot(self.memory.texts.len() as u32);
                for n in 0..len {
                    let slot = self.text(usize::from(max));
                    if let Some(Value::Text(bytes)) = tag.initial.get(n) {
                        self.memory.texts[slot.0 as usize].set(bytes);
                    }
                }
                Home::Texts {
                    at,
                    first,
                    len: len as u32,
                    max,
                }
            }
            _ => {
                let at = Word(self.memory.words.len() as u32);
                let initial = |n| tag.initial.get(n).map_or(0, word_of);
                self.memory.words.extend((0..len).map(initial));
                Home::Words {
                    at,
                    first,
                    len: len as u32,
                    ty,
                }
            }
        };
        if self.is_too_large() {
            Err(too_large())
        } else {
            Ok(home)
        }
    }
}

/// A value as a word holds it.
pub(crate) fn word_of(value: &Value) -> i64 {
    match value {
        Value::Bool(high) => i64::from(*high),
        Value::Int(number) => *number,
        Value::Real(real) => real.to_bits() as i64,
        Value::Text(_) => 0,
    }
}
