//! Arithmetic as in C ([`Arithmetic::OfOperands`](ladder_instructions::Arithmetic)): done in the type of the operands,
//! 32 bits at least, and then cut to that of the result.

use super::arguments::Arguments;
use super::place::Slot;
use super::{Compiler, Result};
use crate::code::Instr;
use crate::memory::{Bit, Word};
use crate::operation::{Conversion, IntegerOp, RealOp, Test, Width};
use ladder_analysis::values::types::Scalar;
use ladder_instructions::{Arithmetic, Op};

impl Compiler<'_> {
    pub(super) fn is_as_in_c(&self, op: Op) -> bool {
        self.semantics.arithmetic == Arithmetic::OfOperands && op.is_plain_arithmetic()
    }

    pub(super) fn c_arithmetic(&mut self, op: Op, arguments: Arguments, en: Bit) -> Result<Bit> {
        let (place, to) = arguments.place(0)?;
        let values = arguments.values_from(1)?;
        if to.is_string() || to == Scalar::Time || to.is_date() {
            return self.data(op, arguments, en);
        }
        let ty = values.iter().map(|value| value.ty).fold(Scalar::Dint, meeting);
        let (out, start) = self.begin_powered(en);
        let spot = self.spot(place)?;
        let mut words = Vec::with_capacity(values.len());
        for value in values {
            let slot = self.expression(value)?;
            words.push(self.promoted(slot, value.ty, ty));
        }
        let Some((&first, rest)) = words.split_first() else {
            return Err(arguments.mismatch());
        };
        let mut value = first;
        if op == Op::Not {
            let ones = self.constant(-1);
            value = self.integer(IntegerOp::Xor, ty, first, ones);
        }
        for &next in rest {
            value = self.c_step(op, ty, value, next);
        }
        let value = self.cut(value, ty, to);
        self.write_result(spot, value);
        self.end_powered(start);
        Ok(out)
    }

    fn c_step(&mut self, op: Op, ty: Scalar, a: Word, b: Word) -> Word {
        let (integer, real) = match op {
            Op::Add => (IntegerOp::Add, Some(RealOp::RawAdd)),
            Op::Sub => (IntegerOp::Sub, Some(RealOp::RawSub)),
            Op::Mul => (IntegerOp::Mul, Some(RealOp::RawMul)),
            Op::Div => (IntegerOp::Div, Some(RealOp::RawDiv)),
            Op::And => (IntegerOp::And, None),
            Op::Or => (IntegerOp::Or, None),
            _ => (IntegerOp::Xor, None),
        };
        match real.filter(|_| ty.is_real()) {
            Some(real) => self.real(real, ty, a, b),
            None => self.integer(integer, ty, a, b),
        }
    }

    /// An operand in the type that is computed in.
    fn promoted(&mut self, value: Slot, from: Scalar, to: Scalar) -> Word {
        let value = self.pass(value, from, Scalar::Lint);
        match value {
            Slot::Word(word) if to.is_real() && !from.is_real() => self.convert(
                Conversion::IntegerToReal {
                    from: Width::of(from),
                    single: to == Scalar::Real,
                },
                word,
            ),
            Slot::Word(word) => word,
            _ => self.constant(0),
        }
    }

    /// A value cut to the type of the result.
    fn cut(&mut self, value: Word, from: Scalar, to: Scalar) -> Slot {
        if to.is_real() {
            return match (from.is_real(), to) {
                (true, Scalar::Real) if from != Scalar::Real => {
                    Slot::Word(self.convert(Conversion::RawSingle, value))
                }
                (true, _) => Slot::Word(value),
                (false, _) => Slot::Word(self.promoted(Slot::Word(value), from, to)),
            };
        }
        let whole = if from.is_real() {
            self.convert(Conversion::Saturate(Width::I32), value)
        } else {
            value
        };
        if to != Scalar::Bool {
            return Slot::Word(self.convert(Conversion::Wrap(Width::of(to)), whole));
        }
        // A BOOL is a byte there, and high unless the byte is 0.
        let byte = self.convert(Conversion::Wrap(Width::U8), whole);
        let (out, zero) = (self.layout.bit(), self.constant(0));
        self.emit(Instr::Compare {
            test: Test::NE,
            out,
            en: Bit::HIGH,
            a: byte,
            b: zero,
        });
        Slot::Bit(out)
    }
}

/// The type in which two operands meet.
fn meeting(a: Scalar, b: Scalar) -> Scalar {
    match (a, b) {
        (Scalar::Lreal, _) | (_, Scalar::Lreal) => Scalar::Lreal,
        (Scalar::Real, _) | (_, Scalar::Real) => Scalar::Real,
        _ if b.width() == 64 || a.width() == 64 => Scalar::Lint,
        _ if matches!(b, Scalar::Udint | Scalar::Dword) => Scalar::Lint,
        _ => a,
    }
}
