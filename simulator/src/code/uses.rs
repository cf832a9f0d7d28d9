//! Which cells instructions read, write and remember: one table for the passes over flat code and for those who translate it
//! further.

use super::Instr;
use crate::layout::{counter, state_size, timer};
use crate::memory::Bit;
use crate::uses::{Access, Cell};
use ladder_instructions::Op;

type Use = (Cell, Access);

fn read(cell: impl Into<Cell>) -> Use {
    (cell.into(), Access::Read)
}

fn write(cell: impl Into<Cell>) -> Use {
    (cell.into(), Access::Write)
}

fn change(cell: impl Into<Cell>) -> Use {
    (cell.into(), Access::Change)
}

impl Instr {
    /// The cells that it names, what it reads before what it writes. Elements are found by its array, the cells of a state by
    /// the words that tell where it is, those of a routine in its own table. Cells of texts are not among them.
    #[rustfmt::skip]
    pub fn for_each_use(&self, each: &mut dyn FnMut(Cell, Access)) {
        use Instr as I;
        let mut tell = |uses: &[Use]| uses.iter().for_each(|(cell, access)| each(*cell, *access));
        match *self {
            I::Contact { out, en, tag } | I::NegatedContact { out, en, tag } => {
                tell(&[read(en), read(tag), write(out)]);
            }
            I::Join { out, upper: a, lower: b } => tell(&[read(a), read(b), write(out)]),
            I::Invert { out, en } | I::Follow { out, en } | I::Powered { out, en, .. } | I::CompareText { out, en, .. } => {
                tell(&[read(en), write(out)]);
            }
            I::Rail { out } => tell(&[write(out)]),
            I::Rising { out, en, tag, before } | I::Falling { out, en, tag, before } => {
                tell(&[read(en), read(tag), read(before), change(before), write(out)]);
            }
            I::Compare { out, en, a, b, .. }
            | I::CompareUnsigned { out, en, a, b, .. }
            | I::CompareReal { out, en, a, b, .. } => tell(&[read(en), read(a), read(b), write(out)]),
            I::CompareBit { out, en, a, b, .. } => tell(&[read(en), read(a), read(b), write(out)]),
            I::Coil { en, tag } | I::NegatedCoil { en, tag } => tell(&[read(en), write(tag)]),
            I::Set { en, tag } | I::Reset { en, tag } => tell(&[read(en), read(tag), change(tag)]),
            I::MoveBit { to, from } | I::NotBit { to, a: from } => tell(&[read(from), write(to)]),
            I::AndBit { to, a, b } | I::OrBit { to, a, b } | I::XorBit { to, a, b } => {
                tell(&[read(a), read(b), write(to)]);
            }
            I::LoadBitOf { to, word, .. } => tell(&[read(word), write(to)]),
            I::StoreBitOf { word, from, .. } => tell(&[read(from), change(word)]),
            I::Move { to, from } | I::Convert { to, from, .. } | I::RealFunction { to, a: from, .. } => {
                tell(&[read(from), write(to)]);
            }
            I::MoveWhen { out, en, to, from } => tell(&[read(en), read(from), change(to), write(out)]),
            I::Integer { to, a, b, .. } | I::Real { to, a, b, .. } => tell(&[read(a), read(b), write(to)]),
            I::IntegerWhen { out, en, to, a, b, .. } | I::RealWhen { out, en, to, a, b, .. } => {
                tell(&[read(en), read(a), read(b), change(to), write(out)]);
            }
            I::BitToWord { to, from } => tell(&[read(from), write(to)]),
            I::Index { to, index, .. } => tell(&[read(index), write(to)]),
            I::LoadBit { to, at } => tell(&[read(at), write(to)]),
            I::StoreBit { at, from } => tell(&[read(from), read(at)]),
            I::LoadWord { to, at } => tell(&[read(at), write(to)]),
            I::StoreWord { at, from } => tell(&[read(at), read(from)]),
            I::Ton { out, en, pt, bits, words }
            | I::Tof { out, en, pt, bits, words }
            | I::Tp { out, en, pt, bits, words }
            | I::Rto { out, en, pt, bits, words }
            | I::Rtof { out, en, pt, bits, words } => {
                tell(&[read(en), read(pt), change(words.offset(timer::PT)), read(bits.offset(timer::R))]);
                tell(&[change(bits.offset(timer::IN)), change(bits.offset(timer::Q)), write(out)]);
                tell(&[change(Cell::Timer(bits)), change(Cell::Elapsed(words.offset(timer::ET)))]);
            }
            I::Ctu { out, en, pv, bits, words }
            | I::Ctd { out, en, pv, bits, words }
            | I::Ctud { out, en, pv, bits, words }
            | I::Ctc { out, en, pv, bits, words } => {
                tell(&[read(en), read(pv)]);
                tell(&[counter::PV, counter::CV].map(|member| change(words.offset(member))));
                tell(&[counter::CD, counter::R, counter::LD].map(|member| read(bits.offset(member))));
                let members = [counter::CU, counter::Q, counter::QD, counter::CHANGED];
                tell(&members.map(|member| change(bits.offset(member))));
                tell(&[counter::UP_BEFORE, counter::DOWN_BEFORE].map(|member| change(bits.offset(member))));
                tell(&[write(out)]);
            }
            I::Sr { out, en, reset, bits } | I::Rs { out, en, reset, bits } => {
                tell(&[read(en), read(reset), change(bits), write(out)]);
            }
            I::StateAt { op, en, operand, bits, words, .. } => {
                tell(&[read(en)]);
                if matches!(op, Op::Sr | Op::Rs) {
                    tell(&[read(Bit(operand))]);
                }
                tell(&[read(bits), read(words)]);
            }
            I::ClearAt { en, bits, words, .. } => tell(&[read(en), read(bits), read(words)]),
            I::Clear { en, state, bits, words } => {
                tell(&[read(en)]);
                if state.is_counter() {
                    tell(&[change(words.offset(counter::CV))]);
                }
                let (count, _) = state_size(state);
                (0..count).for_each(|n| tell(&[change(bits.offset(n))]));
                if state.is_timer() {
                    tell(&[change(Cell::Timer(bits)), change(Cell::Elapsed(words.offset(timer::ET)))]);
                }
            }
            I::For { en, turns, .. } => tell(&[read(en), read(turns)]),
            I::Turn { to, .. } => tell(&[write(to)]),
            I::Jump { en, .. } | I::Call { en, .. } | I::Return { en, .. } | I::End { en, .. } | I::Mcr { en } => {
                tell(&[read(en)]);
            }
            I::MoveText { .. }
            | I::LoadText { .. }
            | I::StoreText { .. }
            | I::Record { .. }
            | I::Records { .. }
            | I::Routine { .. }
            | I::Unread { .. }
            | I::Network { .. }
            | I::Left { .. }
            | I::Finish
            | I::Enter { .. }
            | I::Again { .. }
            | I::EnterBody
            | I::LeaveBody => {}
        }
    }
}
