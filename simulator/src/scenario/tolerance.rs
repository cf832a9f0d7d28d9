//! How far a number may be from what is expected.

use crate::value_text;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;

/// How far a number may be from what is expected.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Tolerance {
    /// So much, in the unit of the value (nanoseconds for TIME).
    Absolute(f64),
    /// Such a part of what is expected.
    Relative(f64),
}

impl Tolerance {
    /// Reads `0.01` or `1%` for reals and integers, `20ms` or `1%` for TIME.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn parse(text: &str, ty: Scalar) -> Result<Tolerance, String> {
        if let Some(percent) = text.strip_suffix('%') {
            return positive(percent)
                .map(|percent| Tolerance::Relative(percent / 100.0))
                .ok_or_else(|| format!("`{text}` is not a percentage: write it as in 1%"));
        }
        if ty == Scalar::Time {
            return match value_text::parse(text, ty) {
                Ok(Value::Int(nanoseconds)) if nanoseconds >= 0 => {
                    Ok(Tolerance::Absolute(nanoseconds as f64))
                }
                _ => Err(format!(
                    "`{text}` is not a tolerance for a TIME: write it as in 20ms or 1%"
                )),
            };
        }
        positive(text)
            .map(Tolerance::Absolute)
            .ok_or_else(|| format!("`{text}` is not a tolerance: write it as in 0.01 or 1%"))
    }

    /// Whether a type's values have a distance.
    pub(crate) fn is_for(ty: Scalar) -> bool {
        ty.is_number() || ty == Scalar::Time
    }

    /// Whether a value is near enough.
    pub(crate) fn allows(self, expected: &Value, got: &Value, ty: Scalar) -> bool {
        let (Some(expected), Some(got)) = (number(expected, ty), number(got, ty)) else {
            return false;
        };
        let far = match self {
            Tolerance::Absolute(far) => far,
            Tolerance::Relative(part) => expected.abs() * part,
        };
        // 0.3 is within 0.1 of 0.2, though not in the last bit of floating point.
        let noise = 4.0 * f64::EPSILON * expected.abs().max(got.abs());
        (expected - got).abs() <= far + noise
    }
}

fn positive(text: &str) -> Option<f64> {
    let number: f64 = text.trim().replace('_', "").parse().ok()?;
    (number.is_finite() && number >= 0.0).then_some(number)
}

fn number(value: &Value, ty: Scalar) -> Option<f64> {
    match value {
        Value::Int(number) if ty == Scalar::Ulint => Some(*number as u64 as f64),
        Value::Int(number) => Some(*number as f64),
        Value::Real(real) => Some(*real),
        _ => None,
    }
}
