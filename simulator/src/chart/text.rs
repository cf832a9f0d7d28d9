//! Values of a trace in words.

use crate::value_text;
use ladder_analysis::types::Scalar;
use ladder_analysis::value::Value;

/// A value as it is beside a drawing: `1`, `1s500ms`, `16#00FF`.
pub fn reading(value: &Value, ty: Scalar) -> String {
    match value {
        Value::Bool(_) => value_text::cell(value, ty),
        Value::Int(nanoseconds) if ty == Scalar::Time => duration(*nanoseconds),
        _ => value_text::display(value, ty),
    }
}

/// Nanoseconds as a duration: `1s500ms`.
pub fn duration(nanoseconds: i64) -> String {
    let text = value_text::display(&Value::Int(nanoseconds), Scalar::Time);
    match text.strip_prefix("T#") {
        Some(duration) => duration.to_owned(),
        None => text,
    }
}

/// What a value is more than another, with its sign; none of what is no number.
pub fn difference(from: &Value, to: &Value, ty: Scalar) -> Option<String> {
    let signed = |is_less: bool, text: String| match text.as_str() {
        "0" | "0.0" | "0s" | "0ms" => text,
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
