//! The instructions that code runs straight through.

use crate::code::{Code, Instr, Record};
use crate::counters::{self, Counter};
use crate::fault::Trouble;
use crate::memory::{Bit, Memory, TextSlot, Word};
use crate::operation::{convert, integer, real, real_function};
use crate::routine;
use crate::timers::{Clock, Timer};
use crate::work;
use ladder_instructions::{Op, StateType};
use std::cmp::Ordering;

/// What comes after an instruction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Onward {
    /// The next one.
    Next,
    /// A later one of the same block.
    Skip(u32),
    /// The next one; what was done counts for this many further blocks.
    Work(u32),
    /// [`Machine::flow`](super::Machine::flow) decides.
    Flow,
}

/// Executes one instruction, all in one choice. It is called in one place for each kind of scan, and is to become part
/// of the machine's loop there: the instructions that run straight through then come back to its head at once.
#[inline(always)]
#[allow(
    clippy::inline_always,
    reason = "a call for each instruction takes as long as the instruction"
)]
pub(super) fn execute<const FORCED: bool>(
    memory: &mut Memory,
    rows: &mut [u8],
    code: &Code,
    instr: &Instr,
    clock: Clock,
) -> Result<Onward, Trouble> {
    match *instr {
        Instr::Record { at } => look_up(memory, &code.records[at as usize], &mut rows[at as usize]),
        Instr::Records { start, count } => {
            let run = start as usize..(start + count) as usize;
            for (record, row) in code.records[run.clone()].iter().zip(&mut rows[run]) {
                look_up(memory, record, row);
            }
        }
        Instr::Powered { out, en, end } => {
            let power = memory.bit(en);
            memory.set_bit(out, power);
            if !power {
                return Ok(Onward::Skip(end));
            }
        }
        Instr::Jump { en, .. }
        | Instr::Call { en, .. }
        | Instr::Return { en, .. }
        | Instr::End { en, .. } => {
            if memory.bit(en) {
                return Ok(Onward::Flow);
            }
        }
        Instr::Unread { .. } => {}
        Instr::Network { .. }
        | Instr::Rail { .. }
        | Instr::Mcr { .. }
        | Instr::Left { .. }
        | Instr::Finish
        | Instr::For { .. }
        | Instr::Enter { .. }
        | Instr::Turn { .. }
        | Instr::Again { .. }
        | Instr::EnterBody
        | Instr::LeaveBody => return Ok(Onward::Flow),

        Instr::Contact { out, en, tag } => {
            let power = memory.bit(en) & memory.bit(tag);
            memory.set_bit(out, power);
        }
        Instr::NegatedContact { out, en, tag } => {
            let power = memory.bit(en) & !memory.bit(tag);
            memory.set_bit(out, power);
        }
        Instr::Join { out, upper, lower } => {
            let power = memory.bit(upper) | memory.bit(lower);
            memory.set_bit(out, power);
        }
        Instr::Invert { out, en } => {
            let power = !memory.bit(en);
            memory.set_bit(out, power);
        }
        Instr::Follow { out, en } => {
            let power = memory.bit(en);
            memory.set_bit(out, power);
        }
        Instr::Rising { out, en, tag, before } => {
            let (high, was) = (memory.bit(tag), memory.bit(before));
            memory.set_bit(before, high);
            let power = memory.bit(en) && high && !was;
            memory.set_bit(out, power);
        }
        Instr::Falling { out, en, tag, before } => {
            let (high, was) = (memory.bit(tag), memory.bit(before));
            memory.set_bit(before, high);
            let power = memory.bit(en) && !high && was;
            memory.set_bit(out, power);
        }

        Instr::Compare { test, out, en, a, b } => {
            let order = memory.word(a).cmp(&memory.word(b));
            let power = memory.bit(en) & test.holds(order);
            memory.set_bit(out, power);
        }
        Instr::CompareUnsigned {
            test,
            a_unsigned,
            b_unsigned,
            out,
            en,
            a,
            b,
        } => {
            let value = |word: i64, unsigned| {
                if unsigned {
                    i128::from(word as u64)
                } else {
                    i128::from(word)
                }
            };
            let order = value(memory.word(a), a_unsigned).cmp(&value(memory.word(b), b_unsigned));
            let power = memory.bit(en) & test.holds(order);
            memory.set_bit(out, power);
        }
        Instr::CompareReal { test, out, en, a, b } => {
            // No tag holds NaN: what is not finite is a fault before it is written.
            let order = memory
                .real(a)
                .partial_cmp(&memory.real(b))
                .unwrap_or(Ordering::Less);
            let power = memory.bit(en) & test.holds(order);
            memory.set_bit(out, power);
        }
        Instr::CompareBit { test, out, en, a, b } => {
            let order = memory.bit(a).cmp(&memory.bit(b));
            let power = memory.bit(en) & test.holds(order);
            memory.set_bit(out, power);
        }
        Instr::CompareText { test, out, en, a, b } => {
            let order = memory.text(a).cmp(memory.text(b));
            let power = memory.bit(en) & test.holds(order);
            memory.set_bit(out, power);
            return Ok(length(memory, a));
        }

        Instr::Coil { en, tag } => {
            let power = memory.bit(en);
            memory.put_bit::<FORCED>(tag, power);
        }
        Instr::NegatedCoil { en, tag } => {
            let power = memory.bit(en);
            memory.put_bit::<FORCED>(tag, !power);
        }
        Instr::Set { en, tag } => {
            if memory.bit(en) {
                memory.put_bit::<FORCED>(tag, true);
            }
        }
        Instr::Reset { en, tag } => {
            if memory.bit(en) {
                memory.put_bit::<FORCED>(tag, false);
            }
        }

        Instr::MoveBit { to, from } => {
            let value = memory.bit(from);
            memory.put_bit::<FORCED>(to, value);
        }
        Instr::AndBit { to, a, b } => {
            let value = memory.bit(a) & memory.bit(b);
            memory.put_bit::<FORCED>(to, value);
        }
        Instr::OrBit { to, a, b } => {
            let value = memory.bit(a) | memory.bit(b);
            memory.put_bit::<FORCED>(to, value);
        }
        Instr::XorBit { to, a, b } => {
            let value = memory.bit(a) ^ memory.bit(b);
            memory.put_bit::<FORCED>(to, value);
        }
        Instr::NotBit { to, a } => {
            let value = !memory.bit(a);
            memory.put_bit::<FORCED>(to, value);
        }
        Instr::LoadBitOf { to, word, bit } => {
            let value = memory.word(word) >> bit & 1 != 0;
            memory.set_bit(to, value);
        }
        Instr::StoreBitOf {
            word,
            bit,
            width,
            from,
        } => {
            let mask = 1i64 << bit;
            let cleared = memory.word(word) & !mask;
            let value = if memory.bit(from) { cleared | mask } else { cleared };
            memory.put_word::<FORCED>(word, width.wrap(value));
        }

        Instr::Move { to, from } => {
            let value = memory.word(from);
            memory.put_word::<FORCED>(to, value);
        }
        Instr::MoveWhen { out, en, to, from } => {
            let power = memory.bit(en);
            memory.set_bit(out, power);
            if power {
                let value = memory.word(from);
                memory.put_word::<FORCED>(to, value);
            }
        }
        Instr::Integer { op, width, to, a, b } => {
            let value = integer(op, width, memory.word(a), memory.word(b))?;
            memory.put_word::<FORCED>(to, value);
        }
        Instr::IntegerWhen {
            op,
            width,
            out,
            en,
            to,
            a,
            b,
        } => {
            let power = memory.bit(en);
            memory.set_bit(out, power);
            if power {
                let value = integer(op, width, memory.word(a), memory.word(b))?;
                memory.put_word::<FORCED>(to, value);
            }
        }
        Instr::Real { op, single, to, a, b } => {
            let value = real(op, single, memory.real(a), memory.real(b))?;
            memory.put_word::<FORCED>(to, value.to_bits() as i64);
        }
        Instr::RealWhen {
            op,
            single,
            out,
            en,
            to,
            a,
            b,
        } => {
            let power = memory.bit(en);
            memory.set_bit(out, power);
            if power {
                let value = real(op, single, memory.real(a), memory.real(b))?;
                memory.put_word::<FORCED>(to, value.to_bits() as i64);
            }
        }
        Instr::RealFunction {
            function,
            single,
            to,
            a,
        } => {
            let value = real_function(function, single, memory.real(a))?;
            memory.put_word::<FORCED>(to, value.to_bits() as i64);
        }
        Instr::Convert { conversion, to, from } => {
            let value = convert(conversion, memory.word(from))?;
            memory.put_word::<FORCED>(to, value);
        }
        Instr::BitToWord { to, from } => {
            let value = i64::from(memory.bit(from));
            memory.put_word::<FORCED>(to, value);
        }
        Instr::MoveText { to, from } => {
            memory.copy_text::<FORCED>(to, from);
            return Ok(length(memory, from));
        }

        Instr::Index { to, index, array } => {
            let place = &code.arrays[array as usize];
            let index = memory.word(index);
            if index < place.first || index > place.last {
                return Err(Trouble::Index {
                    index,
                    first: place.first,
                    last: place.last,
                });
            }
            memory.words[to.0 as usize] = i64::from(place.base) + (index - place.first);
        }
        Instr::LoadBit { to, at } => {
            let value = memory.bit(Bit(memory.word(at) as u32));
            memory.set_bit(to, value);
        }
        Instr::StoreBit { at, from } => {
            let (to, value) = (Bit(memory.word(at) as u32), memory.bit(from));
            memory.put_bit::<FORCED>(to, value);
        }
        Instr::LoadWord { to, at } => {
            let value = memory.word(Word(memory.word(at) as u32));
            memory.words[to.0 as usize] = value;
        }
        Instr::StoreWord { at, from } => {
            let (to, value) = (Word(memory.word(at) as u32), memory.word(from));
            memory.put_word::<FORCED>(to, value);
        }
        Instr::LoadText { to, at } => {
            let from = TextSlot(memory.word(at) as u32);
            memory.copy_text::<false>(to, from);
            return Ok(length(memory, from));
        }
        Instr::StoreText { at, from } => {
            let to = TextSlot(memory.word(at) as u32);
            memory.copy_text::<FORCED>(to, from);
            return Ok(length(memory, from));
        }

        Instr::Ton {
            out,
            en,
            pt,
            bits,
            words,
        } => {
            let (input, pt) = (memory.bit(en), memory.word(pt));
            let q = Timer { bits, words }.ton::<FORCED>(memory, input, pt, clock);
            memory.set_bit(out, q);
        }
        Instr::Tof {
            out,
            en,
            pt,
            bits,
            words,
        } => {
            let (input, pt) = (memory.bit(en), memory.word(pt));
            let q = Timer { bits, words }.tof::<FORCED>(memory, input, pt, clock);
            memory.set_bit(out, q);
        }
        Instr::Tp {
            out,
            en,
            pt,
            bits,
            words,
        } => {
            let (input, pt) = (memory.bit(en), memory.word(pt));
            let q = Timer { bits, words }.tp::<FORCED>(memory, input, pt, clock);
            memory.set_bit(out, q);
        }
        Instr::Rto {
            out,
            en,
            pt,
            bits,
            words,
        } => {
            let (input, pt) = (memory.bit(en), memory.word(pt));
            let q = Timer { bits, words }.rto::<FORCED>(memory, input, pt, clock);
            memory.set_bit(out, q);
        }
        Instr::Rtof {
            out,
            en,
            pt,
            bits,
            words,
        } => {
            let (input, pt) = (memory.bit(en), memory.word(pt));
            let q = Timer { bits, words }.rtof::<FORCED>(memory, input, pt, clock);
            memory.set_bit(out, q);
        }
        Instr::Ctu {
            out,
            en,
            pv,
            bits,
            words,
        } => {
            let (input, pv) = (memory.bit(en), memory.word(pv));
            let q = Counter { bits, words }.ctu::<FORCED>(memory, input, pv);
            memory.set_bit(out, q);
        }
        Instr::Ctd {
            out,
            en,
            pv,
            bits,
            words,
        } => {
            let (input, pv) = (memory.bit(en), memory.word(pv));
            let q = Counter { bits, words }.ctd::<FORCED>(memory, input, pv);
            memory.set_bit(out, q);
        }
        Instr::Ctud {
            out,
            en,
            pv,
            bits,
            words,
        } => {
            let (input, pv) = (memory.bit(en), memory.word(pv));
            let q = Counter { bits, words }.ctud::<FORCED>(memory, input, pv);
            memory.set_bit(out, q);
        }
        Instr::Ctc {
            out,
            en,
            pv,
            bits,
            words,
        } => {
            let (input, pv) = (memory.bit(en), memory.word(pv));
            let q = Counter { bits, words }.ctc::<FORCED>(memory, input, pv);
            memory.set_bit(out, q);
        }
        Instr::Sr { out, en, reset, bits } => {
            let (set, reset) = (memory.bit(en), memory.bit(reset));
            let q = counters::sr::<FORCED>(memory, bits, set, reset);
            memory.set_bit(out, q);
        }
        Instr::Rs { out, en, reset, bits } => {
            let (set, reset) = (memory.bit(en), memory.bit(reset));
            let q = counters::rs::<FORCED>(memory, bits, set, reset);
            memory.set_bit(out, q);
        }
        Instr::StateAt {
            op,
            out,
            en,
            operand,
            bits,
            words,
        } => {
            let bits = Bit(memory.word(bits) as u32);
            let words = Word(memory.word(words) as u32);
            let q = state_at::<FORCED>(memory, op, (en, operand), (bits, words), clock);
            memory.set_bit(out, q);
        }
        Instr::ClearAt {
            en,
            state,
            bits,
            words,
        } => {
            if memory.bit(en) {
                let bits = Bit(memory.word(bits) as u32);
                let words = Word(memory.word(words) as u32);
                clear::<FORCED>(memory, state, bits, words);
            }
        }
        Instr::Clear {
            en,
            state,
            bits,
            words,
        } => {
            if memory.bit(en) {
                clear::<FORCED>(memory, state, bits, words);
            }
        }

        Instr::Routine { routine, operands } => {
            let operands = &code.operands[operands as usize..];
            return Ok(Onward::Work(routine::run::<FORCED>(
                routine, memory, operands, clock,
            )?));
        }
    }
    Ok(Onward::Next)
}

/// What going through a text counts for.
fn length(memory: &Memory, text: TextSlot) -> Onward {
    Onward::Work(work::blocks(memory.text(text).len()))
}

/// Looks up the result of a record and notes the row.
#[inline]
fn look_up(memory: &mut Memory, record: &Record, row: &mut u8) {
    let bits = memory.bits.as_mut_slice();
    let Some(last) = bits.len().checked_sub(1) else {
        return;
    };
    // There are as many bits as a power of two, so this changes no slot; and an index that cannot lie outside needs
    // no check of the bounds.
    let slot = |bit: Bit| bit.0 as usize & last;
    let [a, b, c] = record.inputs;
    let index = bits[slot(a)] | bits[slot(b)] << 1 | bits[slot(c)] << 2;
    *row = index;
    bits[slot(record.out)] = record.truth >> (index & 7) & 1;
}

/// A timer, counter or bistable that a computed index chose.
#[inline(never)]
fn state_at<const FORCED: bool>(
    memory: &mut Memory,
    op: Op,
    (en, operand): (Bit, u32),
    (bits, words): (Bit, Word),
    clock: Clock,
) -> bool {
    let (timer, counter) = (Timer { bits, words }, Counter { bits, words });
    let en = memory.bit(en);
    if let Op::Sr | Op::Rs = op {
        let reset = memory.bit(Bit(operand));
        return match op {
            Op::Sr => counters::sr::<FORCED>(memory, bits, en, reset),
            _ => counters::rs::<FORCED>(memory, bits, en, reset),
        };
    }
    let preset = memory.word(Word(operand));
    match op {
        Op::Tof => timer.tof::<FORCED>(memory, en, preset, clock),
        Op::Tp => timer.tp::<FORCED>(memory, en, preset, clock),
        Op::Rto => timer.rto::<FORCED>(memory, en, preset, clock),
        Op::Rtof => timer.rtof::<FORCED>(memory, en, preset, clock),
        Op::Ctu => counter.ctu::<FORCED>(memory, en, preset),
        Op::Ctd => counter.ctd::<FORCED>(memory, en, preset),
        Op::Ctud => counter.ctud::<FORCED>(memory, en, preset),
        Op::Ctc => counter.ctc::<FORCED>(memory, en, preset),
        _ => timer.ton::<FORCED>(memory, en, preset, clock),
    }
}

fn clear<const FORCED: bool>(memory: &mut Memory, state: StateType, bits: Bit, words: Word) {
    if state.is_timer() {
        Timer { bits, words }.clear::<FORCED>(memory, state);
    } else if state.is_counter() {
        Counter { bits, words }.clear::<FORCED>(memory, state);
    } else {
        memory.put_bit::<FORCED>(bits, false);
    }
}
