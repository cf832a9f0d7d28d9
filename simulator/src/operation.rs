//! The operations on words: which there are, and what each computes.

use crate::fault::Trouble;
use ladder_analysis::values::types::Scalar;
use std::cmp::Ordering;

/// A comparison, as the set of orders for which it holds: one look instead of a choice among six.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Test(u8);

impl Test {
    pub const EQ: Test = Test(0b010);
    pub const NE: Test = Test(0b101);
    pub const GT: Test = Test(0b100);
    pub const GE: Test = Test(0b110);
    pub const LT: Test = Test(0b001);
    pub const LE: Test = Test(0b011);

    /// As a routine's operand.
    pub const fn operand(self) -> u32 {
        self.0 as u32
    }

    /// The reverse.
    pub const fn of_operand(operand: u32) -> Test {
        Test(operand as u8)
    }

    #[inline]
    pub fn holds(self, order: Ordering) -> bool {
        self.0 >> (order as i8 + 1) & 1 != 0
    }
}

/// How a whole number is held: its width and sign. TIME and dates are signed with 64 bits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Width {
    I8,
    I16,
    I32,
    I64,
    U8,
    U16,
    U32,
    U64,
}

impl Width {
    /// The width of an integer, bit string, time or date; 64 signed bits for anything else.
    pub const fn of(ty: Scalar) -> Width {
        match ty {
            Scalar::Sint => Width::I8,
            Scalar::Int => Width::I16,
            Scalar::Dint => Width::I32,
            Scalar::Usint | Scalar::Byte => Width::U8,
            Scalar::Uint | Scalar::Word => Width::U16,
            Scalar::Udint | Scalar::Dword => Width::U32,
            Scalar::Ulint | Scalar::Lword => Width::U64,
            _ => Width::I64,
        }
    }

    /// Brings a number into the width: two's complement.
    #[inline]
    pub const fn wrap(self, value: i64) -> i64 {
        match self {
            Width::I8 => value as i8 as i64,
            Width::I16 => value as i16 as i64,
            Width::I32 => value as i32 as i64,
            Width::U8 => value as u8 as i64,
            Width::U16 => value as u16 as i64,
            Width::U32 => value as u32 as i64,
            Width::I64 | Width::U64 => value,
        }
    }

    /// The smallest and the largest number, of signed widths and those below 64 bits.
    pub const fn ends(self) -> (i64, i64) {
        match self {
            Width::I8 => (i8::MIN as i64, i8::MAX as i64),
            Width::I16 => (i16::MIN as i64, i16::MAX as i64),
            Width::I32 => (i32::MIN as i64, i32::MAX as i64),
            Width::U8 => (0, u8::MAX as i64),
            Width::U16 => (0, u16::MAX as i64),
            Width::U32 => (0, u32::MAX as i64),
            Width::I64 | Width::U64 => (i64::MIN, i64::MAX),
        }
    }

    pub const fn bits(self) -> u32 {
        match self {
            Width::I8 | Width::U8 => 8,
            Width::I16 | Width::U16 => 16,
            Width::I32 | Width::U32 => 32,
            Width::I64 | Width::U64 => 64,
        }
    }

    /// The value as a number: 64 unsigned bits are held as the same bits of an `i64`.
    pub const fn number(self, value: i64) -> i128 {
        match self {
            Width::U64 => value as u64 as i128,
            _ => value as i128,
        }
    }

    /// A number cut to the width.
    pub fn wrap_number(self, number: i128) -> i64 {
        self.wrap(number as i64)
    }

    /// A number held at the ends of the width.
    pub fn clamp_number(self, number: i128) -> i64 {
        match self {
            Width::U64 => number.clamp(0, u64::MAX.into()) as u64 as i64,
            _ => {
                let (least, most) = self.ends();
                number.clamp(least.into(), most.into()) as i64
            }
        }
    }

    /// The number as it is held, if the width has room for it.
    pub(crate) fn hold(self, number: i128) -> Result<i64, Trouble> {
        let held = self.wrap(number as i64);
        if self.number(held) == number {
            Ok(held)
        } else {
            Err(Trouble::OutOfRange)
        }
    }

    /// The number's bits, without the sign's copies above the width.
    const fn unsigned(self, value: i64) -> u64 {
        value as u64 & (u64::MAX >> (64 - self.bits()))
    }
}

/// Operations on two whole numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum IntegerOp {
    Add,
    Sub,
    Mul,
    Div,
    Mod,
    Power,
    And,
    Or,
    Xor,
    Shl,
    Shr,
    Rol,
    Ror,
    Min,
    Max,
    /// The absolute value of a; b is not used.
    Abs,
}

/// Integer arithmetic wraps in the result's width (LANGUAGE §5.2).
#[inline]
pub(crate) fn integer(op: IntegerOp, width: Width, a: i64, b: i64) -> Result<i64, Trouble> {
    let unsigned = width == Width::U64;
    let value = match op {
        IntegerOp::Add => a.wrapping_add(b),
        IntegerOp::Sub => a.wrapping_sub(b),
        IntegerOp::Mul => a.wrapping_mul(b),
        IntegerOp::Div if b == 0 => return Err(Trouble::DivisionByZero),
        IntegerOp::Div if unsigned => (a as u64 / b as u64) as i64,
        IntegerOp::Div => a.wrapping_div(b),
        IntegerOp::Mod if b == 0 => return Err(Trouble::DivisionByZero),
        IntegerOp::Mod if unsigned => (a as u64 % b as u64) as i64,
        IntegerOp::Mod => a.wrapping_rem(b),
        IntegerOp::Power => power(a, b, unsigned)?,
        IntegerOp::And => a & b,
        IntegerOp::Or => a | b,
        IntegerOp::Xor => a ^ b,
        IntegerOp::Shl => {
            let places = places(b)?;
            if places >= u64::from(width.bits()) {
                0
            } else {
                a << places
            }
        }
        IntegerOp::Shr => {
            let places = places(b)?;
            if places >= u64::from(width.bits()) {
                0
            } else {
                (width.unsigned(a) >> places) as i64
            }
        }
        IntegerOp::Rol => rotate(width, a, (places(b)? % u64::from(width.bits())) as u32),
        IntegerOp::Ror => {
            let bits = u64::from(width.bits());
            rotate(width, a, ((bits - places(b)? % bits) % bits) as u32)
        }
        IntegerOp::Min if unsigned => (a as u64).min(b as u64) as i64,
        IntegerOp::Min => a.min(b),
        IntegerOp::Max if unsigned => (a as u64).max(b as u64) as i64,
        IntegerOp::Max => a.max(b),
        IntegerOp::Abs if unsigned => a,
        IntegerOp::Abs => a.wrapping_abs(),
    };
    Ok(width.wrap(value))
}

fn places(n: i64) -> Result<u64, Trouble> {
    u64::try_from(n).map_err(|_| Trouble::NegativeShift(n))
}

fn rotate(width: Width, value: i64, places: u32) -> i64 {
    let bits = width.unsigned(value);
    if places == 0 {
        return value;
    }
    (bits << places | bits >> (width.bits() - places)) as i64
}

/// By squaring, wrapping: bits above a narrower result's width never reach down into it.
fn power(base: i64, exponent: i64, unsigned: bool) -> Result<i64, Trouble> {
    if exponent < 0 && !unsigned {
        return Err(Trouble::NegativeExponent(exponent));
    }
    let (mut result, mut base, mut exponent) = (1i64, base, exponent as u64);
    while exponent > 0 {
        if exponent & 1 == 1 {
            result = result.wrapping_mul(base);
        }
        base = base.wrapping_mul(base);
        exponent >>= 1;
    }
    Ok(result)
}

/// Operations on two reals.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum RealOp {
    Add,
    Sub,
    Mul,
    Div,
    Mod,
    Power,
    Min,
    Max,
    /// The four operations as hardware does them: what is too large is infinite, and nothing is a fault.
    RawAdd,
    RawSub,
    RawMul,
    RawDiv,
}

/// Each step is rounded to the result's type. In `f64` the four operations and the root of 32-bit numbers are
/// exact enough that rounding the result once more gives what 32-bit arithmetic gives.
#[inline]
pub(crate) fn real(op: RealOp, single: bool, a: f64, b: f64) -> Result<f64, Trouble> {
    let value = match op {
        RealOp::Add => a + b,
        RealOp::Sub => a - b,
        RealOp::Mul => a * b,
        RealOp::Div if b == 0.0 => return Err(Trouble::DivisionByZero),
        RealOp::Div => a / b,
        RealOp::Mod if b == 0.0 => return Err(Trouble::DivisionByZero),
        RealOp::Mod => libm::fmod(a, b),
        RealOp::Power => {
            let value = libm::pow(a, b);
            if value.is_nan() {
                return Err(Trouble::Domain(a));
            }
            value
        }
        // Written out: `min` and `max` may take either of 0.0 and -0.0.
        RealOp::Min => {
            if b < a {
                b
            } else {
                a
            }
        }
        RealOp::Max => {
            if b > a {
                b
            } else {
                a
            }
        }
        RealOp::RawAdd => return Ok(rounded(a + b, single)),
        RealOp::RawSub => return Ok(rounded(a - b, single)),
        RealOp::RawMul => return Ok(rounded(a * b, single)),
        RealOp::RawDiv => return Ok(rounded(a / b, single)),
    };
    finite(value, single)
}

/// Functions of one real.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum RealFunction {
    Abs,
    Neg,
    Trunc,
    Sqrt,
    Ln,
    Log,
    Expe,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Rad,
    Deg,
}

/// From `libm`, so that a trace is the same on every machine.
pub(crate) fn real_function(function: RealFunction, single: bool, a: f64) -> Result<f64, Trouble> {
    use std::f64::consts::PI;
    let outside = match function {
        RealFunction::Sqrt => a < 0.0,
        RealFunction::Ln | RealFunction::Log => a <= 0.0,
        RealFunction::Asin | RealFunction::Acos => !(-1.0..=1.0).contains(&a),
        _ => false,
    };
    if outside {
        return Err(Trouble::Domain(a));
    }
    let value = match function {
        RealFunction::Abs => a.abs(),
        RealFunction::Neg => -a,
        RealFunction::Trunc => libm::trunc(a),
        RealFunction::Sqrt => libm::sqrt(a),
        RealFunction::Ln => libm::log(a),
        RealFunction::Log => libm::log10(a),
        RealFunction::Expe => libm::exp(a),
        RealFunction::Sin => libm::sin(a),
        RealFunction::Cos => libm::cos(a),
        RealFunction::Tan => libm::tan(a),
        RealFunction::Asin => libm::asin(a),
        RealFunction::Acos => libm::acos(a),
        RealFunction::Atan => libm::atan(a),
        RealFunction::Rad => a * (PI / 180.0),
        RealFunction::Deg => a * (180.0 / PI),
    };
    finite(value, single)
}

/// What two reals become, for those who translate the compiled form; none is a fault.
pub fn real_of(op: RealOp, single: bool, a: f64, b: f64) -> Option<f64> {
    real(op, single, a, b).ok()
}

/// What a function of a real returns, likewise.
pub fn real_function_of(function: RealFunction, single: bool, a: f64) -> Option<f64> {
    real_function(function, single, a).ok()
}

/// What a word is converted to, likewise.
pub fn converted(conversion: Conversion, value: i64) -> Option<i64> {
    convert(conversion, value).ok()
}

#[inline]
fn rounded(value: f64, single: bool) -> f64 {
    if single { f64::from(value as f32) } else { value }
}

/// Rounds to the type; what is not finite there is a fault.
#[inline]
pub(crate) fn finite(value: f64, single: bool) -> Result<f64, Trouble> {
    let rounded = rounded(value, single);
    if rounded.is_finite() {
        Ok(rounded)
    } else {
        Err(Trouble::NotFinite)
    }
}

/// From one word to another.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Conversion {
    /// Bits kept: WORD 16#FFFF is INT -1.
    Wrap(Width),
    /// A whole number, which must fit.
    Fit {
        from: Width,
        to: Width,
    },
    IntegerToReal {
        from: Width,
        single: bool,
    },
    /// Rounds half to even; must fit.
    Round(Width),
    /// Cuts the fraction off; must fit.
    Truncate(Width),
    /// LREAL to REAL.
    Single,
    /// The same; what is too large is infinite.
    RawSingle,
    /// A real cut to a whole number, held at the ends of the width.
    Saturate(Width),
    /// Milliseconds to nanoseconds; must fit.
    Milliseconds(Width),
    /// The same, held at the ends of TIME: a preset that is too long is as long as can be.
    Preset(Width),
    /// Nanoseconds to whole milliseconds, half to even; must fit.
    ToMilliseconds(Width),
    RealToTime,
    TimeToReal {
        single: bool,
    },
    /// DT to its DATE, and to its TOD.
    DayOf,
    TimeOfDayOf,
}

const NANOSECONDS: i64 = 1_000_000;
const DAY: i64 = 86_400_000_000_000;

/// Converts a word (LANGUAGE §5.2, `[TYP]`).
pub(crate) fn convert(conversion: Conversion, value: i64) -> Result<i64, Trouble> {
    let real = f64::from_bits(value as u64);
    let held = |real: f64, single| finite(real, single).map(|real| real.to_bits() as i64);
    match conversion {
        Conversion::Wrap(width) => Ok(width.wrap(value)),
        Conversion::Fit { from, to } => to.hold(from.number(value)),
        Conversion::IntegerToReal {
            from: Width::U64,
            single,
        } => held(value as u64 as f64, single),
        Conversion::IntegerToReal { single, .. } => held(value as f64, single),
        Conversion::Round(width) => whole(real.round_ties_even(), width),
        Conversion::Truncate(width) => whole(libm::trunc(real), width),
        Conversion::RawSingle => Ok(rounded(real, true).to_bits() as i64),
        Conversion::Saturate(width) => {
            let (least, most) = width.ends();
            // The cast saturates, and gives 0 for what is not a number.
            Ok((real as i64).clamp(least, most))
        }
        Conversion::Single => held(real, true).map_err(|_| Trouble::OutOfRange),
        Conversion::Milliseconds(width) => Width::I64.hold(width.number(value) * i128::from(NANOSECONDS)),
        Conversion::Preset(width) => {
            let nanoseconds = width.number(value) * i128::from(NANOSECONDS);
            Ok(nanoseconds.clamp(i128::from(i64::MIN), i128::from(i64::MAX)) as i64)
        }
        Conversion::ToMilliseconds(width) => width.hold(i128::from(half_to_even(value, NANOSECONDS))),
        Conversion::RealToTime => whole((real * NANOSECONDS as f64).round_ties_even(), Width::I64),
        Conversion::TimeToReal { single } => held(value as f64 / NANOSECONDS as f64, single),
        Conversion::DayOf => Ok(value.wrapping_sub(value.rem_euclid(DAY))),
        Conversion::TimeOfDayOf => Ok(value.rem_euclid(DAY)),
    }
}

/// A real without fraction as a whole number of a width.
fn whole(real: f64, width: Width) -> Result<i64, Trouble> {
    // The cast saturates, and 2^127 is far outside every width.
    width.hold(real as i128)
}

fn half_to_even(value: i64, unit: i64) -> i64 {
    let (whole, rest) = (value.div_euclid(unit), value.rem_euclid(unit));
    match (rest * 2).cmp(&unit) {
        Ordering::Less => whole,
        Ordering::Greater => whole + 1,
        Ordering::Equal => whole + (whole & 1),
    }
}
