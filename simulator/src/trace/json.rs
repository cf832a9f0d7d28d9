//! One object: the program, the tags with their types, and the scans with their values in the order of the tags.
//!
//! Written by hand, as this crate knows no JSON library: strings are the only thing that needs care.

use super::{Header, Write, time_of};
use crate::value_text;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;

#[derive(Debug)]
pub(super) struct Json;

impl Write for Json {
    fn begin(&mut self, header: &Header, out: &mut String) {
        out.push_str("{\n  \"program\": ");
        push_string(&header.program, out);
        out.push_str(",\n  \"interval_ms\": ");
        out.push_str(&value_text::milliseconds(header.interval));
        for (index, name) in header.unread_parts.iter().enumerate() {
            out.push_str(if index == 0 {
                ",\n  \"unread_parts\": ["
            } else {
                ", "
            });
            push_string(name, out);
        }
        out.push_str(if header.unread_parts.is_empty() { "" } else { "]" });
        out.push_str(",\n  \"tags\": [");
        for (index, tag) in header.tags.iter().enumerate() {
            out.push_str(if index == 0 { "\n" } else { ",\n" });
            out.push_str("    { \"name\": ");
            push_string(&tag.name, out);
            out.push_str(", \"type\": ");
            match tag.ty() {
                Scalar::Enum(id) => push_string(&id.get().name, out),
                ty => push_string(ty.name(), out),
            }
            out.push_str(" }");
        }
        out.push_str(if header.tags.is_empty() { "]" } else { "\n  ]" });
        out.push_str(",\n  \"scans\": [");
    }

    fn row(&mut self, header: &Header, scan: u64, values: &[Value], out: &mut String) {
        out.push_str(if scan == 0 { "\n" } else { ",\n" });
        let time = value_text::milliseconds(time_of(scan, header.interval));
        out.push_str(&format!(
            "    {{ \"scan\": {scan}, \"time_ms\": {time}, \"values\": ["
        ));
        for (index, (tag, value)) in header.tags.iter().zip(values).enumerate() {
            if index > 0 {
                out.push_str(", ");
            }
            push_value(value, tag.ty(), out);
        }
        out.push_str("] }");
    }

    fn end(&mut self, _: &Header, scans: u64, out: &mut String) {
        out.push_str(if scans == 0 { "]\n}\n" } else { "\n  ]\n}\n" });
    }
}

/// The largest whole number that every reader of JSON holds exactly.
const EXACT: u64 = 1 << 53;

/// BOOL as true or false, numbers as numbers, TIME in milliseconds; texts, dates, values of enumerations and integers past 2^53 as
/// strings.
fn push_value(value: &Value, ty: Scalar, out: &mut String) {
    let cell = value_text::cell(value, ty);
    match value {
        Value::Bool(high) => out.push_str(if *high { "true" } else { "false" }),
        Value::Text(_) => push_string(&cell, out),
        Value::Int(_) if ty.is_date() || matches!(ty, Scalar::Enum(_)) => push_string(&cell, out),
        Value::Int(number) if is_exact(*number, ty) => out.push_str(&cell),
        Value::Int(_) => push_string(&cell, out),
        Value::Real(real) if real.is_finite() => out.push_str(&cell),
        Value::Real(_) => out.push_str("null"),
    }
}

fn is_exact(number: i64, ty: Scalar) -> bool {
    match ty {
        Scalar::Time => true,
        Scalar::Ulint | Scalar::Lword => number as u64 <= EXACT,
        _ => number.unsigned_abs() <= EXACT,
    }
}

/// A string with its quotes.
fn push_string(text: &str, out: &mut String) {
    out.push('"');
    for c in text.chars() {
        match c {
            '"' => out.push_str("\\\""),
            '\\' => out.push_str("\\\\"),
            '\n' => out.push_str("\\n"),
            '\r' => out.push_str("\\r"),
            '\t' => out.push_str("\\t"),
            c if u32::from(c) < 0x20 => out.push_str(&format!("\\u{:04x}", u32::from(c))),
            c => out.push(c),
        }
    }
    out.push('"');
}
