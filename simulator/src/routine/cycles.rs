//! Timers that count scans and counters of 16 bits, as LDmicro's simulator has them.

use super::Operands;
use crate::layout::{counter as c, timer as t};
use crate::memory::Memory;
use crate::operation::Width;

/// The width of what is counted.
const WIDTH: Width = Width::I16;

/// One evaluation of a timer.
pub(super) struct Evaluation {
    en: bool,
    preset: i64,
    /// It is the first one.
    first: bool,
    count: i64,
}

/// Runs a timer: what it does gives the power and the new count.
pub(super) fn timer<const FORCED: bool>(
    memory: &mut Memory,
    with: &mut Operands,
    evaluate: fn(Evaluation) -> (bool, i64),
) {
    let (out, en, preset) = (with.bit(), with.bit(), with.word());
    let (bits, words, started) = (with.bit(), with.word(), with.bit());
    let (en, preset) = (memory.bit(en), memory.word(preset));
    memory.put_bit::<FORCED>(bits.offset(t::IN), en);
    memory.put_word::<FORCED>(words.offset(t::PT), preset);
    let first = !memory.bit(started);
    memory.set_bit(started, true);
    let (q, count) = evaluate(Evaluation {
        en,
        preset: memory.word(words.offset(t::PT)),
        first,
        count: memory.word(words.offset(t::ET)),
    });
    memory.put_word::<FORCED>(words.offset(t::ET), count);
    memory.put_bit::<FORCED>(bits.offset(t::Q), q);
    let q = memory.bit(bits.offset(t::Q));
    memory.set_bit(out, q);
}

pub(super) fn on_delay(now: Evaluation) -> (bool, i64) {
    match now {
        Evaluation { en: false, .. } => (false, 0),
        Evaluation { count, preset, .. } if count < preset => (false, next(count)),
        Evaluation { count, .. } => (true, count),
    }
}

/// It begins as if it had run out.
pub(super) fn off_delay(now: Evaluation) -> (bool, i64) {
    let count = if now.first { now.preset } else { now.count };
    match now {
        Evaluation { en: true, .. } => (true, 0),
        Evaluation { preset, .. } if count < preset => (true, next(count)),
        _ => (false, count),
    }
}

pub(super) fn retentive(now: Evaluation) -> (bool, i64) {
    match now {
        Evaluation { count, preset, .. } if count >= preset => (true, count),
        Evaluation { en: true, count, .. } => (false, next(count)),
        Evaluation { count, .. } => (false, count),
    }
}

/// What a counter does: from the count, PV, whether EN has risen, and EN to the power and the new count.
type Count = fn(i64, i64, bool, bool) -> (bool, i64);

pub(super) fn counter<const FORCED: bool>(memory: &mut Memory, with: &mut Operands, evaluate: Count) {
    let (out, en, most) = (with.bit(), with.bit(), with.word());
    let (bits, words, before) = (with.bit(), with.word(), with.bit());
    let (en, most) = (memory.bit(en), memory.word(most));
    let rose = en && !memory.bit(before);
    memory.set_bit(before, en);
    memory.put_bit::<FORCED>(bits.offset(c::CU), en);
    memory.put_word::<FORCED>(words.offset(c::PV), most);
    let most = memory.word(words.offset(c::PV));
    let was = memory.word(words.offset(c::CV));
    let (_, count) = evaluate(was, most, rose, en);
    memory.put_word::<FORCED>(words.offset(c::CV), count);
    // The output is that of the count that is there now: it may be forced.
    let (q, _) = evaluate(memory.word(words.offset(c::CV)), most, false, en);
    memory.put_bit::<FORCED>(bits.offset(c::CHANGED), count != was);
    memory.put_bit::<FORCED>(bits.offset(c::Q), q);
    let q = memory.bit(bits.offset(c::Q));
    memory.set_bit(out, q);
}

pub(super) fn up(count: i64, most: i64, rose: bool, _: bool) -> (bool, i64) {
    let count = if rose { next(count) } else { count };
    (count >= most, count)
}

pub(super) fn down(count: i64, most: i64, rose: bool, _: bool) -> (bool, i64) {
    let count = if rose { WIDTH.wrap(count - 1) } else { count };
    (count >= most, count)
}

/// Its power is EN.
pub(super) fn circular(count: i64, most: i64, rose: bool, en: bool) -> (bool, i64) {
    let count = match next(count) {
        _ if !rose => count,
        next if next > most => 0,
        next => next,
    };
    (en, count)
}

fn next(count: i64) -> i64 {
    WIDTH.wrap(count + 1)
}
