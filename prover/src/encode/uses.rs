//! Which cells instructions read and write.

pub(super) use super::routine_uses::routine_uses;
use super::slots::Reach;
use super::unread::each_written;
use ladder_instructions::Op;
use ladder_simulator::compiled::{Bit, Code, Instr, Word, counter, timer};
use std::ops::Range;

/// How a cell is used.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Access {
    Read,
    /// Written in any case where the instruction runs.
    Write,
    /// Written where something holds, or read before.
    Change,
}

/// A cell of memory.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Cell {
    Bit(Bit),
    Word(Word),
    /// What a timer is doing, and since when: by its first bit.
    Timer(Bit),
    /// The ET of a timer, which it writes.
    Elapsed(Word),
    /// Any: it is not known which.
    Unknown,
}

/// Each use of a cell in a stretch of code, with its instruction.
pub(super) fn for_each_access(
    code: &Code,
    reach: &Reach,
    stretch: Range<u32>,
    each: &mut dyn FnMut(u32, Cell, Access),
) {
    for at in stretch {
        let Some(instr) = code.instrs.get(at as usize) else {
            return;
        };
        let each = &mut |cell, access| each(at, cell, access);
        for_each_use(instr, each);
        match *instr {
            Instr::StoreBit { at: slot, .. } => stored(reach, slot, &|n| Cell::Bit(Bit(n)), each),
            Instr::StoreWord { at: slot, .. } => stored(reach, slot, &|n| Cell::Word(Word(n)), each),
            Instr::StateAt { .. } | Instr::ClearAt { .. } => match chosen(reach, instr) {
                None => each(Cell::Unknown, Access::Change),
                Some(all) => all.for_each(|(_, _, instr)| for_each_use(&instr, each)),
            },
            Instr::Unread { at: number } => {
                each_written(&code.unread[number as usize], reach, &mut |_, cell| {
                    each(cell, Access::Change);
                });
            }
            Instr::Routine { routine, operands } => {
                routine_uses(routine, &code.operands[operands as usize..], reach, each);
            }
            _ => {}
        }
    }
}

fn stored(reach: &Reach, slot: Word, cell: &dyn Fn(u32) -> Cell, each: &mut dyn FnMut(Cell, Access)) {
    match reach.slots(slot) {
        Some(slots) => slots.each().for_each(|n| each(cell(n), Access::Change)),
        None => each(Cell::Unknown, Access::Change),
    }
}

/// The instructions that one whose timer, counter or bistable is chosen by an index may be: with the slots of their bits and
/// words. None: it is not known which.
pub(super) fn chosen(
    reach: &Reach,
    instr: &Instr,
) -> Option<impl Iterator<Item = (u32, u32, Instr)> + use<>> {
    let (Instr::StateAt { bits, words, .. } | Instr::ClearAt { bits, words, .. }) = *instr else {
        return None;
    };
    let (bits, words) = (reach.slots(bits)?, reach.slots(words)?);
    // A bistable has no words.
    if words.count() != 1 && words.count() != bits.count() {
        return None;
    }
    let instr = *instr;
    let last = words.each().last()?;
    let words = words.each().chain(std::iter::repeat(last));
    Some(
        bits.each()
            .zip(words)
            .map(move |(bits, words)| (bits, words, fixed(instr, Bit(bits), Word(words)))),
    )
}

/// The same for a timer, counter or bistable that is known.
fn fixed(instr: Instr, bits: Bit, words: Word) -> Instr {
    use Instr as I;
    let (op, out, en, operand) = match instr {
        I::StateAt {
            op, out, en, operand, ..
        } => (op, out, en, operand),
        I::ClearAt { en, state, .. } => {
            return I::Clear {
                en,
                state,
                bits,
                words,
            };
        }
        other => return other,
    };
    let (pt, pv, reset) = (Word(operand), Word(operand), Bit(operand));
    #[rustfmt::skip]
    let instr = match op {
        Op::Tof => I::Tof { out, en, pt, bits, words },
        Op::Tp => I::Tp { out, en, pt, bits, words },
        Op::Rto => I::Rto { out, en, pt, bits, words },
        Op::Rtof => I::Rtof { out, en, pt, bits, words },
        Op::Ctu => I::Ctu { out, en, pv, bits, words },
        Op::Ctd => I::Ctd { out, en, pv, bits, words },
        Op::Ctud => I::Ctud { out, en, pv, bits, words },
        Op::Ctc => I::Ctc { out, en, pv, bits, words },
        Op::Sr => I::Sr { out, en, reset, bits },
        Op::Rs => I::Rs { out, en, reset, bits },
        _ => I::Ton { out, en, pt, bits, words },
    };
    instr
}

/// The cells that an instruction names. Those of elements are found by its array.
pub(super) fn for_each_use(instr: &Instr, each: &mut dyn FnMut(Cell, Access)) {
    use Access::{Change, Read, Write};
    use Instr as I;
    let mut reads = Vec::new();
    instr.for_each_bit_read(|bit| reads.push(bit));
    for bit in reads {
        each(Cell::Bit(bit), Read);
    }
    let mut word = |word: Word, access| each(Cell::Word(word), access);
    match *instr {
        I::Compare { a, b, .. } | I::CompareUnsigned { a, b, .. } | I::CompareReal { a, b, .. } => {
            word(a, Read);
            word(b, Read);
        }
        I::LoadBitOf { word: from, .. } => word(from, Read),
        I::StoreBitOf { word: to, .. } => word(to, Change),
        I::Move { to, from } | I::Convert { to, from, .. } | I::RealFunction { to, a: from, .. } => {
            word(from, Read);
            word(to, Write);
        }
        I::MoveWhen { to, from, .. } => {
            word(from, Read);
            word(to, Change);
        }
        I::Integer { to, a, b, .. } | I::Real { to, a, b, .. } => {
            word(a, Read);
            word(b, Read);
            word(to, Write);
        }
        I::IntegerWhen { to, a, b, .. } | I::RealWhen { to, a, b, .. } => {
            word(a, Read);
            word(b, Read);
            word(to, Change);
        }
        I::BitToWord { to, .. } | I::Turn { to, .. } => word(to, Write),
        I::Index { to, index, .. } => {
            word(index, Read);
            word(to, Write);
        }
        I::LoadWord { to, at } => {
            word(at, Read);
            word(to, Write);
        }
        I::StoreWord { at, from } => {
            word(at, Read);
            word(from, Read);
        }
        I::LoadBit { at, .. } | I::StoreBit { at, .. } => word(at, Read),
        I::Ton { pt, words, .. }
        | I::Tof { pt, words, .. }
        | I::Tp { pt, words, .. }
        | I::Rto { pt, words, .. }
        | I::Rtof { pt, words, .. } => {
            word(pt, Read);
            word(words.offset(timer::PT), Change);
        }
        I::Ctu { pv, words, .. }
        | I::Ctd { pv, words, .. }
        | I::Ctud { pv, words, .. }
        | I::Ctc { pv, words, .. } => {
            word(pv, Read);
            word(words.offset(counter::PV), Change);
            word(words.offset(counter::CV), Change);
        }
        I::Clear { state, words, .. } if state.is_counter() => {
            word(words.offset(counter::CV), Change);
        }
        I::StateAt { bits, words, .. } | I::ClearAt { bits, words, .. } => {
            word(bits, Read);
            word(words, Read);
        }
        I::For { turns, .. } => word(turns, Read),
        _ => {}
    }
    let mut bit = |bit: Bit, access| each(Cell::Bit(bit), access);
    match *instr {
        I::Contact { out, .. }
        | I::NegatedContact { out, .. }
        | I::Join { out, .. }
        | I::Invert { out, .. }
        | I::Follow { out, .. }
        | I::Rail { out }
        | I::Compare { out, .. }
        | I::CompareUnsigned { out, .. }
        | I::CompareReal { out, .. }
        | I::CompareBit { out, .. }
        | I::CompareText { out, .. }
        | I::Powered { out, .. }
        | I::MoveWhen { out, .. }
        | I::IntegerWhen { out, .. }
        | I::RealWhen { out, .. }
        | I::LoadBitOf { to: out, .. }
        | I::LoadBit { to: out, .. }
        | I::Coil { tag: out, .. }
        | I::NegatedCoil { tag: out, .. }
        | I::MoveBit { to: out, .. }
        | I::AndBit { to: out, .. }
        | I::OrBit { to: out, .. }
        | I::XorBit { to: out, .. }
        | I::NotBit { to: out, .. } => bit(out, Write),
        I::Set { tag, .. } | I::Reset { tag, .. } => bit(tag, Change),
        I::Rising { out, before, .. } | I::Falling { out, before, .. } => {
            bit(before, Change);
            bit(out, Write);
        }
        I::Ton { out, bits, words, .. }
        | I::Tof { out, bits, words, .. }
        | I::Tp { out, bits, words, .. }
        | I::Rto { out, bits, words, .. }
        | I::Rtof { out, bits, words, .. } => {
            bit(bits.offset(timer::R), Read);
            bit(bits.offset(timer::IN), Change);
            bit(bits.offset(timer::Q), Change);
            bit(out, Write);
            each(Cell::Timer(bits), Change);
            each(Cell::Elapsed(words.offset(timer::ET)), Change);
        }
        I::Ctu { out, bits, .. }
        | I::Ctd { out, bits, .. }
        | I::Ctud { out, bits, .. }
        | I::Ctc { out, bits, .. } => {
            for member in [counter::CD, counter::R, counter::LD] {
                bit(bits.offset(member), Read);
            }
            for member in [
                counter::CU,
                counter::Q,
                counter::QD,
                counter::CHANGED,
                counter::UP_BEFORE,
                counter::DOWN_BEFORE,
            ] {
                bit(bits.offset(member), Change);
            }
            bit(out, Write);
        }
        I::Sr { out, bits, .. } | I::Rs { out, bits, .. } => {
            bit(bits, Change);
            bit(out, Write);
        }
        I::Clear {
            state, bits, words, ..
        } => {
            let (count, _) = ladder_simulator::compiled::state_size(state);
            for n in 0..count {
                bit(bits.offset(n), Change);
            }
            if state.is_timer() {
                each(Cell::Timer(bits), Change);
                each(Cell::Elapsed(words.offset(timer::ET)), Change);
            }
        }
        _ => {}
    }
}
