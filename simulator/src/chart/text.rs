//! Values of a trace in words.

use crate::value_text;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;

/// A value as it is next to a drawing: `1`, `1.5s`, `16#00FF`.
pub fn reading(value: &Value, ty: Scalar) -> String {
    match value {
        Value::Bool(_) => value_text::cell(value, ty),
        Value::Int(nanoseconds) if ty == Scalar::Time => duration(*nanoseconds),
        Value::Real(real) => seven_digits(*real),
        _ => value_text::display(value, ty),
    }
}

/// A real with as many digits as a REAL has: no one reads more of them, and a narrow place has no room for them.
fn seven_digits(real: f64) -> String {
    let rounded = format!("{real:.6e}").parse().unwrap_or(real);
    value_text::cell(&Value::Real(rounded), Scalar::Lreal)
}

/// Nanoseconds as a duration in a narrow place: `20ms`, `1m30.5s`.
pub fn duration(nanoseconds: i64) -> String {
    const SECOND: u64 = 1_000_000_000;
    let mut rest = nanoseconds.unsigned_abs();
    let sign = if nanoseconds < 0 { "-" } else { "" };
    if rest < SECOND {
        return format!("{sign}{}ms", with_decimals(rest, 1_000_000));
    }
    let mut text = sign.to_owned();
    for (unit, length) in [("d", 86_400 * SECOND), ("h", 3600 * SECOND), ("m", 60 * SECOND)] {
        if rest >= length {
            text.push_str(&format!("{}{unit}", rest / length));
            rest %= length;
        }
    }
    if rest > 0 {
        text.push_str(&format!("{}s", with_decimals(rest, SECOND)));
    }
    text
}

/// A number of units, of which `one` are one, with the decimals that it needs.
fn with_decimals(number: u64, one: u64) -> String {
    let digits = one.ilog10() as usize;
    let text = format!("{}.{:0digits$}", number / one, number % one);
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// What a value is more than another, with its sign; none for what is not a number.
pub fn difference(from: &Value, to: &Value, ty: Scalar) -> Option<String> {
    let signed = |is_less: bool, text: String| match text.as_str() {
        "0" | "0.0" | "0ms" => text,
        _ if is_less => format!("-{text}"),
        _ => format!("+{text}"),
    };
    match (from, to) {
        _ if ty.is_bits() || ty.is_date() => None,
        (Value::Int(from), Value::Int(to)) => {
            let (from, to) = match ty {
                Scalar::Ulint => (i128::from(*from as u64), i128::from(*to as u64)),
                _ => (i128::from(*from), i128::from(*to)),
            };
            let amount = (to - from).unsigned_abs();
            let text = match (ty, i64::try_from(amount)) {
                (Scalar::Time, Ok(nanoseconds)) => duration(nanoseconds),
                _ => amount.to_string(),
            };
            Some(signed(to < from, text))
        }
        (Value::Real(from), Value::Real(to)) => {
            let amount = Value::Real((to - from).abs());
            Some(signed(to < from, value_text::cell(&amount, ty)))
        }
        _ => None,
    }
}
