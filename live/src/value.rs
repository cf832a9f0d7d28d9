//! Values as JSON and back.

use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_analysis::with_article;
use ladder_simulator::value_text;
use serde_json::{Number, Value as Json};

use crate::action::Given;

/// The largest whole number that every client's JSON reader holds exactly.
const EXACT: u64 = 1 << 53;

/// A value for the client: BOOL as true or false, integers and reals as numbers, past 2^53 as text, TIME in
/// milliseconds, STRING and dates as text.
pub(crate) fn to_json(value: &Value, ty: Scalar) -> Json {
    match (value, ty) {
        (Value::Bool(high), _) => Json::Bool(*high),
        (Value::Real(real), Scalar::Real) => {
            // The shortest text of the 32 bits: 0.1, not 0.10000000149011612.
            (*real as f32)
                .to_string()
                .parse()
                .map_or(Json::Null, real_to_json)
        }
        (Value::Real(real), _) => real_to_json(*real),
        (Value::Int(nanoseconds), Scalar::Time) if nanoseconds % 1_000_000 == 0 => {
            Json::from(nanoseconds / 1_000_000)
        }
        (Value::Int(nanoseconds), Scalar::Time) => real_to_json(*nanoseconds as f64 / 1e6),
        (Value::Int(_), _) if ty.is_date() => Json::from(value_text::display(value, ty)),
        (Value::Int(number), Scalar::Ulint | Scalar::Lword) => match *number as u64 {
            number if number <= EXACT => Json::from(number),
            number => Json::from(number.to_string()),
        },
        (Value::Int(number), _) if number.unsigned_abs() <= EXACT => Json::from(*number),
        (Value::Int(number), _) => Json::from(number.to_string()),
        (Value::Text(_), _) => Json::from(value_text::cell(value, ty)),
    }
}

fn real_to_json(real: f64) -> Json {
    Number::from_f64(real).map_or(Json::Null, Json::Number)
}

/// A value from the client. The message says what the type takes.
///
/// # Errors
/// The type takes no such value: a sentence for the person.
pub fn from_json(json: &Json, ty: Scalar) -> Result<Value, String> {
    match json {
        Json::String(text) if ty.is_string() => Ok(Value::Text(text.as_bytes().into())),
        Json::String(text) => value_text::parse(text, ty),
        Json::Bool(high) => value_text::parse(if *high { "TRUE" } else { "FALSE" }, ty),
        Json::Number(number) if !ty.is_string() => {
            let real = number
                .as_f64()
                .filter(|real| real.fract() == 0.0 && real.abs() <= EXACT as f64);
            match real {
                // Some clients know no whole numbers and send 5.0.
                Some(whole) if number.is_f64() => value_text::parse(&(whole as i64).to_string(), ty),
                _ => value_text::parse(&number.to_string(), ty),
            }
        }
        _ => Err(format!("{json} is not a value for {}", with_article(ty))),
    }
}

/// A value that a client gives a tag of a type.
pub(crate) fn from_given(given: &Given, ty: Scalar) -> Result<Value, String> {
    match given {
        Given::Json(json) => from_json(json, ty),
        Given::Typed(text) => from_typed(text, ty),
    }
}

/// A value as a person types it: a BOOL also as `on`, `off`, `high` and `low`.
fn from_typed(text: &str, ty: Scalar) -> Result<Value, String> {
    if ty == Scalar::Bool {
        match text.trim().to_ascii_lowercase().as_str() {
            "on" | "high" => return Ok(Value::Bool(true)),
            "off" | "low" => return Ok(Value::Bool(false)),
            _ => {}
        }
    }
    value_text::parse(text, ty)
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn back(json: Json, ty: Scalar) -> Result<Json, String> {
        from_json(&json, ty).map(|value| to_json(&value, ty))
    }

    #[test]
    fn what_is_sent_comes_back() {
        for (json, ty) in [
            (json!(true), Scalar::Bool),
            (json!(-128), Scalar::Sint),
            (json!(65535), Scalar::Word),
            (json!(9_007_199_254_740_992_i64), Scalar::Lint),
            (json!("9223372036854775807"), Scalar::Lint),
            (json!("-9223372036854775808"), Scalar::Lint),
            (json!("18446744073709551615"), Scalar::Ulint),
            (json!("18446744073709551615"), Scalar::Lword),
            (json!(0.1), Scalar::Real),
            (json!(0.1), Scalar::Lreal),
            (json!(-2.5e-7), Scalar::Lreal),
            (json!(1500), Scalar::Time),
            (json!(0.25), Scalar::Time),
            (json!("D#2026-11-21"), Scalar::Date),
            (json!("TOD#13:45:00"), Scalar::Tod),
            (json!("DT#2026-11-21-13:45:00"), Scalar::Dt),
            (json!(" 'quoted' $ "), Scalar::String(80)),
            (json!(""), Scalar::String(80)),
        ] {
            assert_eq!(back(json.clone(), ty), Ok(json), "{ty}");
        }
    }

    #[test]
    fn other_spellings_are_understood() {
        for (json, ty, means) in [
            (json!(1), Scalar::Bool, json!(true)),
            (json!("FALSE"), Scalar::Bool, json!(false)),
            (json!("TRUE"), Scalar::Bool, json!(true)),
            (json!("5s"), Scalar::Time, json!(5000)),
            (json!("T#1m"), Scalar::Time, json!(60_000)),
            (json!("16#FF"), Scalar::Byte, json!(255)),
            (json!(7.0), Scalar::Int, json!(7)),
            (json!(3), Scalar::Lreal, json!(3.0)),
        ] {
            assert_eq!(back(json.clone(), ty), Ok(means), "{json} as {ty}");
        }
    }

    #[test]
    fn what_does_not_fit_is_refused() {
        for (json, ty) in [
            (json!(2), Scalar::Bool),
            (json!("maybe"), Scalar::Bool),
            (json!(128), Scalar::Sint),
            (json!(-1), Scalar::Word),
            (json!(1.5), Scalar::Dint),
            (json!(1e300), Scalar::Dint),
            (json!(true), Scalar::Dint),
            (json!("many"), Scalar::Dint),
            (json!(7), Scalar::String(80)),
            (json!(null), Scalar::Lint),
            (json!([1]), Scalar::Lint),
            (json!({}), Scalar::Bool),
        ] {
            assert!(back(json.clone(), ty).is_err(), "{json} as {ty}");
        }
    }
    #[test]
    fn what_is_typed_is_read_by_its_type() {
        let typed = |text, ty| from_typed(text, ty).map(|value| to_json(&value, ty));
        for (text, ty, means) in [
            ("1", Scalar::Bool, json!(true)),
            ("TRUE", Scalar::Bool, json!(true)),
            (" on", Scalar::Bool, json!(true)),
            ("High", Scalar::Bool, json!(true)),
            ("0", Scalar::Bool, json!(false)),
            ("false", Scalar::Bool, json!(false)),
            ("off", Scalar::Bool, json!(false)),
            ("T#1h30m", Scalar::Time, json!(5_400_000)),
            ("1m30.5s", Scalar::Time, json!(90_500)),
            ("250", Scalar::Time, json!(250)),
            ("16#FF", Scalar::Int, json!(255)),
            ("-1_000", Scalar::Dint, json!(-1000)),
            ("1.5e-3", Scalar::Lreal, json!(0.0015)),
            ("9007199254740993", Scalar::Lint, json!("9007199254740993")),
            ("'it$'s'", Scalar::String(80), json!("it's")),
            ("a b", Scalar::String(80), json!("a b")),
        ] {
            assert_eq!(typed(text, ty), Ok(means), "{text} as {ty}");
        }
        for (text, ty) in [
            ("maybe", Scalar::Bool),
            ("0x10", Scalar::Int),
            ("on", Scalar::Int),
        ] {
            assert!(typed(text, ty).is_err(), "{text} as {ty}");
        }
    }
}
