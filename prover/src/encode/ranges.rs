//! Ranges of arrays: found, filled, copied, shifted, packed, added up. Where their ends are known only while the program
//! runs, each cell that may be in one is chosen by whether it is.

use super::Scan;
use super::arithmetic::MOST_ELEMENTS;
use super::controller::Relay;
use crate::graph::Lit;
use crate::number::Number;
use ladder_analysis::values::compound::EnumId;
use ladder_analysis::values::types::Scalar;
use ladder_simulator::compiled::{Bit, Routine, TYPES, Width, Word, type_of};
use std::ops::Range;

/// A range.
pub(super) struct Span {
    start: Number,
    count: Number,
    /// The slots among which it is: those of the range itself where its ends are known.
    pub(super) slots: Range<u32>,
    is_known: bool,
}

impl Span {
    /// How far its start is from the first slot.
    fn offset(&self, graph: &mut crate::graph::Graph) -> Number {
        graph.sub(&self.start, &Number::constant(i64::from(self.slots.start)))
    }
}

impl Scan<'_, '_> {
    /// A range by the words that hold its start and how many elements it has. None: it is too large, or not known.
    pub(super) fn span(&mut self, words: [u32; 2]) -> Option<Span> {
        let [start, count] = words.map(|at| self.word(Word(at)));
        if let (Some(first), Some(len)) = (start.known(), count.known()) {
            let slots = u32::try_from(first).ok()?..u32::try_from(first.checked_add(len)?).ok()?;
            return Some(Span {
                start,
                count,
                slots,
                is_known: true,
            });
        }
        let slots = self.reach.range(words)?;
        (slots.len() <= MOST_ELEMENTS).then_some(Span {
            start,
            count,
            slots,
            is_known: false,
        })
    }

    /// Whether a slot is in a range.
    pub(super) fn is_in(&mut self, span: &Span, slot: u32) -> Lit {
        if span.is_known {
            return Lit::TRUE;
        }
        let slot = Number::constant(i64::from(slot));
        let graph = &mut self.world.graph;
        let end = graph.add(&span.start, &span.count);
        let (before, below) = (graph.less(&slot, &span.start), graph.less(&slot, &end));
        graph.and(!before, below)
    }

    /// Whether a range has more elements than this.
    fn is_longer(&mut self, span: &Span, than: usize) -> Lit {
        let than = Number::constant(than as i64);
        self.world.graph.less(&than, &span.count)
    }

    /// These values, moved by a number of places that is not negative: to the front, or to the back.
    fn moved(&mut self, mut values: Vec<Number>, places: &Number, to_front: bool) -> Vec<Number> {
        let none = Number::constant(0);
        let mut by = 1;
        for stage in 0.. {
            if by >= values.len() || stage >= places.len() {
                break;
            }
            let which = places.bit(stage);
            let old = |n: usize| {
                let from = if to_front { Some(n + by) } else { n.checked_sub(by) };
                from.and_then(|from| values.get(from)).unwrap_or(&none)
            };
            let graph = &mut self.world.graph;
            values = (0..values.len())
                .map(|n| graph.choose_number(which, old(n), &values[n]))
                .collect();
            by *= 2;
        }
        values
    }

    /// The elements of a range in their order; what is after the last is anything.
    fn elements(&mut self, span: &Span, is_bits: bool) -> Vec<Number> {
        let values = span.slots.clone().map(|slot| self.slot(slot, is_bits));
        let values = values.collect();
        let places = span.offset(&mut self.world.graph);
        self.moved(values, &places, true)
    }

    fn slot(&mut self, slot: u32, is_bits: bool) -> Number {
        if is_bits {
            Number::of_bit(self.bit(Bit(slot)))
        } else {
            self.word(Word(slot))
        }
    }

    /// Writes values into the elements of a range, in their order.
    fn put(&mut self, span: &Span, mut values: Vec<Number>, is_bits: bool) {
        values.resize(span.slots.len(), Number::constant(0));
        let places = span.offset(&mut self.world.graph);
        let values = self.moved(values, &places, false);
        self.put_at(span, values, is_bits);
    }

    /// Writes a value for each slot among which a range is, where it is in the range.
    fn put_at(&mut self, span: &Span, values: Vec<Number>, is_bits: bool) {
        for (slot, value) in span.slots.clone().zip(values) {
            let is_in = self.is_in(span, slot);
            if is_bits {
                self.write_bit_if(is_in, Bit(slot), value.bit(0));
            } else {
                self.write_word_if(is_in, Word(slot), &value);
            }
        }
    }

    /// The words that hold where a range is.
    fn find_range(&mut self, at: u32, pool: &[u32], has_count: bool) {
        let [from, to, base, first, last, start, rest @ ..] = pool else {
            return;
        };
        let [from, to, first, last] = [*from, *to, *first, *last].map(|at| self.word(Word(at)));
        let graph = &mut self.world.graph;
        // The other word is the last index, or how many elements there are.
        let to = if has_count {
            to
        } else {
            let end = graph.add(&from, &to);
            graph.sub(&end, &Number::constant(1))
        };
        let mut outside = Lit::FALSE;
        for index in [&from, &to] {
            let (below, above) = (graph.less(index, &first), graph.less(&last, index));
            let either = graph.or(below, above);
            outside = graph.or(outside, either);
        }
        if has_count {
            let is_empty = graph.less(&to, &from);
            outside = graph.or(outside, is_empty);
        }
        self.fault_of(at, Some(Relay::Address), outside);
        let graph = &mut self.world.graph;
        let places = graph.sub(&from, &first);
        let slot = graph.add(&places, &Number::constant(i64::from(*base)));
        let more = graph.sub(&to, &from);
        let len = graph.add(&more, &Number::constant(1));
        self.write_word(Word(*start), slot.as_word());
        if let (true, [count, ..]) = (has_count, rest) {
            self.write_word(Word(*count), len.as_word());
        }
    }

    /// A routine on ranges. False: it is another.
    pub(super) fn on_ranges(&mut self, at: u32, routine: Routine, pool: &[u32]) -> bool {
        match routine {
            Routine::Range => self.find_range(at, pool, true),
            Routine::RangeFrom => self.find_range(at, pool, false),
            Routine::Enumerate => self.enumerate(at, pool),
            _ => match self.on_spans(at, routine, pool) {
                Some(()) => {}
                None if is_on_ranges(routine) => {
                    self.open_routine(
                        at,
                        routine,
                        pool,
                        "ranges of very large arrays, and reals in them, are not tracked",
                    );
                }
                None => return false,
            },
        }
        true
    }

    /// None: it is not followed.
    fn on_spans(&mut self, at: u32, routine: Routine, pool: &[u32]) -> Option<()> {
        let is_bits = |bits: Routine| routine == bits;
        match (routine, pool) {
            (Routine::AllHigh | Routine::AllLow, [to, start, count, ..]) => {
                let span = self.span([*start, *count])?;
                let mut all = Lit::TRUE;
                for slot in span.slots.clone() {
                    let bit = self.bit(Bit(slot)).negated_if(routine == Routine::AllLow);
                    let is_in = self.is_in(&span, slot);
                    let holds = self.world.graph.or(!is_in, bit);
                    all = self.world.graph.and(all, holds);
                }
                self.write_bit(Bit(*to), all);
            }
            (Routine::FillBits | Routine::FillWords, [start, count, from, ..]) => {
                let span = self.span([*start, *count])?;
                let value = self.slot(*from, is_bits(Routine::FillBits));
                let values = vec![value; span.slots.len()];
                self.put_at(&span, values, is_bits(Routine::FillBits));
            }
            (Routine::SetBits | Routine::ResetBits, [en, start, count, ..]) => {
                let span = self.span([*start, *count])?;
                let en = self.bit(Bit(*en));
                for slot in span.slots.clone() {
                    let is_in = self.is_in(&span, slot);
                    let is_in = self.world.graph.and(is_in, en);
                    self.write_bit_if(is_in, Bit(slot), Lit::constant(routine == Routine::SetBits));
                }
            }
            (Routine::CopyBits | Routine::CopyWords, [to, to_count, from, from_count, ..]) => {
                let (to, from) = (self.span([*to, *to_count])?, self.span([*from, *from_count])?);
                let same = self.world.graph.equal(&to.count, &from.count);
                self.fault_of(at, Some(Relay::Address), !same);
                // As if through a buffer.
                let values = self.elements(&from, is_bits(Routine::CopyBits));
                self.put(&to, values, is_bits(Routine::CopyBits));
            }
            (Routine::CopyTexts, [_, to_count, _, from_count, ..]) => {
                let (to, from) = (self.word(Word(*to_count)), self.word(Word(*from_count)));
                let same = self.world.graph.equal(&to, &from);
                self.fault_of(at, Some(Relay::Address), !same);
            }
            (Routine::RepeatBits | Routine::RepeatWords, [to, to_count, from, from_count, ..]) => {
                let (to, from) = (self.span([*to, *to_count])?, self.span([*from, *from_count])?);
                let len = usize::try_from(from.count.known()?).ok()?.max(1);
                let values = self.elements(&from, is_bits(Routine::RepeatBits));
                let values = values.get(..len)?.iter().cycle().take(to.slots.len());
                let values = values.cloned().collect();
                self.put(&to, values, is_bits(Routine::RepeatBits));
            }
            (Routine::ShiftBits | Routine::ShiftWords, [start, count, entering, ..]) => {
                let span = self.span([*start, *count])?;
                let is_bits = is_bits(Routine::ShiftBits);
                let entering = self.slot(*entering, is_bits);
                let mut values = Vec::with_capacity(span.slots.len());
                for slot in span.slots.clone() {
                    let first = Number::constant(i64::from(slot));
                    let is_first = self.world.graph.equal(&first, &span.start);
                    let before = match slot.checked_sub(1).filter(|_| slot > span.slots.start) {
                        Some(before) => self.slot(before, is_bits),
                        None => entering.clone(),
                    };
                    values.push(self.world.graph.choose_number(is_first, &entering, &before));
                }
                self.put_at(&span, values, is_bits);
            }
            (Routine::PackBits, [to, ty, start, count, ..]) if is_whole(*ty) => {
                let span = self.span([*start, *count])?;
                self.pack(at, (*to, width(*ty)), &span, None);
            }
            (Routine::PackWords, [to, ty, start, count, part, ..]) if is_whole(*ty) && is_whole(*part) => {
                let span = self.span([*start, *count])?;
                self.pack(at, (*to, width(*ty)), &span, Some(width(*part)));
            }
            (Routine::UnpackBits, [start, count, from, ty, ..]) if is_whole(*ty) => {
                let span = self.span([*start, *count])?;
                let value = self.word(Word(*from)).low(width(*ty).bits() as usize);
                let values = value.into_iter().map(Number::of_bit).collect();
                self.put(&span, values, true);
            }
            (Routine::UnpackWords, [start, count, part, from, ty, ..])
                if is_whole(*ty) && is_whole(*part) =>
            {
                let span = self.span([*start, *count])?;
                let value = self.word(Word(*from)).low(width(*ty).bits() as usize);
                let parts = value.chunks(width(*part).bits() as usize);
                let values = parts.map(|bits| Number::unsigned(bits.to_vec()).wrapped(width(*part)));
                let values = values.collect();
                self.put(&span, values, false);
            }
            (Routine::Sum, [to, ty, start, count, element, ..]) if is_whole(*ty) && is_whole(*element) => {
                let span = self.span([*start, *count])?;
                let mut total = Number::constant(0);
                for slot in span.slots.clone() {
                    let (is_in, value) = (self.is_in(&span, slot), self.word(Word(slot)));
                    let graph = &mut self.world.graph;
                    let value = graph.choose_number(is_in, &value, &Number::constant(0));
                    total = graph.add(&total, &value).wrapped(width(*ty));
                }
                self.write_word(Word(*to), total);
            }
            _ => return None,
        }
        Some(())
    }

    /// Bits, or words of a width, into a word, the first as its lowest part.
    fn pack(&mut self, at: u32, (to, width): (u32, Width), span: &Span, part: Option<Width>) {
        let part_bits = part.map_or(1, |part| part.bits() as usize);
        let room = width.bits() as usize / part_bits;
        let is_longer = self.is_longer(span, room);
        self.fault_of(at, Some(Relay::Address), is_longer);
        let mut bits = Vec::new();
        for (n, value) in self
            .elements(span, part.is_none())
            .into_iter()
            .take(room)
            .enumerate()
        {
            let is_there = self.is_longer(span, n);
            let value = value.low(part_bits).into_iter();
            bits.extend(value.map(|bit| self.world.graph.and(bit, is_there)));
        }
        self.write_word(Word(to), Number::unsigned(bits).wrapped(width));
    }

    /// A number as a value of an enumeration.
    fn enumerate(&mut self, at: u32, pool: &[u32]) {
        let [to, ty, from, ..] = *pool else { return };
        let value = self.word(Word(from));
        if let Some(id) = ty.checked_sub(TYPES.len() as u32).and_then(EnumId::from_number) {
            let graph = &mut self.world.graph;
            let id = id.get();
            let is_one: Vec<Lit> = (id.values.iter())
                .map(|(_, named)| graph.equal(&value, &Number::constant(i64::from(*named))))
                .collect();
            let is_valid = graph.any(is_one);
            self.fault_of(at, Some(Relay::Range), !is_valid);
        }
        self.write_word(Word(to), value);
    }
}

fn is_on_ranges(routine: Routine) -> bool {
    use Routine as R;
    matches!(
        routine,
        R::AllHigh
            | R::AllLow
            | R::FillBits
            | R::FillWords
            | R::RepeatBits
            | R::RepeatWords
            | R::SetBits
            | R::ResetBits
            | R::CopyBits
            | R::CopyWords
            | R::ShiftBits
            | R::ShiftWords
            | R::PackBits
            | R::PackWords
            | R::UnpackBits
            | R::UnpackWords
            | R::Sum
    )
}

pub(super) fn width(ty: u32) -> Width {
    Width::of(TYPES.get(ty as usize).copied().unwrap_or(Scalar::Lint))
}

pub(super) fn is_whole(ty: u32) -> bool {
    !type_of(ty).is_real()
}
