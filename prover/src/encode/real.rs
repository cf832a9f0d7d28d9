//! Reals: compared by their bits, computed where they are known, and else left open; and conversions.

use super::world::Applied;
use super::{Scan, Times};
use crate::graph::Lit;
use crate::number::Number;
use ladder_simulator::compiled::{
    Bit, Conversion, RealFunction, RealOp, Test, Width, Word, converted, real_function_of, real_of,
};

/// Of a millisecond and of a day.
const NANOSECONDS: i64 = 1_000_000;
const DAY: i64 = 86_400_000_000_000;
const NOT_TRACKED: &str = "arithmetic of reals is not tracked";
const TO_WHOLE: &str = "reals that become whole numbers are not tracked";

impl Scan<'_, '_> {
    /// The order of two finite reals is that of their bits, those of negative ones turned; 0 has two forms.
    pub(super) fn compare_real(&mut self, test: Test, a: &Number, b: &Number) -> Lit {
        let mut key = |number: &Number| {
            let sign = number.bit(63);
            let bits: Vec<Lit> = number.low(63);
            let magnitude = Number::unsigned(bits);
            let graph = &mut self.world.graph;
            let negative = graph.sub(&Number::constant(0), &magnitude);
            graph.choose_number(sign, &negative, &magnitude)
        };
        let (a, b) = (key(a), key(b));
        self.compare(test, &a, &b)
    }

    pub(super) fn real(
        &mut self,
        at: u32,
        (op, single): (RealOp, bool),
        [to, a, b]: [Word; 3],
        when: Option<[Bit; 2]>,
    ) {
        let power = self.passed(when);
        let (a, b) = (self.word(a), self.word(b));
        let (value, fault) = match (op, a.known(), b.known()) {
            (_, Some(a), Some(b)) => known(real_of(op, single, real_in(a), real_in(b))),
            (RealOp::Min, ..) => {
                let less = self.compare_real(Test::LT, &b, &a);
                (self.world.graph.choose_number(less, &b, &a), Lit::FALSE)
            }
            (RealOp::Max, ..) => {
                let greater = self.compare_real(Test::GT, &b, &a);
                (self.world.graph.choose_number(greater, &b, &a), Lit::FALSE)
            }
            _ => {
                // Of a sum and a product the order does not matter.
                let (a, b) = match op {
                    RealOp::Add | RealOp::Mul if b.low(64) < a.low(64) => (b, a),
                    _ => (a, b),
                };
                self.any_real(at, Applied::new(format!("{op:?} {single}"), &[&a, &b]))
            }
        };
        let fault = self.world.graph.and(power, fault);
        self.fault(at, fault);
        if when.is_some() {
            self.write_word_if(power, to, &value);
        } else {
            self.write_word(to, value);
        }
    }

    /// A finite real, or a fault.
    fn any_real(&mut self, at: u32, applied: Applied) -> (Number, Lit) {
        let mut bits = self.open_bits_of(NOT_TRACKED, at, applied, 65);
        let fault = bits.pop().unwrap_or(Lit::FALSE);
        let all = self.world.graph.all(bits[52..63].to_vec());
        self.world.valid.push(!all);
        (Number::of_bits(bits), fault)
    }

    pub(super) fn real_function(
        &mut self,
        at: u32,
        function: RealFunction,
        single: bool,
        [to, a]: [Word; 2],
    ) {
        let a = self.word(a);
        let (value, fault) = match (function, a.known()) {
            (_, Some(a)) => known(real_function_of(function, single, real_in(a))),
            (RealFunction::Abs | RealFunction::Neg, None) => {
                let mut bits = a.low(64);
                bits[63] = match function {
                    RealFunction::Abs => Lit::FALSE,
                    _ => !bits[63],
                };
                (Number::of_bits(bits), Lit::FALSE)
            }
            _ => self.any_real(at, Applied::new(format!("{function:?} {single}"), &[&a])),
        };
        self.fault(at, fault);
        self.write_word(to, value);
    }

    pub(super) fn convert(&mut self, at: u32, conversion: Conversion, to: Word, source: Word) {
        let from = self.word(source);
        if let Some(from) = from.known() {
            let (value, fault) = match converted(conversion, from) {
                Some(value) => (Number::constant(value), Lit::FALSE),
                None => (Number::constant(0), Lit::TRUE),
            };
            self.fault(at, fault);
            return self.write_word(to, value);
        }
        let milliseconds = Number::constant(NANOSECONDS);
        let applied = Applied::new(format!("{conversion:?}"), &[&from]);
        let (value, fault) = match conversion {
            Conversion::Wrap(width) => (from.wrapped(width), Lit::FALSE),
            Conversion::Fit { from: seen, to } => {
                let (word, fits) = self.held(from.seen_as(seen), to, false);
                (word, !fits)
            }
            Conversion::Milliseconds(width) => {
                let number = self.world.graph.mul(&from.seen_as(width), &milliseconds, 128);
                let word = number.as_word();
                let same = self.world.graph.equal(&word, &number);
                (word, !same)
            }
            Conversion::Preset(width) => {
                let graph = &mut self.world.graph;
                let number = graph.mul(&from.seen_as(width), &milliseconds, 128);
                let number = graph.min(&number, &Number::constant(i64::MAX));
                (graph.max(&number, &Number::constant(i64::MIN)), Lit::FALSE)
            }
            Conversion::Round(width) | Conversion::Truncate(width) => {
                let mut bits = self.open_bits_of(TO_WHOLE, at, applied, width.bits() as usize + 1);
                let fault = bits.pop().unwrap_or(Lit::FALSE);
                (Number::of_bits(bits).wrapped(width), fault)
            }
            Conversion::Saturate(width) => {
                let bits = self.open_bits_of(TO_WHOLE, at, applied, width.bits() as usize);
                (Number::of_bits(bits).wrapped(width), Lit::FALSE)
            }
            Conversion::ToMilliseconds(width) => {
                let milliseconds = self.milliseconds(source);
                let (word, fits) = self.held(milliseconds, width, false);
                (word, !fits)
            }
            Conversion::DayOf => {
                let (_, time_of_day) = self.world.graph.div_floor(&from, DAY);
                (self.world.graph.sub(&from, &time_of_day).as_word(), Lit::FALSE)
            }
            Conversion::TimeOfDayOf => (self.world.graph.div_floor(&from, DAY).1, Lit::FALSE),
            Conversion::RealToTime => {
                let mut bits = self.open_bits_of(TO_WHOLE, at, applied, 65);
                let fault = bits.pop().unwrap_or(Lit::FALSE);
                (Number::of_bits(bits), fault)
            }
            Conversion::IntegerToReal { .. }
            | Conversion::Single
            | Conversion::RawSingle
            | Conversion::TimeToReal { .. } => self.any_real(at, applied),
        };
        self.fault(at, fault);
        self.write_word(to, value);
    }

    /// A time in whole milliseconds, half to even. Where times are open it may be any.
    fn milliseconds(&mut self, source: Word) -> Number {
        if self.times == Times::Open {
            // No time of 64 bits has more.
            let bits: Vec<Lit> = (0..45).map(|_| self.world.graph.leaf()).collect();
            self.world.times.extend(&bits);
            return Number::of_bits(bits);
        }
        let is_counted = source == Word::TIME && self.interval % NANOSECONDS == 0;
        let Some(scans) = self.world.clock.clone().filter(|_| is_counted) else {
            let time = self.word(source);
            return self.world.graph.rounded_quotient(&time, NANOSECONDS);
        };
        let most = converted(Conversion::ToMilliseconds(Width::I64), i64::MAX).unwrap_or(i64::MAX);
        let graph = &mut self.world.graph;
        let time = graph.mul(&scans, &Number::constant(self.interval / NANOSECONDS), 128);
        graph.min(&time, &Number::constant(most))
    }
}

fn real_in(word: i64) -> f64 {
    f64::from_bits(word as u64)
}

fn known(value: Option<f64>) -> (Number, Lit) {
    match value {
        Some(value) => (Number::constant(value.to_bits() as i64), Lit::FALSE),
        None => (Number::constant(0), Lit::TRUE),
    }
}
