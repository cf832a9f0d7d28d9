//! Arithmetic that notes what goes wrong and goes on, as Click controllers have it.

use super::Scan;
use super::ranges::{is_whole, width};
use crate::graph::Lit;
use crate::number::Number;
use ladder_simulator::compiled::{Bit, Routine, Width, Word, type_of};

/// The operations in the order of their operands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Operation {
    Add,
    Subtract,
    Multiply,
    Divide,
    DivideUnlessZero,
    Remainder,
    RemainderUnlessZero,
    Modulo,
    Least,
    Greatest,
}

impl Operation {
    const fn of(operand: u32) -> Option<Operation> {
        Some(match operand {
            0 => Operation::Add,
            1 => Operation::Subtract,
            2 => Operation::Multiply,
            3 => Operation::Divide,
            4 => Operation::DivideUnlessZero,
            5 => Operation::Remainder,
            6 => Operation::RemainderUnlessZero,
            7 => Operation::Modulo,
            9 => Operation::Least,
            10 => Operation::Greatest,
            _ => return None,
        })
    }
}

impl Scan<'_, '_> {
    /// A step of a formula. None: it is not followed.
    pub(super) fn step(&mut self, pool: &[u32]) -> Option<()> {
        let [to, step, ty, a, b, zero, range, ..] = *pool else {
            return None;
        };
        let step = Operation::of(step).filter(|_| is_whole(ty))?;
        let [a, b] = [a, b].map(|word| self.word(Word(word)).seen_as(width(ty)));
        let none = Number::constant(0);
        let graph = &mut self.world.graph;
        let is_zero = graph.equal(&b, &none);
        let value = match step {
            Operation::Add => graph.add(&a, &b),
            Operation::Subtract => graph.sub(&a, &b),
            Operation::Multiply => graph.mul(&a, &b, 128),
            Operation::Divide => graph.div(&a, &b).0,
            Operation::DivideUnlessZero => {
                let quotient = graph.div(&a, &b).0;
                graph.choose_number(is_zero, &a, &quotient)
            }
            Operation::Remainder => graph.div(&a, &b).1,
            Operation::RemainderUnlessZero => {
                let rest = graph.div(&a, &b).1;
                graph.choose_number(is_zero, &none, &rest)
            }
            Operation::Modulo => {
                let rest = graph.div(&a, &b).1;
                let sum = graph.add(&rest, &b);
                graph.div(&sum, &b).1
            }
            Operation::Least => graph.min(&a, &b),
            Operation::Greatest => graph.max(&a, &b),
        };
        let divides = matches!(step, Operation::Divide | Operation::Remainder | Operation::Modulo);
        let slips = self.world.graph.and(Lit::constant(divides), is_zero);
        let (held, fits) = self.held(value, width(ty), false);
        let value = self.world.graph.choose_number(slips, &none, &held);
        let wraps = self.world.graph.and(!slips, !fits);
        self.write_word(Word(to), value);
        self.write_bit_if(slips, Bit(zero), Lit::TRUE);
        self.write_bit_if(wraps, Bit(range), Lit::TRUE);
        Some(())
    }

    /// The result of a formula, or a number in another type. None: it is not followed.
    pub(super) fn brought(&mut self, routine: Routine, pool: &[u32]) -> Option<()> {
        let [to, to_type, from, from_type, zero, range, ..] = *pool else {
            return None;
        };
        if !is_whole(to_type) || !is_whole(from_type) {
            return None;
        }
        let number = self.word(Word(from)).seen_as(width(from_type));
        let clamps = routine == Routine::Clamp && !type_of(to_type).is_bits();
        let (held, mut fits) = self.held(number, width(to_type), clamps);
        let mut value = held;
        if routine == Routine::Cut {
            let zero = self.bit(Bit(zero));
            value = self.world.graph.choose_number(zero, &Number::constant(0), &value);
            fits = self.world.graph.or(fits, zero);
        }
        self.write_word(Word(to), value);
        self.write_bit_if(!fits, Bit(range), Lit::TRUE);
        Some(())
    }

    /// The word that holds a number in a width, cut or held at its ends, and whether it fits.
    pub(super) fn held(&mut self, number: Number, width: Width, clamps: bool) -> (Number, Lit) {
        let graph = &mut self.world.graph;
        let wrapped = number.wrapped(width);
        let fits = graph.equal(&wrapped.seen_as(width), &number);
        if !clamps {
            return (wrapped, fits);
        }
        let (least, most) = match width {
            Width::U64 => (Number::constant(0), Number::constant(-1).seen_as(Width::U64)),
            _ => {
                let (least, most) = width.ends();
                (Number::constant(least), Number::constant(most))
            }
        };
        let clamped = graph.max(&number, &least);
        let clamped = graph.min(&clamped, &most);
        (clamped.wrapped(width), fits)
    }
}
