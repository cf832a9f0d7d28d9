//! The tags of `SYS` in memory (LANGUAGE §4): where each lives, and what it holds in a scan.

use crate::memory::{Bit, Memory, Word};
use ladder_analysis::program::{Clock, SystemTag};

/// Where a system tag lives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum SystemSlot {
    Bit(Bit),
    Word(Word),
}

/// The slot of a system tag.
pub(crate) const fn slot(tag: SystemTag) -> SystemSlot {
    match tag {
        SystemTag::FirstScan => SystemSlot::Bit(Bit::FIRST_SCAN),
        SystemTag::Fault => SystemSlot::Bit(Bit::FAULT),
        SystemTag::On => SystemSlot::Bit(Bit::HIGH),
        SystemTag::Off => SystemSlot::Bit(Bit::LOW),
        SystemTag::Clock(clock) => SystemSlot::Bit(Bit::CLOCKS.offset(clock as u32)),
        SystemTag::Scan => SystemSlot::Word(Word::SCAN),
        SystemTag::Time => SystemSlot::Word(Word::TIME),
        SystemTag::ScanTime => SystemSlot::Word(Word::SCAN_TIME),
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

/// Sets the system tags for a scan.
pub(crate) fn set(memory: &mut Memory, moment: Moment) {
    memory.set_bit(Bit::FIRST_SCAN, moment.scan == 0);
    memory.set_bit(Bit::FAULT, moment.faulted);
    for clock in Clock::ALL {
        let period = clock.period();
        let high = moment.now.rem_euclid(period) >= period / 2;
        memory.set_bit(Bit::CLOCKS.offset(clock as u32), high);
    }
    // SYS.SCAN is a DINT and wraps.
    memory.words[Word::SCAN.0 as usize] = i64::from(moment.scan as i32);
    memory.words[Word::TIME.0 as usize] = moment.now;
    memory.words[Word::SCAN_TIME.0 as usize] = if moment.scan == 0 { 0 } else { moment.interval };
}
