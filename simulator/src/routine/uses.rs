//! Which cells routines read and write.

use super::{Routine, TYPES};
use crate::layout::{counter, timer};
use crate::memory::{Bit, Word};
use crate::uses::{Access, Cell};
use ladder_analysis::values::types::Scalar;
use std::ops::Range;

/// Tells each use.
struct Uses<'r, 'e> {
    range: &'r dyn Fn([u32; 2]) -> Option<Range<u32>>,
    each: &'e mut dyn FnMut(Cell, Access),
}

impl Uses<'_, '_> {
    fn bit(&mut self, at: u32, access: Access) {
        (self.each)(Cell::Bit(Bit(at)), access);
    }

    fn word(&mut self, at: u32, access: Access) {
        (self.each)(Cell::Word(Word(at)), access);
    }

    fn bits(&mut self, all: &[u32], access: Access) {
        for &at in all {
            self.bit(at, access);
        }
    }

    fn words(&mut self, all: &[u32], access: Access) {
        for &at in all {
            self.word(at, access);
        }
    }

    /// The elements of a range, and the words that tell it.
    fn range(&mut self, words: [u32; 2], is_bits: bool, access: Access) {
        self.words(&words, Access::Read);
        match (self.range)(words) {
            Some(range) if is_bits => range.for_each(|at| self.bit(at, access)),
            Some(range) => range.for_each(|at| self.word(at, access)),
            None if access == Access::Read => {}
            None => (self.each)(Cell::Unknown, access),
        }
    }

    fn bits_of(&mut self, first: u32, members: &[u32], access: Access) {
        for n in members {
            self.bit(first + n, access);
        }
    }

    fn words_of(&mut self, first: u32, members: &[u32], access: Access) {
        for n in members {
            self.word(first + n, access);
        }
    }

    /// The power of a block with a state, and what all such blocks have: power, EN, preset.
    fn block(&mut self, [out, en, preset]: [u32; 3]) {
        self.bit(en, Access::Read);
        self.word(preset, Access::Read);
        self.bit(out, Access::Write);
    }
}

impl Routine {
    /// The cells that it reads and writes, with these operands. Those of texts are not among them. `range` says among which slots
    /// the elements are of a range that two words tell.
    pub fn for_each_use(
        self,
        pool: &[u32],
        range: &dyn Fn([u32; 2]) -> Option<Range<u32>>,
        each: &mut dyn FnMut(Cell, Access),
    ) {
        use Access::{Change, Read, Write};
        use Routine as R;
        let mut uses = Uses { range, each };
        match (self, pool) {
            (R::Range, [from, to, _, first, last, start, count, ..]) => {
                uses.words(&[*from, *to, *first, *last], Read);
                uses.words(&[*start, *count], Write);
            }
            (R::RangeFrom, [from, count, _, first, last, start, ..]) => {
                uses.words(&[*from, *count, *first, *last], Read);
                uses.word(*start, Write);
            }
            (R::AllHigh | R::AllLow, [to, start, count, ..]) => {
                uses.range([*start, *count], true, Read);
                uses.bit(*to, Write);
            }
            (R::FillBits | R::ShiftBits, [start, count, from, ..]) => {
                uses.bit(*from, Read);
                uses.range([*start, *count], true, Change);
            }
            (R::FillWords | R::ShiftWords, [start, count, from, ..]) => {
                uses.word(*from, Read);
                uses.range([*start, *count], false, Change);
            }
            (R::SetBits | R::ResetBits, [en, start, count, ..]) => {
                uses.bit(*en, Read);
                uses.range([*start, *count], true, Change);
            }
            (R::CopyBits | R::RepeatBits, [to, to_count, from, from_count, ..]) => {
                uses.range([*from, *from_count], true, Read);
                uses.range([*to, *to_count], true, Change);
            }
            (R::CopyWords | R::RepeatWords, [to, to_count, from, from_count, ..]) => {
                uses.range([*from, *from_count], false, Read);
                uses.range([*to, *to_count], false, Change);
            }
            (R::FillTexts | R::ShiftTexts, [start, count, ..]) => uses.words(&[*start, *count], Read),
            (R::CopyTexts | R::RepeatTexts, [to, to_count, from, from_count, ..]) => {
                uses.words(&[*to, *to_count, *from, *from_count], Read);
            }
            (R::PackBits, [to, _, start, count, ..]) => {
                uses.range([*start, *count], true, Read);
                uses.word(*to, Change);
            }
            (R::PackWords | R::Sum, [to, _, start, count, ..]) => {
                uses.range([*start, *count], false, Read);
                uses.word(*to, Change);
            }
            (R::UnpackBits, [start, count, from, ..]) => {
                uses.word(*from, Read);
                uses.range([*start, *count], true, Change);
            }
            (R::UnpackWords, [start, count, _, from, ..]) => {
                uses.word(*from, Read);
                uses.range([*start, *count], false, Change);
            }
            (R::Search, [y, _, first, _, a, _, start, count, element, _, next, found, ..]) => {
                let is_bits = type_of(*element) == Scalar::Bool;
                uses.words(&[*y, *first], Read);
                uses.bit(*next, Read);
                if is_bits {
                    uses.bit(*a, Read);
                } else if !type_of(*element).is_string() {
                    uses.word(*a, Read);
                }
                if type_of(*element).is_string() {
                    uses.words(&[*start, *count], Read);
                } else {
                    uses.range([*start, *count], is_bits, Read);
                }
                uses.word(*y, Change);
                uses.bit(*found, Change);
            }
            (R::SelectBit, [to, selector, count, list @ ..]) => {
                uses.word(*selector, Read);
                let list = &list[..(*count as usize).min(list.len())];
                uses.bits(list, Read);
                uses.bit(*to, Change);
            }
            (R::SelectWord, [to, selector, count, list @ ..]) => {
                uses.word(*selector, Read);
                uses.words(&list[..(*count as usize).min(list.len())], Read);
                uses.word(*to, Change);
            }
            (R::Curve, [to, _, x, count, list @ ..]) => {
                uses.word(*x, Read);
                uses.words(&list[..(*count as usize).min(list.len())], Read);
                uses.word(*to, Change);
            }
            (R::OpenTable | R::OpenCurve, [to, hit, _, index, count, list @ ..]) => {
                uses.word(*index, Read);
                uses.words(&list[..(*count as usize).min(list.len())], Read);
                uses.word(*to, Change);
                uses.bit(*hit, Write);
            }
            (R::Length | R::Find | R::Parse, [to, ..]) => uses.word(*to, Change),
            (R::ParseBit, [to, ..]) => uses.bit(*to, Change),
            (R::Enumerate, [to, _, from, ..]) => {
                uses.word(*from, Read);
                uses.word(*to, Change);
            }
            (R::Receive | R::ReceiveNewest, [to, came, ..]) => {
                uses.word(*to, Change);
                uses.bit(*came, Write);
            }
            (R::SendScanTime, [last, ..]) => uses.word(*last, Change),
            (R::SendWhenFree, [out, en, from, free, ..]) => {
                uses.bit(*en, Read);
                uses.word(*from, Read);
                uses.word(*free, Change);
                uses.bit(*out, Write);
            }
            (R::SendTextSlowly, [out, en, _, _, number, free, sent, rest, before, blank, ..]) => {
                uses.bit(*en, Read);
                uses.word(*number, Read);
                uses.words(&[*free, *sent, *rest], Change);
                uses.bits(&[*before, *blank], Change);
                uses.bit(*out, Write);
            }
            (R::ScanTon | R::ScanTof | R::ScanRto, [out, en, pt, bits, words, started, ..]) => {
                uses.block([*out, *en, *pt]);
                uses.bit(*started, Change);
                uses.bits_of(*bits, &[timer::IN, timer::Q], Change);
                uses.words_of(*words, &[timer::PT, timer::ET], Change);
            }
            (R::WrappingCtu | R::WrappingCtd | R::WrappingCtc, [out, en, pv, bits, words, before, ..]) => {
                uses.block([*out, *en, *pv]);
                uses.bit(*before, Change);
                uses.bits_of(*bits, &[counter::CU, counter::Q, counter::CHANGED], Change);
                uses.words_of(*words, &[counter::PV, counter::CV], Change);
            }
            (R::TickTon | R::TickTof, [out, en, pt, bits, words, base, interval, ..]) => {
                uses.block([*out, *en, *pt]);
                uses.words(&[*base, *interval], Read);
                uses.bits_of(*bits, &[timer::IN, timer::Q], Change);
                uses.words_of(*words, &[timer::PT, timer::ET], Change);
                (uses.each)(Cell::Timer(Bit(*bits)), Change);
            }
            (R::TickReset, [en, bits, words, start, ..]) => {
                uses.bit(*en, Read);
                uses.word(*start, Read);
                uses.bits_of(*bits, &[timer::IN, timer::Q], Change);
                uses.word(*words + timer::ET, Change);
                (uses.each)(Cell::Timer(Bit(*bits)), Change);
            }
            (R::LatchingCtu | R::LatchingCtd, [out, en, pv, bits, words, ..]) => {
                uses.block([*out, *en, *pv]);
                uses.bits_of(*bits, &[counter::CU, counter::Q, counter::CHANGED], Change);
                uses.words_of(*words, &[counter::PV, counter::CV], Change);
            }
            (R::LatchingReset, [en, bits, words, start, ..]) => {
                uses.bit(*en, Read);
                uses.word(*start, Read);
                uses.bits_of(*bits, &[counter::Q, counter::CHANGED], Change);
                uses.word(*words + counter::CV, Change);
            }
            (
                R::UnitTon | R::UnitTof | R::UnitRto | R::UnitRtof,
                [out, en, pt, bits, words, unit, interval, rest, ..],
            ) => {
                uses.block([*out, *en, *pt]);
                uses.words(&[*unit, *interval], Read);
                uses.bit(*bits + timer::R, Read);
                uses.bits_of(*bits, &[timer::IN, timer::Q], Change);
                uses.words_of(*words, &[timer::PT, timer::ET], Change);
                uses.word(*rest, Change);
                (uses.each)(Cell::Timer(Bit(*bits)), Change);
            }
            (R::ComparingCtu | R::ComparingCtd | R::ComparingCtud, [out, en, pv, bits, words, ..]) => {
                uses.block([*out, *en, *pv]);
                uses.bits_of(*bits, &[counter::CD, counter::R, counter::LD], Read);
                let members = [
                    counter::CU,
                    counter::Q,
                    counter::QD,
                    counter::CHANGED,
                    counter::UP_BEFORE,
                    counter::DOWN_BEFORE,
                ];
                uses.bits_of(*bits, &members, Change);
                uses.words_of(*words, &[counter::PV, counter::CV], Change);
            }
            (R::Step, [to, _, _, a, b, zero, range, ..]) => {
                uses.words(&[*a, *b], Read);
                uses.word(*to, Write);
                uses.bits(&[*zero, *range], Change);
            }
            (R::Cut | R::Clamp | R::Round, [to, _, from, _, zero, range, ..]) => {
                uses.word(*from, Read);
                uses.bit(*zero, Read);
                uses.word(*to, Write);
                uses.bit(*range, Change);
            }
            (R::Controller, [bits, _, bit_count, words, _, word_count, interval, ..]) => {
                uses.word(*interval, Read);
                (0..*bit_count).for_each(|n| uses.bit(bits + n, Change));
                (0..*word_count).for_each(|n| uses.word(words + n, Change));
            }
            (R::EndOnDivision, [division, ..]) => uses.bit(*division, Read),
            // Texts, and the serial port: nothing of what they write is tracked.
            _ => {}
        }
    }

    /// Whether it may end in a fault that the scan survives.
    pub const fn can_fault(self) -> bool {
        use Routine as R;
        matches!(
            self,
            R::CopyTexts
                | R::CopyBits
                | R::CopyWords
                | R::PackBits
                | R::PackWords
                | R::Sum
                | R::Curve
                | R::Left
                | R::Right
                | R::Middle
                | R::Insert
                | R::Delete
                | R::Replace
                | R::Parse
                | R::ParseBit
                | R::Step
        )
    }
}

/// A type as an operand; one that is not elementary is an enumeration.
pub fn type_of(operand: u32) -> Scalar {
    TYPES.get(operand as usize).copied().unwrap_or(Scalar::Dint)
}
