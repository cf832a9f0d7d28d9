//! Timers that count a time base and counters that latch, as the code of iot-ladder-editor has them.

use super::Operands;
use crate::layout::{counter as c, timer as t};
use crate::memory::{Memory, Word};
use crate::operation::Width;
use crate::timers::Clock;

/// The width of what is counted.
const WIDTH: Width = Width::I32;

/// The clock counts whole milliseconds.
const MILLISECOND: i64 = 1_000_000;

/// The clock of that system: a program's first scan is at the end of its first interval.
fn now(memory: &Memory, clock: Clock, interval: Word) -> i64 {
    let now = clock.now.saturating_add(memory.word(interval));
    now - now.rem_euclid(MILLISECOND)
}

/// At most one step in a scan. The power after an on-delay is whether the time is over; after the other one it is
/// EN until then.
pub(super) fn timer<const FORCED: bool>(
    memory: &mut Memory,
    with: &mut Operands,
    clock: Clock,
    on_delay: bool,
) {
    let (out, en, preset) = (with.bit(), with.bit(), with.word());
    let (bits, words, base, interval) = (with.bit(), with.word(), with.word(), with.word());
    let (done, count, since) = (bits.offset(t::Q), words.offset(t::ET), words.offset(t::SINCE));
    let (en, preset) = (memory.bit(en), memory.word(preset));
    memory.put_bit::<FORCED>(bits.offset(t::IN), en);
    let en = memory.bit(bits.offset(t::IN));
    memory.put_word::<FORCED>(words.offset(t::PT), preset);
    let now = now(memory, clock, interval);
    if !en {
        memory.put_bit::<FORCED>(done, false);
        memory.put_word::<FORCED>(count, 0);
        memory.words[since.0 as usize] = now;
    } else if !memory.bit(done) && now.saturating_sub(memory.word(since)) >= memory.word(base) {
        memory.words[since.0 as usize] = now;
        let next = WIDTH.wrap(memory.word(count) + 1);
        memory.put_word::<FORCED>(count, next);
        if memory.word(count) >= memory.word(words.offset(t::PT)) {
            memory.put_bit::<FORCED>(done, true);
        }
    }
    let power = if on_delay {
        memory.bit(done)
    } else {
        en && !memory.bit(done)
    };
    memory.set_bit(out, power);
}

pub(super) fn reset_timer<const FORCED: bool>(memory: &mut Memory, with: &mut Operands, clock: Clock) {
    let (en, bits, words, start, interval) = (with.bit(), with.bit(), with.word(), with.word(), with.word());
    if !memory.bit(en) {
        return;
    }
    let start = memory.word(start);
    memory.put_bit::<FORCED>(bits.offset(t::Q), false);
    memory.put_bit::<FORCED>(bits.offset(t::IN), false);
    memory.put_word::<FORCED>(words.offset(t::ET), start);
    memory.words[words.offset(t::SINCE).0 as usize] = now(memory, clock, interval);
}

/// That PV was reached is kept until a reset; it shows only while EN is high.
pub(super) fn counter<const FORCED: bool>(memory: &mut Memory, with: &mut Operands, up: bool) {
    let (out, en, preset, bits, words) = (with.bit(), with.bit(), with.word(), with.bit(), with.word());
    let (done, counted, count) = (bits.offset(c::Q), bits.offset(c::CHANGED), words.offset(c::CV));
    let (en, preset) = (memory.bit(en), memory.word(preset));
    memory.put_bit::<FORCED>(bits.offset(c::CU), en);
    let en = memory.bit(bits.offset(c::CU));
    memory.put_word::<FORCED>(words.offset(c::PV), preset);
    let preset = memory.word(words.offset(c::PV));
    if !en {
        memory.put_bit::<FORCED>(counted, false);
    } else if !memory.bit(counted) {
        let next = memory.word(count) + if up { 1 } else { -1 };
        memory.put_word::<FORCED>(count, WIDTH.wrap(next));
        memory.put_bit::<FORCED>(counted, true);
        let count = memory.word(count);
        if (up && count >= preset) || (!up && count <= preset) {
            memory.put_bit::<FORCED>(done, true);
        }
    }
    let power = en && memory.bit(done);
    memory.set_bit(out, power);
}

pub(super) fn reset_counter<const FORCED: bool>(memory: &mut Memory, with: &mut Operands) {
    let (en, bits, words, start) = (with.bit(), with.bit(), with.word(), with.word());
    if !memory.bit(en) {
        return;
    }
    let start = memory.word(start);
    memory.put_bit::<FORCED>(bits.offset(c::Q), false);
    memory.put_bit::<FORCED>(bits.offset(c::CHANGED), false);
    memory.put_word::<FORCED>(words.offset(c::CV), start);
}
