//! The instructions that run straight through.

use super::Scan;
use super::controller::Relay;
use super::world::{Applied, Gap};
use crate::graph::Lit;
use crate::number::Number;
use ladder_analysis::program::Location;
use ladder_instructions::Controller;
use ladder_simulator::compiled::{Bit, Instr, Test, Width, Word};
use std::cmp::Ordering;

impl Scan<'_, '_> {
    pub(super) fn bit(&mut self, bit: Bit) -> Lit {
        self.memory.bit(self.world, bit)
    }

    pub(super) fn word(&mut self, word: Word) -> Number {
        self.memory.word(self.world, word)
    }

    /// Writes a bit where execution is.
    /// The power of a block that passes it on, from the second of these cells to the first; of one without it is always there.
    pub(super) fn passed(&mut self, when: Option<[Bit; 2]>) -> Lit {
        let Some([out, en]) = when else {
            return Lit::TRUE;
        };
        let power = self.bit(en);
        self.write_bit(out, power);
        power
    }

    pub(super) fn write_bit(&mut self, to: Bit, value: Lit) {
        if to == Bit::LOW || to == Bit::HIGH {
            return;
        }
        let value = if self.act == Lit::TRUE || self.memory.is_temporary_bit(to) {
            value
        } else {
            let old = self.bit(to);
            self.world.graph.choose(self.act, value, old)
        };
        self.memory.set_bit(to, value);
    }

    /// The same, where a condition holds as well.
    pub(super) fn write_bit_if(&mut self, condition: Lit, to: Bit, value: Lit) {
        let old = self.bit(to);
        let value = self.world.graph.choose(condition, value, old);
        self.write_bit(to, value);
    }

    pub(super) fn write_word(&mut self, to: Word, value: Number) {
        let value = if self.act == Lit::TRUE || self.memory.is_temporary_word(to) {
            value
        } else {
            let old = self.word(to);
            self.world.graph.choose_number(self.act, &value, &old)
        };
        self.memory.set_word(to, value);
    }

    pub(super) fn write_word_if(&mut self, condition: Lit, to: Word, value: &Number) {
        let old = self.word(to);
        let value = self.world.graph.choose_number(condition, value, &old);
        self.write_word(to, value);
    }

    pub(super) fn location(&self, at: u32) -> Option<Location> {
        let block = self.code.blocks.get(self.code.block_at(at) as usize)?;
        self.located.then_some(block.location)
    }

    /// Nothing can be expressed of a network that is followed alone, and of a program nothing of what it writes.
    pub(super) fn block(&mut self, what: impl Into<String>, at: u32) {
        let what = what.into();
        if self.alone.is_none() {
            return self.stop(&what, at);
        }
        let location = self.location(at);
        self.world.block(what, location);
    }

    /// Bits that may be anything.
    pub(super) fn open_bits(&mut self, what: impl Into<String>, at: u32, count: usize) -> Vec<Lit> {
        let location = self.location(at);
        let what = what.into();
        self.world.open_bits(Gap { what, location }, count)
    }

    /// The same, of what depends on some bits alone.
    pub(super) fn open_bits_of(
        &mut self,
        what: impl Into<String>,
        at: u32,
        applied: Applied,
        count: usize,
    ) -> Vec<Lit> {
        let (what, location) = (what.into(), self.location(at));
        self.world.open_bits_of(Gap { what, location }, applied, count)
    }

    /// A fault where this holds: the block has no power, and what follows it goes on.
    pub(super) fn fault(&mut self, at: u32, condition: Lit) {
        self.fault_of(at, None, condition);
    }

    /// The same, with what a controller that has relays for errors reports it with.
    pub(super) fn fault_of(&mut self, at: u32, relay: Option<Relay>, condition: Lit) {
        let faults = self.world.graph.and(self.act, condition);
        if faults == Lit::FALSE {
            return;
        }
        let Some(block) = self.code.blocks.get(self.code.block_at(at) as usize) else {
            return self.stop("a fault outside of all blocks", at);
        };
        if block.controller == Controller::Banks {
            self.signal(at, relay, faults);
        } else {
            self.faulted = self.world.graph.or(self.faulted, faults);
        }
        if block.out != Bit::LOW && block.out != Bit::HIGH {
            let power = self.bit(block.out);
            let power = self.world.graph.and(power, !faults);
            self.memory.set_bit(block.out, power);
        }
        self.leave(faults, block.end);
    }

    /// Whether two numbers are in this order.
    pub(super) fn compare(&mut self, test: Test, a: &Number, b: &Number) -> Lit {
        let graph = &mut self.world.graph;
        let (less, equal) = (graph.less(a, b), graph.equal(a, b));
        self.holds(test, less, equal)
    }

    pub(super) fn holds(&mut self, test: Test, less: Lit, equal: Lit) -> Lit {
        let graph = &mut self.world.graph;
        let greater = graph.and(!less, !equal);
        let orders = [
            (Ordering::Less, less),
            (Ordering::Equal, equal),
            (Ordering::Greater, greater),
        ];
        let [one, two, three] = orders.map(|(order, lit)| if test.holds(order) { lit } else { Lit::FALSE });
        if test == Test::NE {
            return !equal;
        }
        if test == Test::GE {
            return !less;
        }
        let either = graph.or(one, two);
        graph.or(either, three)
    }

    fn power(&mut self, out: Bit, en: Bit, condition: Lit) {
        let en = self.bit(en);
        let power = self.world.graph.and(en, condition);
        self.write_bit(out, power);
    }

    fn edge(&mut self, out: Bit, en: Bit, [tag, before]: [Bit; 2], rising: bool) {
        let (high, was) = (self.bit(tag), self.bit(before));
        self.write_bit(before, high);
        let is_edge = self
            .world
            .graph
            .and(high.negated_if(!rising), was.negated_if(rising));
        self.power(out, en, is_edge);
    }

    #[allow(clippy::too_many_lines, reason = "one line for each instruction")]
    pub(super) fn instr(&mut self, at: u32, instr: Instr) {
        use Instr as I;
        match instr {
            I::Contact { out, en, tag } => {
                let tag = self.bit(tag);
                self.power(out, en, tag);
            }
            I::NegatedContact { out, en, tag } => {
                let tag = self.bit(tag);
                self.power(out, en, !tag);
            }
            I::Join {
                out: to,
                upper: a,
                lower: b,
            }
            | I::OrBit { to, a, b } => {
                let (a, b) = (self.bit(a), self.bit(b));
                let value = self.world.graph.or(a, b);
                self.write_bit(to, value);
            }
            I::Invert { out: to, en: from }
            | I::NotBit { to, a: from }
            | I::NegatedCoil { tag: to, en: from } => {
                let value = !self.bit(from);
                self.write_bit(to, value);
            }
            I::Follow { out: to, en: from } | I::MoveBit { to, from } | I::Coil { tag: to, en: from } => {
                let value = self.bit(from);
                self.write_bit(to, value);
            }
            I::Rising { out, en, tag, before } => self.edge(out, en, [tag, before], true),
            I::Falling { out, en, tag, before } => self.edge(out, en, [tag, before], false),
            I::Compare { test, out, en, a, b } => {
                let (a, b) = (self.word(a), self.word(b));
                let holds = self.compare(test, &a, &b);
                self.power(out, en, holds);
            }
            I::CompareUnsigned {
                test,
                a_unsigned,
                b_unsigned,
                out,
                en,
                a,
                b,
            } => {
                let seen =
                    |number: Number, unsigned| number.seen_as(if unsigned { Width::U64 } else { Width::I64 });
                let (a, b) = (seen(self.word(a), a_unsigned), seen(self.word(b), b_unsigned));
                let holds = self.compare(test, &a, &b);
                self.power(out, en, holds);
            }
            I::CompareReal { test, out, en, a, b } => {
                let (a, b) = (self.word(a), self.word(b));
                let holds = self.compare_real(test, &a, &b);
                self.power(out, en, holds);
            }
            I::CompareBit { test, out, en, a, b } => {
                let (a, b) = (self.bit(a), self.bit(b));
                let (less, equal) = (self.world.graph.and(!a, b), self.world.graph.same(a, b));
                let holds = self.holds(test, less, equal);
                self.power(out, en, holds);
            }
            I::CompareText { out, en, .. } => {
                let holds = self.open_bits("texts are not tracked", at, 1)[0];
                self.power(out, en, holds);
            }
            I::Set { en, tag } => {
                let en = self.bit(en);
                self.write_bit_if(en, tag, Lit::TRUE);
            }
            I::Reset { en, tag } => {
                let en = self.bit(en);
                self.write_bit_if(en, tag, Lit::FALSE);
            }
            I::AndBit { to, a, b } => {
                let (a, b) = (self.bit(a), self.bit(b));
                let value = self.world.graph.and(a, b);
                self.write_bit(to, value);
            }
            I::XorBit { to, a, b } => {
                let (a, b) = (self.bit(a), self.bit(b));
                let value = self.world.graph.xor(a, b);
                self.write_bit(to, value);
            }
            I::LoadBitOf { to, word, bit } => {
                let value = self.word(word).bit(usize::from(bit));
                self.write_bit(to, value);
            }
            I::StoreBitOf {
                word,
                bit,
                width,
                from,
            } => {
                let mut bits = self.word(word).low(64);
                bits[usize::from(bit)] = self.bit(from);
                self.write_word(word, Number::of_bits(bits).wrapped(width));
            }
            I::Move { to, from } => {
                let value = self.word(from);
                self.write_word(to, value);
            }
            I::MoveWhen { out, en, to, from } => {
                let (power, value) = (self.bit(en), self.word(from));
                self.write_bit(out, power);
                self.write_word_if(power, to, &value);
            }
            I::BitToWord { to, from } => {
                let value = Number::of_bit(self.bit(from));
                self.write_word(to, value);
            }
            I::Integer { op, width, to, a, b } => self.integer(at, op, width, [to, a, b], None),
            I::IntegerWhen {
                op,
                width,
                out,
                en,
                to,
                a,
                b,
            } => {
                self.integer(at, op, width, [to, a, b], Some([out, en]));
            }
            I::Real { op, single, to, a, b } => self.real(at, (op, single), [to, a, b], None),
            I::RealWhen {
                op,
                single,
                out,
                en,
                to,
                a,
                b,
            } => {
                self.real(at, (op, single), [to, a, b], Some([out, en]));
            }
            I::RealFunction {
                function,
                single,
                to,
                a,
            } => self.real_function(at, function, single, [to, a]),
            I::Convert { conversion, to, from } => self.convert(at, conversion, to, from),
            // Texts are not tracked: who asks for one gets anything.
            I::MoveText { .. } | I::StoreText { .. } if self.alone.is_some() => {
                self.block("texts are not followed", at);
            }
            I::MoveText { .. } | I::LoadText { .. } | I::StoreText { .. } => {}
            I::Index { to, index, array } => self.index(at, to, index, array),
            I::LoadBit { to, at: slot } => self.load_bit(at, to, slot),
            I::StoreBit { at: slot, from } => self.store_bit(at, slot, from),
            I::LoadWord { to, at: slot } => self.load_word(at, to, slot),
            I::StoreWord { at: slot, from } => self.store_word(at, slot, from),
            I::Ton {
                out,
                en,
                pt,
                bits,
                words,
            } => self.ton([out, en, bits], [pt, words], at),
            I::Tof {
                out,
                en,
                pt,
                bits,
                words,
            } => self.tof([out, en, bits], [pt, words], at),
            I::Tp {
                out,
                en,
                pt,
                bits,
                words,
            } => self.tp([out, en, bits], [pt, words], at),
            I::Rto {
                out,
                en,
                pt,
                bits,
                words,
            } => self.rto([out, en, bits], [pt, words], at),
            I::Rtof {
                out,
                en,
                pt,
                bits,
                words,
            } => self.rtof([out, en, bits], [pt, words], at),
            I::Ctu {
                out,
                en,
                pv,
                bits,
                words,
            } => self.ctu([out, en, bits], [pv, words]),
            I::Ctd {
                out,
                en,
                pv,
                bits,
                words,
            } => self.ctd([out, en, bits], [pv, words]),
            I::Ctud {
                out,
                en,
                pv,
                bits,
                words,
            } => self.ctud([out, en, bits], [pv, words]),
            I::Ctc {
                out,
                en,
                pv,
                bits,
                words,
            } => self.ctc([out, en, bits], [pv, words]),
            I::Sr { out, en, reset, bits } => {
                let (set, reset, q) = (self.bit(en), self.bit(reset), self.bit(bits));
                let kept = self.world.graph.and(q, !reset);
                let value = self.world.graph.or(set, kept);
                self.write_bit(bits, value);
                self.write_bit(out, value);
            }
            I::Rs { out, en, reset, bits } => {
                let (set, reset, q) = (self.bit(en), self.bit(reset), self.bit(bits));
                let kept = self.world.graph.or(set, q);
                let value = self.world.graph.and(kept, !reset);
                self.write_bit(bits, value);
                self.write_bit(out, value);
            }
            I::Clear {
                en,
                state,
                bits,
                words,
            } => self.clear(en, state, bits, words),
            I::StateAt { bits, .. } | I::ClearAt { bits, .. } => self.chosen_state(at, instr, bits),
            I::Routine { routine, operands } => self.routine(at, routine, operands),
            I::Record { .. } | I::Records { .. } => self.block("code that was put together", at),
            I::Unread { at: number } => self.unread(at, number),
            I::Rail { .. }
            | I::Powered { .. }
            | I::Network { .. }
            | I::Left { .. }
            | I::Jump { .. }
            | I::Call { .. }
            | I::Return { .. }
            | I::End { .. }
            | I::Finish
            | I::For { .. }
            | I::Enter { .. }
            | I::Turn { .. }
            | I::Again { .. }
            | I::Mcr { .. }
            | I::EnterBody
            | I::LeaveBody => {}
        }
    }
}
