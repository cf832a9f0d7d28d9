//! Arithmetic that notes what goes wrong and goes on: a division by zero makes the whole result 0, and what does not fit
//! wraps round.

use super::Operands;
use crate::fault::Trouble;
use crate::memory::{Memory, Word};
use crate::operation::Width;
use ladder_analysis::values::types::Scalar;

/// An operation on two numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Operation {
    Add,
    Subtract,
    Multiply,
    Divide,
    /// By 0 it gives the dividend; of integers alone.
    DivideUnlessZero,
    /// The remainder, with the sign of the dividend.
    Remainder,
    /// By 0 it gives 0; of integers alone.
    RemainderUnlessZero,
    /// The same, with the sign of the divisor.
    Modulo,
    Power,
    Least,
    Greatest,
}

/// Operations as operands: their place in this list.
const STEPS: [Operation; 11] = [
    Operation::Add,
    Operation::Subtract,
    Operation::Multiply,
    Operation::Divide,
    Operation::DivideUnlessZero,
    Operation::Remainder,
    Operation::RemainderUnlessZero,
    Operation::Modulo,
    Operation::Power,
    Operation::Least,
    Operation::Greatest,
];

impl Operation {
    /// As an operand.
    pub(crate) const fn operand(self) -> u32 {
        self as u32
    }
}

/// What went wrong in a step.
enum Slip {
    /// It divided by zero.
    Zero,
    /// It wrapped round.
    Range(i64),
}

/// A step of a formula: to, operation, type, a, b, the bits that note a division by zero and a wrap.
pub(super) fn step(memory: &mut Memory, with: &mut Operands) -> Result<(), Trouble> {
    let (to, step, ty) = (with.word(), with.number() as usize, with.ty());
    let step = STEPS.get(step).copied().unwrap_or(Operation::Add);
    let (a, b) = (with.word(), with.word());
    let result = if ty.is_real() {
        let single = ty == Scalar::Real;
        real(step, single, memory.real(a), memory.real(b))?.map(|value| value.to_bits() as i64)
    } else {
        integer(step, Width::of(ty), memory.word(a), memory.word(b))
    };
    let (zero, range) = (with.bit(), with.bit());
    memory.words[to.0 as usize] = match result {
        Ok(value) => value,
        Err(Slip::Zero) => {
            memory.set_bit(zero, true);
            0
        }
        Err(Slip::Range(value)) => {
            memory.set_bit(range, true);
            value
        }
    };
    Ok(())
}

fn integer(step: Operation, width: Width, a: i64, b: i64) -> Result<i64, Slip> {
    let (a, b) = (width.number(a), width.number(b));
    let value = match step {
        Operation::Add => a + b,
        Operation::Subtract => a - b,
        // Two of 64 bits without a sign may reach over 127; what is left of that fits nowhere.
        Operation::Multiply => a.wrapping_mul(b),
        Operation::Divide | Operation::Remainder | Operation::Modulo if b == 0 => return Err(Slip::Zero),
        Operation::DivideUnlessZero if b == 0 => a,
        Operation::RemainderUnlessZero if b == 0 => 0,
        Operation::Divide | Operation::DivideUnlessZero => a / b,
        Operation::Remainder | Operation::RemainderUnlessZero => a % b,
        Operation::Modulo => (a % b + b) % b,
        Operation::Power => return power(width, a, b),
        Operation::Least => a.min(b),
        Operation::Greatest => a.max(b),
    };
    held(width, value)
}

fn held(width: Width, value: i128) -> Result<i64, Slip> {
    let wrapped = width.wrap(value as i64);
    if width.number(wrapped) == value {
        Ok(wrapped)
    } else {
        Err(Slip::Range(wrapped))
    }
}

/// By squaring; a negative exponent leaves no whole number, but of 1 and -1.
fn power(width: Width, base: i128, exponent: i128) -> Result<i64, Slip> {
    if exponent < 0 {
        return match base {
            0 => Err(Slip::Zero),
            1 | -1 => power(width, base, -exponent),
            _ => Ok(0),
        };
    }
    let (mut result, mut factor, mut left) = (1i128, base, exponent);
    let mut exact = true;
    while left > 0 {
        if left & 1 == 1 {
            let (value, over) = result.overflowing_mul(factor);
            (result, exact) = (value, exact && !over);
        }
        left >>= 1;
        if left > 0 {
            let (value, over) = factor.overflowing_mul(factor);
            (factor, exact) = (value, exact && !over);
        }
    }
    match held(width, result) {
        Ok(value) if !exact => Err(Slip::Range(value)),
        other => other,
    }
}

fn real(step: Operation, single: bool, a: f64, b: f64) -> Result<Result<f64, Slip>, Trouble> {
    let value = match step {
        Operation::Add => a + b,
        Operation::Subtract => a - b,
        Operation::Multiply => a * b,
        Operation::Divide | Operation::Remainder | Operation::Modulo if b == 0.0 => {
            return Ok(Err(Slip::Zero));
        }
        Operation::Divide | Operation::DivideUnlessZero => a / b,
        Operation::Remainder | Operation::RemainderUnlessZero => libm::fmod(a, b),
        Operation::Modulo => {
            let rest = libm::fmod(a, b);
            if rest != 0.0 && (rest < 0.0) != (b < 0.0) {
                rest + b
            } else {
                rest
            }
        }
        Operation::Power => {
            let value = libm::pow(a, b);
            if value.is_nan() {
                return Err(Trouble::Domain(a));
            }
            value
        }
        Operation::Least => a.min(b),
        Operation::Greatest => a.max(b),
    };
    let value = if single { f64::from(value as f32) } else { value };
    Ok(value.is_finite().then_some(value).ok_or(Slip::Range(0)))
}

/// A result cut to the type that it goes to: to, its type, from, its type, the bits as of [`step`]. It is 0 after a
/// division by zero.
pub(super) fn cut(memory: &mut Memory, with: &mut Operands) {
    let (to, to_type, from, from_type) = (with.word(), with.ty(), with.word(), with.ty());
    let (zero, range) = (with.bit(), with.bit());
    let value = if memory.bit(zero) {
        0
    } else {
        let (value, fits) = brought(memory, to_type, from, from_type, libm::trunc, Width::wrap_number);
        if !fits {
            memory.set_bit(range, true);
        }
        value
    };
    memory.words[to.0 as usize] = value;
}

/// A copy to another type: a real is rounded, half to even, and what does not fit loses its upper bits. Operands as of
/// [`cut`].
pub(super) fn round(memory: &mut Memory, with: &mut Operands) {
    let (to, to_type, from, from_type) = (with.word(), with.ty(), with.word(), with.ty());
    let (_, range) = (with.bit(), with.bit());
    let (value, fits) = brought(
        memory,
        to_type,
        from,
        from_type,
        f64::round_ties_even,
        Width::wrap_number,
    );
    if !fits {
        memory.set_bit(range, true);
    }
    memory.words[to.0 as usize] = value;
}

/// A copy to another type: what does not fit is held at the limit, in a bit string it loses its upper bits. Operands as
/// of [`cut`].
pub(super) fn clamp(memory: &mut Memory, with: &mut Operands) {
    let (to, to_type, from, from_type) = (with.word(), with.ty(), with.word(), with.ty());
    let (_, range) = (with.bit(), with.bit());
    let hold = if to_type.is_bits() {
        Width::wrap_number
    } else {
        Width::clamp_number
    };
    let (value, fits) = brought(memory, to_type, from, from_type, libm::trunc, hold);
    if !fits {
        memory.set_bit(range, true);
    }
    memory.words[to.0 as usize] = value;
}

/// A number brought to a type, and whether it fits. A real that becomes an integer is made whole before.
fn brought(
    memory: &Memory,
    to: Scalar,
    from: Word,
    from_type: Scalar,
    whole: fn(f64) -> f64,
    hold: fn(Width, i128) -> i64,
) -> (i64, bool) {
    let single = to == Scalar::Real;
    let number = if from_type.is_real() {
        let real = memory.real(from);
        if to.is_real() {
            let real = if single { f64::from(real as f32) } else { real };
            let fits = real.is_finite();
            return (if fits { real.to_bits() as i64 } else { 0 }, fits);
        }
        // The cast saturates far outside every width.
        whole(real) as i128
    } else {
        let number = Width::of(from_type).number(memory.word(from));
        if to.is_real() {
            let real = number as f64;
            let real = if single { f64::from(real as f32) } else { real };
            return (real.to_bits() as i64, true);
        }
        number
    };
    let width = Width::of(to);
    let held = hold(width, number);
    (held, width.number(held) == number)
}
