//! What instructions read, where they go on, and which of them may fault: what the passes over flat code ask.

use super::Instr;
use crate::memory::Bit;
use ladder_instructions::Op;

impl Instr {
    /// Whether it may end in a fault that the scan survives.
    pub const fn can_fault(&self) -> bool {
        matches!(
            self,
            Instr::Index { .. }
                | Instr::Integer { .. }
                | Instr::IntegerWhen { .. }
                | Instr::Real { .. }
                | Instr::RealWhen { .. }
                | Instr::RealFunction { .. }
                | Instr::Convert { .. }
                | Instr::Routine { .. }
        )
    }

    /// The bits that it reads. Not those of a routine or of a timer's state: they are never temporary.
    pub fn for_each_bit_read(&self, mut read: impl FnMut(Bit)) {
        use Instr as I;
        match *self {
            I::Contact { en, tag, .. } | I::NegatedContact { en, tag, .. } => {
                read(en);
                read(tag);
            }
            I::Set { en, tag } | I::Reset { en, tag } => {
                read(en);
                read(tag);
            }
            I::Rising { en, tag, before, .. } | I::Falling { en, tag, before, .. } => {
                read(en);
                read(tag);
                read(before);
            }
            I::Join {
                upper: a, lower: b, ..
            }
            | I::AndBit { a, b, .. }
            | I::OrBit { a, b, .. }
            | I::XorBit { a, b, .. } => {
                read(a);
                read(b);
            }
            I::CompareBit { en, a, b, .. } => {
                read(en);
                read(a);
                read(b);
            }
            I::Sr { en, reset, .. } | I::Rs { en, reset, .. } => {
                read(en);
                read(reset);
            }
            I::StateAt { op, en, operand, .. } => {
                read(en);
                if matches!(op, Op::Sr | Op::Rs) {
                    read(Bit(operand));
                }
            }
            I::Invert { en, .. }
            | I::Follow { en, .. }
            | I::Compare { en, .. }
            | I::CompareUnsigned { en, .. }
            | I::CompareReal { en, .. }
            | I::CompareText { en, .. }
            | I::Coil { en, .. }
            | I::NegatedCoil { en, .. }
            | I::Powered { en, .. }
            | I::MoveWhen { en, .. }
            | I::IntegerWhen { en, .. }
            | I::RealWhen { en, .. }
            | I::Ton { en, .. }
            | I::Tof { en, .. }
            | I::Tp { en, .. }
            | I::Rto { en, .. }
            | I::Rtof { en, .. }
            | I::Ctu { en, .. }
            | I::Ctd { en, .. }
            | I::Ctud { en, .. }
            | I::Ctc { en, .. }
            | I::Clear { en, .. }
            | I::ClearAt { en, .. }
            | I::Jump { en, .. }
            | I::Call { en, .. }
            | I::Return { en, .. }
            | I::End { en, .. }
            | I::For { en, .. }
            | I::Mcr { en } => read(en),
            I::NotBit { a: from, .. }
            | I::MoveBit { from, .. }
            | I::StoreBitOf { from, .. }
            | I::BitToWord { from, .. }
            | I::StoreBit { from, .. } => read(from),
            I::Rail { .. }
            | I::LoadBitOf { .. }
            | I::Move { .. }
            | I::Integer { .. }
            | I::Real { .. }
            | I::RealFunction { .. }
            | I::Convert { .. }
            | I::MoveText { .. }
            | I::Index { .. }
            | I::LoadBit { .. }
            | I::LoadWord { .. }
            | I::StoreWord { .. }
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
            | I::Turn { .. }
            | I::Again
            | I::EnterBody
            | I::LeaveBody => {}
        }
    }

    /// The instructions that it may go on at, other than the one after it.
    pub fn for_each_target(mut self, mut target: impl FnMut(u32)) {
        self.for_each_target_mut(|to| target(*to));
    }

    /// The same, to change them.
    pub fn for_each_target_mut(&mut self, mut target: impl FnMut(&mut u32)) {
        match self {
            Instr::Powered { end, .. } => target(end),
            Instr::Jump { to, .. } | Instr::Call { to, .. } => target(to),
            Instr::Enter { body, after } => {
                target(body);
                target(after);
            }
            _ => {}
        }
    }
}
