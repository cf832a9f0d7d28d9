//! Values as programs hold them.

use crate::values::types::Scalar;

/// A value. Its type is next to it: the same `Int` is a DINT, a WORD or a TIME.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// BOOL.
    Bool(bool),
    /// Integers and bit strings by value (ULINT and LWORD as the same 64 bits), TIME, DATE, TOD and DT in
    /// nanoseconds.
    Int(i64),
    /// REAL (rounded to 32 bits) and LREAL.
    Real(f64),
    /// STRING. Bytes, since `$hh` can give any.
    Text(Box<[u8]>),
}

impl Value {
    /// What a tag of a type holds before anything is written: zero, FALSE, the empty text, an enumeration's first value.
    pub fn zero(ty: Scalar) -> Value {
        match ty {
            Scalar::Bool => Value::Bool(false),
            Scalar::Real | Scalar::Lreal => Value::Real(0.0),
            Scalar::String(_) => Value::Text(Box::default()),
            Scalar::Enum(id) => Value::Int(id.get().first()),
            _ => Value::Int(0),
        }
    }
}

/// A real in the shortest form that reads back the same, always with a point or an exponent. A REAL is shortest among 32-bit
/// numbers: `0.1`, not `0.10000000149011612`.
pub fn real_text(real: f64, ty: Scalar) -> String {
    match ty {
        Scalar::Real => format!("{:?}", real as f32),
        _ => format!("{real:?}"),
    }
}

/// Brings a whole number into the width of an integer or bit-string type: two's complement, as integer
/// arithmetic wraps.
pub const fn wrap(value: i64, ty: Scalar) -> i64 {
    match ty {
        Scalar::Sint => value as i8 as i64,
        Scalar::Int => value as i16 as i64,
        Scalar::Dint => value as i32 as i64,
        Scalar::Usint | Scalar::Byte => value as u8 as i64,
        Scalar::Uint | Scalar::Word => value as u16 as i64,
        Scalar::Udint | Scalar::Dword => value as u32 as i64,
        _ => value,
    }
}
