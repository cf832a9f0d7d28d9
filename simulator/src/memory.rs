//! The memory of a running program: flat banks, so that a scan touches no heap but these.

use ladder_analysis::program::Clock;
use std::collections::VecDeque;

/// A slot of the bank of bits: BOOL tags, powers, edge memories. One byte each, 0 or 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Bit(pub u32);

/// A slot of the bank of words: whole numbers and times as themselves, reals as the bits of an `f64`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Word(pub u32);

/// A slot of the bank of texts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct TextSlot(pub u32);

impl Bit {
    /// Always low: an open end, `SYS.OFF`.
    pub const LOW: Bit = Bit(0);
    /// Always high: the left rail, `SYS.ON`.
    pub const HIGH: Bit = Bit(1);
    /// `SYS.FIRST_SCAN`
    pub const FIRST_SCAN: Bit = Bit(2);
    /// `SYS.FAULT`
    pub const FAULT: Bit = Bit(3);
    /// The first of the clocks of `SYS`.
    pub const CLOCKS: Bit = Bit(4);
    /// Whether the controller has power in this scan: `SYS.POWER` of a scenario.
    pub const POWER: Bit = Bit(4 + Clock::ALL.len() as u32);
    /// Whether it had power in the scan before.
    pub const HAD_POWER: Bit = Bit::POWER.offset(1);
    /// How many bits are the engine's own.
    pub const RESERVED: usize = 6 + Clock::ALL.len();

    /// The slot this many after this one.
    #[must_use]
    pub const fn offset(self, by: u32) -> Bit {
        Bit(self.0 + by)
    }
}

impl Word {
    /// `SYS.SCAN`
    pub const SCAN: Word = Word(0);
    /// `SYS.TIME`
    pub const TIME: Word = Word(1);
    /// `SYS.SCAN_TIME`
    pub const SCAN_TIME: Word = Word(2);
    /// The scan in which the controller got its power.
    pub const POWERED_IN: Word = Word(3);
    /// The time of it.
    pub const POWERED_AT: Word = Word(4);
    /// When it lost its power last.
    pub const UNPOWERED_AT: Word = Word(5);
    /// How many words are the engine's own.
    pub const RESERVED: usize = 6;

    /// The slot this many after this one.
    #[must_use]
    pub const fn offset(self, by: u32) -> Word {
        Word(self.0 + by)
    }
}

/// A text with its type's limit. The room for `max` bytes is taken when the program is compiled, so writing it
/// never allocates.
#[derive(Debug, Default, PartialEq, Eq)]
pub struct Text {
    bytes: Vec<u8>,
    max: usize,
}

impl Clone for Text {
    /// A derived clone would take no more room than the bytes need now.
    fn clone(&self) -> Self {
        let mut text = Text::new(self.max);
        text.set(&self.bytes);
        text
    }

    fn clone_from(&mut self, source: &Self) {
        self.bytes.clear();
        self.bytes.reserve(source.max);
        self.bytes.extend_from_slice(&source.bytes);
        self.max = source.max;
    }
}

impl Text {
    /// An empty text.
    pub fn new(max: usize) -> Text {
        Text {
            bytes: Vec::with_capacity(max),
            max,
        }
    }

    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// How many bytes it can hold.
    pub fn room(&self) -> usize {
        self.max
    }

    /// Replaces the text; what is longer than the type allows is cut off, as IEC 61131-3 does.
    pub fn set(&mut self, bytes: &[u8]) {
        self.bytes.clear();
        self.push(bytes);
    }

    /// Appends, as far as there is room.
    pub fn push(&mut self, bytes: &[u8]) {
        let room = self.max - self.bytes.len();
        self.bytes.extend_from_slice(&bytes[..bytes.len().min(room)]);
    }
}

impl std::fmt::Write for Text {
    fn write_str(&mut self, text: &str) -> std::fmt::Result {
        self.push(text.as_bytes());
        Ok(())
    }
}

/// The banks, and what of them is held by forces.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Memory {
    pub bits: Vec<u8>,
    pub words: Vec<i64>,
    pub texts: Vec<Text>,
    pub held: Held,
    /// Bytes that wait at the serial port.
    pub received: VecDeque<u8>,
    /// Bytes that were sent through it; never more than there is room for.
    pub sent: VecDeque<u8>,
}

/// How many sent bytes are kept.
pub(crate) const SERIAL_ROOM: usize = 1 << 16;

/// Which slots are forced. Empty until there was a force, or a scan in steps: any other scan runs code that never looks
/// here.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Held {
    /// One for each bit: 1 where it is held.
    pub bits: Vec<u8>,
    /// For each word the bits of it that are held.
    pub words: Vec<i64>,
    pub texts: Vec<bool>,
}

impl Memory {
    #[inline]
    pub fn bit(&self, slot: Bit) -> bool {
        self.bits[slot.0 as usize] != 0
    }

    #[inline]
    pub fn word(&self, slot: Word) -> i64 {
        self.words[slot.0 as usize]
    }

    #[inline]
    pub fn real(&self, slot: Word) -> f64 {
        f64::from_bits(self.words[slot.0 as usize] as u64)
    }

    pub fn text(&self, slot: TextSlot) -> &[u8] {
        self.texts[slot.0 as usize].bytes()
    }

    /// Makes the bits as many as a power of two: see the machine's records.
    pub fn fill_up_bits(&mut self) {
        self.bits.resize(self.bits.len().next_power_of_two(), 0);
    }

    /// Room to note what is forced; nothing is, unless it was there.
    pub fn make_room_for_forces(&mut self) {
        self.held.bits.resize(self.bits.len(), 0);
        self.held.words.resize(self.words.len(), 0);
        self.held.texts.resize(self.texts.len(), false);
    }

    /// Takes over what another memory of the same program holds. No room is given up.
    pub fn take_from(&mut self, other: &Memory) {
        self.bits.clone_from(&other.bits);
        self.words.clone_from(&other.words);
        self.texts.clone_from(&other.texts);
        self.held.bits.clone_from(&other.held.bits);
        self.held.words.clone_from(&other.held.words);
        self.held.texts.clone_from(&other.held.texts);
        self.received.clone_from(&other.received);
        self.sent.clone_from(&other.sent);
    }

    /// Whether another memory has as many slots.
    pub fn has_room_of(&self, other: &Memory) -> bool {
        self.bits.len() == other.bits.len()
            && self.words.len() == other.words.len()
            && self.texts.len() == other.texts.len()
    }

    /// Writes power, or anything else that cannot be forced.
    #[inline]
    pub fn set_bit(&mut self, slot: Bit, value: bool) {
        self.bits[slot.0 as usize] = u8::from(value);
    }

    /// Writes a tag's bit. A forced one stays as it is (LANGUAGE §6).
    #[inline]
    pub fn put_bit<const FORCED: bool>(&mut self, slot: Bit, value: bool) {
        let at = slot.0 as usize;
        if !FORCED || self.held.bits[at] == 0 {
            self.bits[at] = u8::from(value);
        }
    }

    /// Writes a tag's word, but for the bits of it that are forced.
    #[inline]
    pub fn put_word<const FORCED: bool>(&mut self, slot: Word, value: i64) {
        let at = slot.0 as usize;
        if FORCED {
            let held = self.held.words[at];
            self.words[at] = (self.words[at] & held) | (value & !held);
        } else {
            self.words[at] = value;
        }
    }

    /// Copies one text slot to another.
    pub fn copy_text<const FORCED: bool>(&mut self, to: TextSlot, from: TextSlot) {
        let (to, from) = (to.0 as usize, from.0 as usize);
        if to == from || (FORCED && self.held.texts[to]) {
            return;
        }
        if to < from {
            let (low, high) = self.texts.split_at_mut(from);
            low[to].set(high[0].bytes());
        } else {
            let (low, high) = self.texts.split_at_mut(to);
            high[0].set(low[from].bytes());
        }
    }
}
