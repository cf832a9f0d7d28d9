//! Values as words of 16 bits.

use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;

/// In which order the words of a value follow one another that has several. The protocol only fixes the bytes of a word.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Words {
    /// The high word first, as most have it.
    #[default]
    Big,
    /// The low word first, as Click has it.
    Little,
}

impl Words {
    /// As a setting has it.
    pub fn of_setting(set: Option<&str>) -> Words {
        match set {
            Some("little") => Words::Little,
            _ => Words::Big,
        }
    }
}

/// How many nanoseconds a unit of a time is on the wire.
const MILLISECOND: i64 = 1_000_000;

/// How many words a value of a type takes. None: it has no form on the wire.
pub(super) fn width(ty: Scalar) -> Option<usize> {
    Some(match ty {
        Scalar::Sint | Scalar::Usint | Scalar::Byte | Scalar::Int | Scalar::Uint | Scalar::Word => 1,
        Scalar::Dint | Scalar::Udint | Scalar::Dword | Scalar::Real | Scalar::Time => 2,
        Scalar::Lint | Scalar::Ulint | Scalar::Lword | Scalar::Lreal => 4,
        _ => return None,
    })
}

/// A value as words.
pub(super) fn words(value: &Value, ty: Scalar, order: Words) -> Vec<u16> {
    let bits = match value {
        Value::Bool(high) => u64::from(*high),
        Value::Int(number) if ty == Scalar::Time => in_milliseconds(*number) as u64,
        Value::Int(number) => *number as u64,
        Value::Real(real) if ty == Scalar::Real => u64::from((*real as f32).to_bits()),
        Value::Real(real) => real.to_bits(),
        Value::Text(_) => 0,
    };
    let mut words: Vec<u16> = (0..width(ty).unwrap_or(0))
        .map(|word| (bits >> (16 * word)) as u16)
        .collect();
    if order == Words::Big {
        words.reverse();
    }
    words
}

/// A TIME is a DINT of milliseconds on the wire; one that is too long for that is the longest one.
fn in_milliseconds(nanoseconds: i64) -> i64 {
    (nanoseconds / MILLISECOND).clamp(i64::from(i32::MIN), i64::from(i32::MAX))
}

/// The value that words are. None: it is not one of the type's, such as 300 for a USINT.
pub(super) fn value(words: &[u16], ty: Scalar, order: Words) -> Option<Value> {
    let joined = |bits: u64, word: &u16| bits << 16 | u64::from(*word);
    let bits = match order {
        Words::Big => words.iter().fold(0, joined),
        Words::Little => words.iter().rev().fold(0, joined),
    };
    Some(match ty {
        Scalar::Real => Value::Real(f64::from(f32::from_bits(bits as u32))),
        Scalar::Lreal => Value::Real(f64::from_bits(bits)),
        Scalar::Time => Value::Int(i64::from(bits as i32) * MILLISECOND),
        Scalar::Sint => Value::Int(i8::try_from(bits as i16).ok()?.into()),
        Scalar::Usint | Scalar::Byte => Value::Int(u8::try_from(bits).ok()?.into()),
        Scalar::Int => Value::Int(i64::from(bits as i16)),
        Scalar::Dint => Value::Int(i64::from(bits as i32)),
        _ => Value::Int(bits as i64),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn the_high_word_comes_first_unless_asked_otherwise() {
        let real = Value::Real(f64::from(1.2_f32));
        assert_eq!(words(&real, Scalar::Real, Words::Big), [16281, 39322]);
        assert_eq!(words(&real, Scalar::Real, Words::Little), [39322, 16281]);
        let time = Value::Int(70_000 * MILLISECOND);
        assert_eq!(words(&time, Scalar::Time, Words::Big), [1, 4464]);
        assert_eq!(words(&Value::Int(-2), Scalar::Sint, Words::Big), [0xFFFE]);
        assert_eq!(words(&Value::Int(1), Scalar::Lint, Words::Little), [1, 0, 0, 0]);
    }

    #[test]
    fn what_is_no_value_of_the_type_is_none() {
        assert_eq!(value(&[300], Scalar::Usint, Words::Big), None);
        assert_eq!(value(&[128], Scalar::Sint, Words::Big), None);
        assert_eq!(value(&[0xFF80], Scalar::Sint, Words::Big), Some(Value::Int(-128)));
    }

    proptest! {
        #[test]
        fn numbers_come_back(number: i64, little: bool) {
            let order = if little { Words::Little } else { Words::Big };
            for (ty, own) in [
                (Scalar::Sint, i64::from(number as i8)),
                (Scalar::Usint, i64::from(number as u8)),
                (Scalar::Int, i64::from(number as i16)),
                (Scalar::Word, i64::from(number as u16)),
                (Scalar::Dint, i64::from(number as i32)),
                (Scalar::Udint, i64::from(number as u32)),
                (Scalar::Lint, number),
                (Scalar::Time, i64::from(number as i32) * MILLISECOND),
            ] {
                prop_assert_eq!(value(&words(&Value::Int(own), ty, order), ty, order), Some(Value::Int(own)));
            }
            let real = Value::Real(number as f64 / 3.0);
            prop_assert_eq!(value(&words(&real, Scalar::Lreal, order), Scalar::Lreal, order), Some(real));
        }
    }
}
