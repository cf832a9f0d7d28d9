//! Timers that count time in a unit, and counters whose output compares, as Click controllers have them.

use super::Operands;
use crate::layout::{counter as c, timer as t};
use crate::memory::Memory;
use crate::timers::Clock;

/// What a timer can count to.
pub(crate) const MOST_UNITS: i64 = i16::MAX as i64;

/// What a timer does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Delay {
    On,
    Off,
    RetentiveOn,
    RetentiveOff,
}

// Phase: a set of these.
/// Time passed in the last evaluation.
const COUNTING: u8 = 1;
/// EN of an off-delay was high once since it was cleared.
const ARMED: u8 = 2;

/// Time runs in every evaluation that counts, the first one for a whole scan. What is less than a unit is kept in a word
/// of the block's own.
pub(super) fn timer<const FORCED: bool>(
    memory: &mut Memory,
    with: &mut Operands,
    clock: Clock,
    delay: Delay,
) {
    let (out, en, preset) = (with.bit(), with.bit(), with.word());
    let (bits, words, unit, interval) = (with.bit(), with.word(), with.word(), with.word());
    let rest = with.word().0 as usize;
    let phase_at = bits.offset(t::PHASE).0 as usize;
    let (since, count) = (words.offset(t::SINCE), words.offset(t::ET));
    let reset = memory.bit(bits.offset(t::R));
    let (en, preset) = (memory.bit(en), memory.word(preset));
    memory.put_bit::<FORCED>(bits.offset(t::IN), en && !reset);
    let en = memory.bit(bits.offset(t::IN));
    memory.put_word::<FORCED>(words.offset(t::PT), preset);
    let preset = memory.word(words.offset(t::PT));

    let before = memory.bits[phase_at];
    let is_off = matches!(delay, Delay::Off | Delay::RetentiveOff);
    let armed = !reset && is_off && (en || before & ARMED != 0);
    let counts = !reset && if is_off { armed && !en } else { en };
    let clears = reset
        || match delay {
            Delay::On => !en,
            Delay::Off => en,
            Delay::RetentiveOn | Delay::RetentiveOff => false,
        };
    if clears {
        memory.words[rest] = 0;
        memory.put_word::<FORCED>(count, 0);
    } else if counts {
        let passed = if before & COUNTING == 0 {
            memory.word(interval)
        } else {
            clock.now.saturating_sub(memory.word(since))
        };
        let unit = memory.word(unit).max(1);
        let time = memory.words[rest].saturating_add(passed);
        memory.words[rest] = time % unit;
        let next = memory.word(count).saturating_add(time / unit).min(MOST_UNITS);
        memory.put_word::<FORCED>(count, next);
    }
    memory.words[since.0 as usize] = clock.now;
    memory.bits[phase_at] = (u8::from(counts) * COUNTING) | (u8::from(armed) * ARMED);

    let reached = memory.word(count) >= preset;
    let q = match delay {
        _ if reset => false,
        Delay::On => en && reached,
        Delay::RetentiveOn => reached,
        Delay::Off | Delay::RetentiveOff => en || (armed && !reached),
    };
    memory.put_bit::<FORCED>(bits.offset(t::Q), q);
    let q = memory.bit(bits.offset(t::Q));
    memory.set_bit(out, q);
}

/// Which way a counter counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Way {
    Up,
    Down,
    Both,
}

pub(super) fn counter<const FORCED: bool>(memory: &mut Memory, with: &mut Operands, way: Way) {
    let (out, en, preset, bits, words) = (with.bit(), with.bit(), with.word(), with.bit(), with.word());
    let (en, preset) = (memory.bit(en), memory.word(preset));
    let count_at = words.offset(c::CV);
    memory.put_bit::<FORCED>(bits.offset(c::CU), en);
    memory.put_word::<FORCED>(words.offset(c::PV), preset);
    let preset = memory.word(words.offset(c::PV));
    let mut rise = |input: u32, before: u32| {
        let high = memory.bit(bits.offset(input));
        let was = memory.bit(bits.offset(before));
        memory.set_bit(bits.offset(before), high);
        high && !was
    };
    let (first, second) = (rise(c::CU, c::UP_BEFORE), rise(c::CD, c::DOWN_BEFORE));
    let step = match way {
        Way::Up => i64::from(first),
        Way::Down => -i64::from(first),
        Way::Both => i64::from(first) - i64::from(second),
    };
    let before = memory.word(count_at);
    let reset = memory.bit(bits.offset(c::R));
    let count = match () {
        () if reset => 0,
        () if memory.bit(bits.offset(c::LD)) => preset,
        () => (before + step).clamp(i32::MIN.into(), i32::MAX.into()),
    };
    memory.put_word::<FORCED>(count_at, count);
    let count = memory.word(count_at);
    memory.put_bit::<FORCED>(bits.offset(c::CHANGED), count != before);
    if way == Way::Both {
        memory.put_bit::<FORCED>(bits.offset(c::QD), count <= 0);
    }
    let reached = match way {
        Way::Down => count <= preset,
        Way::Up | Way::Both => count >= preset,
    };
    memory.put_bit::<FORCED>(bits.offset(c::Q), reached && !reset);
    let q = memory.bit(bits.offset(c::Q));
    memory.set_bit(out, q);
}
