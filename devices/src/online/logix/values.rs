//! What a controller answers, as values of the program's types.

use super::plan::Step;
use ciplink::Value as Answer;
use ciplink::types::Elementary;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;

/// A time in a controller counts milliseconds.
const MILLISECOND: i128 = 1_000_000;

/// The smallest and the largest value of a type of the controller that holds whole numbers.
fn bounds(ty: Elementary) -> Option<(i128, i128)> {
    let bits = width(ty)?;
    Some(match ty {
        Elementary::SInt | Elementary::Int | Elementary::DInt | Elementary::LInt => {
            (-(1 << (bits - 1)), (1 << (bits - 1)) - 1)
        }
        _ => (0, (1 << bits) - 1),
    })
}

/// How many bits a whole number has. None: it is not one.
pub(super) fn width(ty: Elementary) -> Option<u32> {
    Some(match ty {
        Elementary::SInt | Elementary::USInt | Elementary::Byte => 8,
        Elementary::Int | Elementary::UInt | Elementary::Word => 16,
        Elementary::DInt | Elementary::UDInt | Elementary::DWord => 32,
        Elementary::LInt | Elementary::ULInt | Elementary::LWord => 64,
        _ => return None,
    })
}

/// Whether every value of a controller's type is one of a type of the program.
pub(super) fn fits(wanted: Scalar, ty: Elementary) -> bool {
    match wanted {
        Scalar::Bool => ty == Elementary::Bool,
        Scalar::Real => ty == Elementary::Real,
        Scalar::Lreal => matches!(ty, Elementary::Real | Elementary::LReal),
        // Milliseconds, as timers count them.
        Scalar::Time => matches!(ty, Elementary::DInt | Elementary::LInt),
        // As many bits, whatever they mean as a number: Logix has no bit strings of its own.
        _ if wanted.is_bits() => width(ty) == Some(wanted.width()),
        _ => {
            let ours = if wanted.is_enumeration() {
                Scalar::Dint
            } else {
                wanted
            };
            match (ours.bounds(), bounds(ty)) {
                (Some(ours), Some(theirs)) => ours.0 <= theirs.0 && theirs.1 <= ours.1,
                _ => false,
            }
        }
    }
}

/// The value that some steps lead to. None: it is not there, or not one of the type.
pub(super) fn value(answer: &Answer, steps: &[Step], ty: Scalar) -> Option<Value> {
    let Some((step, rest)) = steps.split_first() else {
        return whole(answer, ty);
    };
    match (step, answer) {
        (Step::Member(name), Answer::Struct(members)) => value(members.get(name)?, rest, ty),
        (Step::Element(element), Answer::Array(elements)) => value(elements.get(*element)?, rest, ty),
        (Step::Bit(bit), _) if rest.is_empty() => {
            let set = integer(answer)?.checked_shr(*bit)? & 1 != 0;
            (ty == Scalar::Bool).then_some(Value::Bool(set))
        }
        _ => None,
    }
}

fn whole(answer: &Answer, ty: Scalar) -> Option<Value> {
    match (ty, answer) {
        (Scalar::Bool, Answer::Bool(bit)) => Some(Value::Bool(*bit)),
        (Scalar::Real | Scalar::Lreal, Answer::Real(real)) => Some(Value::Real(f64::from(*real))),
        (Scalar::Lreal, Answer::LReal(real)) => Some(Value::Real(*real)),
        (Scalar::String(most), Answer::String(text)) => {
            // The driver makes a letter of each byte.
            let bytes = text.chars().map(|letter| u8::try_from(u32::from(letter)).ok());
            let bytes: Box<[u8]> = bytes.collect::<Option<_>>()?;
            (bytes.len() <= usize::from(most)).then_some(Value::Text(bytes))
        }
        (Scalar::Time, _) => {
            let nanoseconds = integer(answer)?.checked_mul(MILLISECOND)?;
            i64::try_from(nanoseconds).ok().map(Value::Int)
        }
        _ => {
            let mut number = integer(answer)?;
            let ours = if ty.is_enumeration() { Scalar::Dint } else { ty };
            let (least, most) = ours.bounds()?;
            if ty.is_bits() && number < 0 {
                // Of a signed number the bits.
                number += most + 1;
            }
            let is_inside = least <= number && number <= most;
            is_inside.then_some(Value::Int(number as i64))
        }
    }
}

/// A whole number, or bits as one.
fn integer(answer: &Answer) -> Option<i128> {
    let Answer::Array(bits) = answer else {
        return answer.as_i128();
    };
    let bits = bits.iter().map(|bit| match bit {
        Answer::Bool(bit) => Some(*bit),
        _ => None,
    });
    let bits: Vec<bool> = bits.collect::<Option<_>>()?;
    let sum = || {
        bits.iter()
            .rev()
            .fold(0, |number, bit| number << 1 | i128::from(*bit))
    };
    matches!(bits.len(), 8 | 16 | 32 | 64).then(sum)
}

#[cfg(test)]
mod tests {
    use super::*;
    use expect_test::{Expect, expect};

    fn check(answer: Answer, ty: Scalar, expected: Expect) {
        let value = whole(&answer, ty);
        expected.assert_eq(&value.map_or("none".to_owned(), |value| format!("{value:?}")));
    }

    #[test]
    fn values_are_of_the_type_or_not_there() {
        check(Answer::Bool(true), Scalar::Bool, expect!["Bool(true)"]);
        check(Answer::DInt(1), Scalar::Bool, expect!["none"]);
        check(Answer::SInt(-128), Scalar::Sint, expect!["Int(-128)"]);
        check(Answer::DInt(40000), Scalar::Int, expect!["none"]);
        check(Answer::DInt(-1), Scalar::Udint, expect!["none"]);
        check(Answer::Int(-1), Scalar::Word, expect!["Int(65535)"]);
        check(Answer::LInt(-1), Scalar::Lword, expect!["Int(-1)"]);
        check(Answer::ULInt(u64::MAX), Scalar::Ulint, expect!["Int(-1)"]);
        check(
            Answer::LInt(i64::MIN),
            Scalar::Lint,
            expect!["Int(-9223372036854775808)"],
        );
        check(Answer::DInt(5000), Scalar::Time, expect!["Int(5000000000)"]);
        check(Answer::LInt(i64::MAX), Scalar::Time, expect!["none"]);
        check(Answer::Real(0.5), Scalar::Real, expect!["Real(0.5)"]);
        check(Answer::Real(0.5), Scalar::Dint, expect!["none"]);
        check(Answer::DInt(1), Scalar::Real, expect!["none"]);
        check(Answer::LReal(0.5), Scalar::Real, expect!["none"]);
        let bits = [true, false, true, false, false, false, false, true].map(Answer::Bool);
        check(Answer::Array(bits.to_vec()), Scalar::Byte, expect!["Int(133)"]);
        check(
            Answer::String("gr\u{fc}n".to_owned()),
            Scalar::String(4),
            expect!["Text([103, 114, 252, 110])"],
        );
        check(
            Answer::String("longer".to_owned()),
            Scalar::String(4),
            expect!["none"],
        );
    }

    #[test]
    fn steps_that_lead_nowhere() {
        let array = Answer::Array(vec![Answer::DInt(5)]);
        let at = |steps: &[Step], ty| value(&array, steps, ty);
        assert_eq!(at(&[Step::Element(0)], Scalar::Dint), Some(Value::Int(5)));
        assert_eq!(
            at(&[Step::Element(0), Step::Bit(2)], Scalar::Bool),
            Some(Value::Bool(true))
        );
        assert_eq!(at(&[Step::Element(1)], Scalar::Dint), None);
        assert_eq!(at(&[Step::Member("a".to_owned())], Scalar::Dint), None);
        assert_eq!(
            at(&[Step::Element(0), Step::Member("a".to_owned())], Scalar::Dint),
            None
        );
        assert_eq!(at(&[], Scalar::Dint), None);
    }
}
