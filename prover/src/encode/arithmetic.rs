//! Whole numbers, and elements whose index is computed.

use super::Scan;
use super::controller::Relay;
use super::uses::Cell;
use crate::graph::Lit;
use crate::number::Number;
use ladder_simulator::compiled::{Bit, IntegerOp, Width, Word};

/// An array with more elements than this is not followed element by element.
pub(super) const MOST_ELEMENTS: usize = 1024;

impl Scan<'_, '_> {
    pub(super) fn integer(
        &mut self,
        at: u32,
        op: IntegerOp,
        width: Width,
        [to, a, b]: [Word; 3],
        when: Option<[Bit; 2]>,
    ) {
        let power = self.passed(when);
        let (a, b) = (self.word(a), self.word(b));
        let (value, fault) = self.integer_value(at, op, width, &a, &b);
        let fault = self.world.graph.and(power, fault);
        let relay = matches!(op, IntegerOp::Div | IntegerOp::Mod).then_some(Relay::Zero);
        self.fault_of(at, relay, fault);
        let value = value.wrapped(width);
        if when.is_some() {
            self.write_word_if(power, to, &value);
        } else {
            self.write_word(to, value);
        }
    }

    /// The value before it is brought into its width, and whether there is none.
    fn integer_value(
        &mut self,
        at: u32,
        op: IntegerOp,
        width: Width,
        a: &Number,
        b: &Number,
    ) -> (Number, Lit) {
        let none = Lit::FALSE;
        let zero = Number::constant(0);
        let bits = width.bits() as usize;
        let (x, y) = (a.seen_as(width), b.seen_as(width));
        let bitwise = |graph: &mut crate::graph::Graph,
                       each: &dyn Fn(&mut crate::graph::Graph, Lit, Lit) -> Lit| {
            let len = a.len().max(b.len());
            let value = (0..len).map(|n| each(graph, a.bit(n), b.bit(n))).collect();
            Number::of_bits(value)
        };
        let graph = &mut self.world.graph;
        match op {
            IntegerOp::Add => (graph.add(a, b), none),
            IntegerOp::Sub => (graph.sub(a, b), none),
            IntegerOp::Mul => (graph.mul(a, b, bits), none),
            IntegerOp::Div => (graph.div(&x, &y).0, graph.equal(b, &zero)),
            IntegerOp::Mod => (graph.div(&x, &y).1, graph.equal(b, &zero)),
            IntegerOp::And => (bitwise(graph, &|graph, a, b| graph.and(a, b)), none),
            IntegerOp::Or => (bitwise(graph, &|graph, a, b| graph.or(a, b)), none),
            IntegerOp::Xor => (bitwise(graph, &|graph, a, b| graph.xor(a, b)), none),
            IntegerOp::Min => (graph.min(&x, &y), none),
            IntegerOp::Max => (graph.max(&x, &y), none),
            IntegerOp::Abs => (graph.abs(&x), none),
            IntegerOp::Power => self.power_of(at, width, a, b),
            IntegerOp::Shl | IntegerOp::Shr | IntegerOp::Rol | IntegerOp::Ror => {
                (self.shifted(op, bits, a, b), b.sign())
            }
        }
    }

    /// By an exponent that is known and small, or of a base that is known; any other is left open.
    fn power_of(&mut self, at: u32, width: Width, a: &Number, b: &Number) -> (Number, Lit) {
        let unsigned = width == Width::U64;
        if let Some(exponent @ 0..=16) = b.known() {
            let mut value = Number::constant(1);
            for _ in 0..exponent {
                value = self.world.graph.mul(&value, a, 64);
            }
            return (value, Lit::FALSE);
        }
        let fault = if unsigned { Lit::FALSE } else { b.sign() };
        if let Some(base) = a.known() {
            return (self.power_of_known(width, base, &b.seen_as(width)), fault);
        }
        let value = self.open_bits("powers of a tag by a tag are not tracked", at, 64);
        (Number::of_bits(value), fault)
    }

    /// Of a base that is known: its squares are, and each bit of the exponent says whether one of them is a factor.
    fn power_of_known(&mut self, width: Width, base: i64, exponent: &Number) -> Number {
        let bits = width.bits() as usize;
        let (mut value, mut square) = (Number::constant(1), base);
        for n in 0..exponent.len() {
            let factor = Number::constant(square).wrapped(width);
            let graph = &mut self.world.graph;
            let with = graph.mul(&value, &factor, bits);
            value = graph.choose_number(exponent.bit(n), &with, &value).wrapped(width);
            square = square.wrapping_mul(square);
        }
        value
    }

    /// Bits moved by a number of places that is not negative.
    fn shifted(&mut self, op: IntegerOp, bits: usize, a: &Number, places: &Number) -> Number {
        let mut value = a.low(bits);
        let turns = matches!(op, IntegerOp::Rol | IntegerOp::Ror);
        let up = matches!(op, IntegerOp::Shl | IntegerOp::Rol);
        let stages = bits.trailing_zeros() as usize;
        let graph = &mut self.world.graph;
        for stage in 0..stages {
            let (which, by) = (places.bit(stage), 1 << stage);
            let moved = |n: usize| -> Lit {
                match (up, turns) {
                    (true, true) => value[(n + bits - by) % bits],
                    (false, true) => value[(n + by) % bits],
                    (true, false) => n.checked_sub(by).map_or(Lit::FALSE, |from| value[from]),
                    (false, false) => value.get(n + by).copied().unwrap_or(Lit::FALSE),
                }
            };
            value = (0..bits)
                .map(|n| graph.choose(which, moved(n), value[n]))
                .collect();
        }
        if !turns {
            let rest: Vec<Lit> = (stages..places.len()).map(|n| places.bit(n)).collect();
            let far = graph.any(rest);
            value = value.into_iter().map(|bit| graph.and(bit, !far)).collect();
        }
        // What stays as it is, stays with its sign.
        let moved = Number::unsigned(value);
        if !turns {
            return moved;
        }
        let none = graph.any(places.low(stages));
        graph.choose_number(none, &moved, a)
    }

    /// The slot of an element.
    pub(super) fn index(&mut self, at: u32, to: Word, index: Word, array: u32) {
        let place = self.code.arrays[array as usize];
        let index = self.word(index);
        let graph = &mut self.world.graph;
        let below = graph.less(&index, &Number::constant(place.first));
        let above = graph.less(&Number::constant(place.last), &index);
        let outside = graph.or(below, above);
        self.fault_of(at, Some(Relay::Address), outside);
        let base = Number::constant(i64::from(place.base) - place.first);
        let slot = self.world.graph.add(&index, &base);
        self.write_word(to, slot.as_word());
    }

    /// The slots that a word may mean, each with whether it does. None: they are too many, or not known.
    fn slots(&mut self, slot: Word) -> Option<Vec<(u32, Lit)>> {
        let number = self.word(slot);
        if let Some(known) = number.known() {
            return Some(vec![(known as u32, Lit::TRUE)]);
        }
        let slots = self
            .reach
            .slots(slot)
            .filter(|slots| slots.count() <= MOST_ELEMENTS)?;
        let each = slots.each().map(|element| {
            let is_it = self
                .world
                .graph
                .equal(&number, &Number::constant(i64::from(element)));
            (element, is_it)
        });
        Some(each.collect())
    }

    pub(super) fn load_bit(&mut self, at: u32, to: Bit, slot: Word) {
        let Some(slots) = self.slots(slot) else {
            return self.open_cells(at, vec![Cell::Bit(to)], VERY_LARGE);
        };
        let mut value = Lit::FALSE;
        for (element, is_it) in slots {
            let bit = self.bit(Bit(element));
            value = self.world.graph.choose(is_it, bit, value);
        }
        self.write_bit(to, value);
    }

    pub(super) fn load_word(&mut self, at: u32, to: Word, slot: Word) {
        let Some(slots) = self.slots(slot) else {
            return self.open_cells(at, vec![Cell::Word(to)], VERY_LARGE);
        };
        let mut value = Number::constant(0);
        for (n, (element, is_it)) in slots.into_iter().enumerate() {
            let word = self.word(Word(element));
            value = match n {
                0 => word,
                _ => self.world.graph.choose_number(is_it, &word, &value),
            };
        }
        self.write_word(to, value);
    }

    pub(super) fn store_bit(&mut self, at: u32, slot: Word, from: Bit) {
        let value = self.bit(from);
        let Some(slots) = self.slots(slot) else {
            return self.open_elements(at, slot, &|slot| Cell::Bit(Bit(slot)));
        };
        for (element, is_it) in slots {
            self.write_bit_if(is_it, Bit(element), value);
        }
    }

    pub(super) fn store_word(&mut self, at: u32, slot: Word, from: Word) {
        let value = self.word(from);
        let Some(slots) = self.slots(slot) else {
            return self.open_elements(at, slot, &|slot| Cell::Word(Word(slot)));
        };
        for (element, is_it) in slots {
            self.write_word_if(is_it, Word(element), &value);
        }
    }

    /// One of very many elements is written: each may be it.
    fn open_elements(&mut self, at: u32, slot: Word, cell: &dyn Fn(u32) -> Cell) {
        let Some(slots) = self.reach.slots(slot) else {
            return self.stop(VERY_LARGE, at);
        };
        self.open_cells(at, slots.each().map(cell).collect(), VERY_LARGE);
    }
}

const VERY_LARGE: &str = "an index reaches into a very large array";
