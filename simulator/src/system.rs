//! The tags of `SYS` in memory (LANGUAGE §4): where each lives, and what it holds in a scan.

use crate::layout::Layout;
use crate::memory::{Bit, Memory, Word};
use ladder_analysis::program::{Clock, SystemTag};

/// Where a system tag lives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum SystemSlot {
    Bit(Bit),
    Word(Word),
}

/// Where the system tags of a program live. Plants have their own: they go on while the controller has no power.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct System {
    /// How far its bits and words are from those of the controller.
    bits: u32,
    words: u32,
}

impl System {
    /// That of the controller.
    pub(crate) const CONTROLLER: System = System { bits: 0, words: 0 };

    /// How far its bits and words are from those of the controller.
    pub(crate) const fn offsets(self) -> (u32, u32) {
        (self.bits, self.words)
    }

    /// One with room of its own.
    pub(crate) fn new(layout: &mut Layout) -> System {
        let memory = &layout.memory;
        let system = System {
            bits: memory.bits.len() as u32 - Bit::FIRST_SCAN.0,
            words: memory.words.len() as u32 - Word::SCAN.0,
        };
        for _ in Bit::FIRST_SCAN.0..Bit::POWER.0 {
            let bit = layout.bit();
            layout.keep(bit);
        }
        for _ in Word::SCAN.0..Word::POWERED_IN.0 {
            layout.word();
        }
        system
    }

    /// The slot of a system tag.
    pub(crate) const fn slot(self, tag: SystemTag) -> SystemSlot {
        match tag {
            SystemTag::FirstScan => SystemSlot::Bit(Bit::FIRST_SCAN.offset(self.bits)),
            SystemTag::Fault => SystemSlot::Bit(Bit::FAULT.offset(self.bits)),
            SystemTag::On => SystemSlot::Bit(Bit::HIGH),
            SystemTag::Off => SystemSlot::Bit(Bit::LOW),
            SystemTag::Clock(clock) => SystemSlot::Bit(Bit::CLOCKS.offset(self.bits + clock as u32)),
            SystemTag::Scan => SystemSlot::Word(Word::SCAN.offset(self.words)),
            SystemTag::Time => SystemSlot::Word(Word::TIME.offset(self.words)),
            SystemTag::ScanTime => SystemSlot::Word(Word::SCAN_TIME.offset(self.words)),
        }
    }

    /// Sets the system tags for a scan.
    pub(crate) fn set(self, memory: &mut Memory, moment: Moment) {
        let bit = |slot: Bit| slot.offset(self.bits);
        memory.set_bit(bit(Bit::FIRST_SCAN), moment.scan == 0);
        memory.set_bit(bit(Bit::FAULT), moment.faulted);
        for clock in Clock::ALL {
            let period = clock.period();
            let high = moment.now.rem_euclid(period) >= period / 2;
            memory.set_bit(bit(Bit::CLOCKS.offset(clock as u32)), high);
        }
        let mut put = |slot: Word, value| memory.words[slot.offset(self.words).0 as usize] = value;
        // SYS.SCAN is a DINT and wraps.
        put(Word::SCAN, i64::from(moment.scan as i32));
        put(Word::TIME, moment.now);
        put(
            Word::SCAN_TIME,
            if moment.scan == 0 { 0 } else { moment.interval },
        );
    }
}

/// A scan as the system tags show it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Moment {
    /// From 0.
    pub(crate) scan: i64,
    /// The time since the start, in nanoseconds.
    pub(crate) now: i64,
    /// The time between two scans.
    pub(crate) interval: i64,
    /// A fault was recorded in the scan before.
    pub(crate) faulted: bool,
}
