//! Which cells instructions read and write.

use super::ranges::range_of;
use ladder_simulator::compiled::{Bit, Instr, Memory as Banks, Routine, Word, counter, timer};

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
#[derive(Debug, Clone, Copy)]
pub(super) enum Cell {
    Bit(Bit),
    Word(Word),
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
        I::Clear { state, words, .. } if state.is_counter() => word(words.offset(counter::CV), Change),
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
        | I::StateAt { out, .. }
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
        I::Ton { out, bits, .. }
        | I::Tof { out, bits, .. }
        | I::Tp { out, bits, .. }
        | I::Rto { out, bits, .. }
        | I::Rtof { out, bits, .. } => {
            bit(bits.offset(timer::R), Read);
            bit(bits.offset(timer::IN), Change);
            bit(bits.offset(timer::Q), Change);
            bit(out, Write);
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
        I::Clear { state, bits, .. } => {
            let (count, _) = ladder_simulator::compiled::state_size(state);
            for n in 0..count {
                bit(bits.offset(n), Change);
            }
        }
        _ => {}
    }
}

/// The cells of a routine. Of one that is not encoded each number may be a bit or a word that it writes.
pub(super) fn routine_uses(
    routine: Routine,
    pool: &[u32],
    initial: &Banks,
    each: &mut dyn FnMut(Cell, Access),
) {
    let bit = |at: u32| Cell::Bit(Bit(at));
    let word = |at: u32| Cell::Word(Word(at));
    // A range that is known only while the program runs blocks it, so what is noted here of one does not matter.
    let mut range = |words: [u32; 2], cell: &dyn Fn(u32) -> Cell, access: Access| {
        for at in words {
            each(word(at), Access::Read);
        }
        for slot in range_of(initial, None, words).unwrap_or_default() {
            each(cell(slot), access);
        }
    };
    match (routine, pool) {
        (Routine::AllHigh | Routine::AllLow, [to, start, count, ..]) => {
            range([*start, *count], &bit, Access::Read);
            each(bit(*to), Access::Change);
        }
        (Routine::FillBits | Routine::ShiftBits, [start, count, from, ..]) => {
            range([*start, *count], &bit, Access::Change);
            each(bit(*from), Access::Read);
        }
        (Routine::FillWords | Routine::ShiftWords, [start, count, from, ..]) => {
            range([*start, *count], &word, Access::Change);
            each(word(*from), Access::Read);
        }
        (Routine::SetBits | Routine::ResetBits, [en, start, count, ..]) => {
            range([*start, *count], &bit, Access::Change);
            each(bit(*en), Access::Read);
        }
        (Routine::CopyBits, [to, to_count, from, from_count, ..]) => {
            range([*to, *to_count], &bit, Access::Change);
            range([*from, *from_count], &bit, Access::Read);
        }
        (Routine::CopyWords, [to, to_count, from, from_count, ..]) => {
            range([*to, *to_count], &word, Access::Change);
            range([*from, *from_count], &word, Access::Read);
        }
        (Routine::PackBits, [to, _, start, count, ..]) => {
            range([*start, *count], &bit, Access::Read);
            each(word(*to), Access::Change);
        }
        (Routine::UnpackBits, [start, count, from, ..]) => {
            range([*start, *count], &bit, Access::Change);
            each(word(*from), Access::Read);
        }
        (Routine::Sum, [to, _, start, count, ..]) => {
            range([*start, *count], &word, Access::Read);
            each(word(*to), Access::Change);
        }
        (Routine::Enumerate, [to, _, from, ..]) => {
            each(word(*from), Access::Read);
            each(word(*to), Access::Change);
        }
        (Routine::SelectBit, [to, selector, count, list @ ..]) => {
            each(word(*selector), Access::Read);
            for from in &list[..(*count as usize).min(list.len())] {
                each(bit(*from), Access::Read);
            }
            each(bit(*to), Access::Change);
        }
        (Routine::SelectWord, [to, selector, count, list @ ..]) => {
            each(word(*selector), Access::Read);
            for from in &list[..(*count as usize).min(list.len())] {
                each(word(*from), Access::Read);
            }
            each(word(*to), Access::Change);
        }
        _ => {
            for &number in pool {
                each(bit(number), Access::Change);
                each(word(number), Access::Change);
            }
        }
    }
}
