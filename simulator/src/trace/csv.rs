//! A table: a header of names, then a row for each scan.

use super::{Header, time_of};
use crate::value_text;
use ladder_analysis::values::value::Value;
use std::fmt::Write;

#[derive(Debug)]
pub(super) struct Csv;

impl super::Write for Csv {
    fn begin(&mut self, header: &Header, out: &mut String) {
        out.push_str("scan,time_ms");
        for tag in &header.tags {
            out.push(',');
            push_cell(&tag.name, out);
        }
        out.push('\n');
    }

    fn row(&mut self, header: &Header, scan: u64, values: &[Value], out: &mut String) {
        // Writing to a String does not fail.
        let _ = write!(out, "{scan},");
        let _ = value_text::write_milliseconds(out, time_of(scan, header.interval));
        for (tag, value) in header.tags.iter().zip(values) {
            out.push(',');
            match value {
                Value::Text(_) => push_cell(&value_text::cell(value, tag.ty()), out),
                _ => drop(value_text::write_cell(out, value, tag.ty())),
            }
        }
        out.push('\n');
    }

    fn end(&mut self, _: &Header, _: u64, _: &mut String) {}
}

/// A cell that would end early, or begin a new one, is in quotes; a quote in it is doubled.
fn push_cell(text: &str, out: &mut String) {
    if !text.contains([',', '"', '\n', '\r']) {
        out.push_str(text);
        return;
    }
    out.push('"');
    out.push_str(&text.replace('"', "\"\""));
    out.push('"');
}

#[cfg(test)]
mod tests {
    use super::push_cell;

    #[test]
    fn cells_that_need_quotes_have_them() {
        for (text, cell) in [
            ("run", "run"),
            ("", ""),
            ("two words", "two words"),
            ("a,b", "\"a,b\""),
            ("say \"on\"", "\"say \"\"on\"\"\""),
            ("two\nlines", "\"two\nlines\""),
            ("cr\r", "\"cr\r\""),
        ] {
            let mut out = String::new();
            push_cell(text, &mut out);
            assert_eq!(out, cell);
        }
    }
}
