//! Values as Structured Text writes them.

use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::{Value, real_text};

/// A constant of a type that is not an enumeration.
pub(crate) fn literal(value: &Value, ty: Scalar) -> String {
    match value {
        Value::Bool(true) => "TRUE".into(),
        Value::Bool(false) => "FALSE".into(),
        Value::Int(number) => whole(*number, ty),
        Value::Real(real) => real_number(*real, ty),
        Value::Text(bytes) => text(bytes),
    }
}

fn whole(number: i64, ty: Scalar) -> String {
    match ty {
        Scalar::Ulint => (number as u64).to_string(),
        Scalar::Byte | Scalar::Word | Scalar::Dword | Scalar::Lword => format!("16#{number:X}"),
        Scalar::Time => duration(number),
        Scalar::Date => format!("D#{}", day(number)),
        Scalar::Tod => format!("TOD#{}", time_of_day(number)),
        Scalar::Dt => format!("DT#{}-{}", day(number), time_of_day(number.rem_euclid(DAY))),
        Scalar::Real | Scalar::Lreal => real_number(number as f64, ty),
        _ => number.to_string(),
    }
}

/// Whether compilers that are built on matiec take a number: they know none that a REAL has no room for.
pub(crate) fn is_in_reach(value: &Value) -> bool {
    match value {
        Value::Real(real) => {
            *real == 0.0 || (f64::from(f32::MIN_POSITIVE)..=f64::from(f32::MAX)).contains(&real.abs())
        }
        _ => true,
    }
}

/// A number out of their reach as a product: the powers of two in it change no digit.
fn product(real: f64) -> String {
    let (mut rest, mut steps) = (real, 0);
    let step = 2f64.powi(100);
    while rest.abs() > 1e30 {
        rest /= step;
        steps += 1;
    }
    let by = if steps > 0 { " * " } else { " / " };
    while rest.abs() < 1e-30 && rest != 0.0 {
        rest *= step;
        steps += 1;
    }
    let steps = vec![real_number(step, Scalar::Lreal); steps].join(by);
    format!("({}{by}{steps})", real_number(rest, Scalar::Lreal))
}

fn real_number(real: f64, ty: Scalar) -> String {
    if !is_in_reach(&Value::Real(real)) {
        return product(real);
    }
    let text = real_text(real, ty);
    // An exponent follows a point.
    match text.split_once('e') {
        Some((digits, exponent)) if !digits.contains('.') => format!("{digits}.0E{exponent}"),
        _ => text.replace('e', "E"),
    }
}

const DAY: i64 = 86_400_000_000_000;

/// A duration in whole units; what is less than a millisecond is its fraction.
pub(crate) fn duration(nanoseconds: i64) -> String {
    let sign = if nanoseconds < 0 { "-" } else { "" };
    let mut left = nanoseconds.unsigned_abs();
    let mut text = format!("T#{sign}");
    let empty = text.len();
    for (unit, size) in [
        ("d", DAY as u64),
        ("h", 3_600_000_000_000),
        ("m", 60_000_000_000),
        ("s", 1_000_000_000),
    ] {
        if left >= size {
            text.push_str(&format!("{}{unit}", left / size));
            left %= size;
        }
    }
    if left > 0 || text.len() == empty {
        let (whole, fraction) = (left / 1_000_000, left % 1_000_000);
        if fraction == 0 && text.len() == empty && left == 0 {
            text.push_str("0s");
        } else {
            text.push_str(&with_fraction(whole, fraction, 6));
            text.push_str("ms");
        }
    }
    text
}

fn with_fraction(whole: u64, fraction: u64, digits: usize) -> String {
    if fraction == 0 {
        return whole.to_string();
    }
    let fraction = format!("{fraction:0digits$}");
    format!("{whole}.{}", fraction.trim_end_matches('0'))
}

/// Year, month and day of nanoseconds since 1970.
fn day(nanoseconds: i64) -> String {
    // Days since 1 March of the year 0, in eras of 400 years.
    let days = nanoseconds.div_euclid(DAY) + 719_468;
    let (era, in_era) = (days.div_euclid(146_097), days.rem_euclid(146_097));
    let year_of_era = (in_era - in_era / 1_460 + in_era / 36_524 - in_era / 146_096) / 365;
    let in_year = in_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let month = (5 * in_year + 2) / 153;
    let day = in_year - (153 * month + 2) / 5 + 1;
    let month = if month < 10 { month + 3 } else { month - 9 };
    let year = year_of_era + era * 400 + i64::from(month <= 2);
    format!("{year:04}-{month:02}-{day:02}")
}

fn time_of_day(nanoseconds: i64) -> String {
    let second = nanoseconds / 1_000_000_000;
    let fraction = with_fraction((second % 60) as u64, (nanoseconds % 1_000_000_000) as u64, 9);
    let seconds = if second % 60 < 10 {
        format!("0{fraction}")
    } else {
        fraction
    };
    format!("{:02}:{:02}:{seconds}", second / 3600, second / 60 % 60)
}

fn text(bytes: &[u8]) -> String {
    let mut text = String::from("'");
    for byte in bytes {
        match byte {
            b'\'' => text.push_str("$'"),
            b'$' => text.push_str("$$"),
            b' '..=b'~' => text.push(char::from(*byte)),
            _ => text.push_str(&format!("${byte:02X}")),
        }
    }
    text.push('\'');
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_written() {
        let int = |number, ty| literal(&Value::Int(number), ty);
        assert_eq!(int(5_400_000_000_000, Scalar::Time), "T#1h30m");
        assert_eq!(int(-250_500_000, Scalar::Time), "T#-250.5ms");
        assert_eq!(int(0, Scalar::Time), "T#0s");
        assert_eq!(int(-1, Scalar::Ulint), "18446744073709551615");
        assert_eq!(int(255, Scalar::Word), "16#FF");
        assert_eq!(int(DAY * 20_778, Scalar::Date), "D#2026-11-21");
        assert_eq!(
            int(45_000_500_000_000 + 4_000_000_000, Scalar::Tod),
            "TOD#12:30:04.5"
        );
        assert_eq!(literal(&Value::Real(1e30), Scalar::Lreal), "1.0E30");
        let two = "1.2676506002282294E30";
        let far = literal(&Value::Real(2f64.powi(201)), Scalar::Lreal);
        assert_eq!(far, format!("(2.0 * {two} * {two})"));
        let small = literal(&Value::Real(2f64.powi(-201)), Scalar::Lreal);
        assert_eq!(small, format!("(0.5 / {two} / {two})"));
        assert_eq!(literal(&Value::Real(0.1_f32.into()), Scalar::Real), "0.1");
        assert_eq!(
            literal(&Value::Text(b"a'$\n".as_slice().into()), Scalar::String(80)),
            "'a$'$$$0A'"
        );
    }
}
