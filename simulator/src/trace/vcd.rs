//! A value change dump (IEEE 1364, §18), which waveform viewers such as GTKWave read.
//!
//! BOOL is a wire, integers and bit strings are vectors of their width, reals are reals, and TIME is a real number
//! of milliseconds, so that a viewer can draw a timer as a ramp. Texts, dates and values of enumerations are strings, a
//! kind that GTKWave added. Members are in a scope of their tag's name: `warmup.ET` is `ET` in `warmup`.

use super::{Header, Write};
use crate::value_text;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use std::collections::BTreeMap;

#[derive(Debug, Default)]
pub(super) struct Vcd {
    /// How many of the time scale's units an interval has.
    units: i64,
    /// What each variable held last.
    before: Vec<Value>,
}

impl Write for Vcd {
    fn begin(&mut self, header: &Header, out: &mut String) {
        let (scale, units) = time_scale(header.interval);
        self.units = units;
        out.push_str("$comment TIME is in milliseconds $end\n");
        out.push_str(&format!("$version ladder {} $end\n", env!("CARGO_PKG_VERSION")));
        out.push_str(&format!("$timescale {scale} $end\n"));
        let mut top = Scope::default();
        for (index, tag) in header.tags.iter().enumerate() {
            let (folders, name) = path(&tag.name);
            let scope = folders.iter().fold(&mut top, |scope, folder| {
                scope.inner.entry((*folder).to_owned()).or_default()
            });
            scope.variables.push((name.to_owned(), index));
        }
        let file = header.program.rsplit(['/', '\\']).next().unwrap_or_default();
        let stem = file.rsplit_once('.').map_or(file, |(stem, _)| stem);
        top.declare(if stem.is_empty() { "program" } else { stem }, header, out);
        out.push_str("$enddefinitions $end\n");
    }

    fn row(&mut self, header: &Header, scan: u64, values: &[Value], out: &mut String) {
        let first = self.before.is_empty();
        let mut stamped = false;
        for (index, value) in values.iter().enumerate() {
            if !first && self.before[index] == *value {
                continue;
            }
            if !stamped {
                out.push_str(&format!("#{}\n", i128::from(scan) * i128::from(self.units)));
                if first {
                    out.push_str("$dumpvars\n");
                }
                stamped = true;
            }
            push_change(value, header.tags[index].ty(), &identifier(index), out);
        }
        if first && stamped {
            out.push_str("$end\n");
        }
        self.before.clear();
        self.before.extend_from_slice(values);
    }

    /// The last scan, too, lasts for one interval.
    fn end(&mut self, _: &Header, scans: u64, out: &mut String) {
        out.push_str(&format!("#{}\n", i128::from(scans) * i128::from(self.units)));
    }
}

/// What is under one name.
#[derive(Debug, Default)]
struct Scope {
    /// Names, and their tags by number.
    variables: Vec<(String, usize)>,
    inner: BTreeMap<String, Scope>,
}

impl Scope {
    fn declare(&self, name: &str, header: &Header, out: &mut String) {
        out.push_str(&format!("$scope module {} $end\n", word(name)));
        for (name, index) in &self.variables {
            let (kind, width) = kind(header.tags[*index].ty());
            out.push_str(&format!(
                "$var {kind} {width} {} {} $end\n",
                identifier(*index),
                word(name)
            ));
        }
        for (name, scope) in &self.inner {
            scope.declare(name, header, out);
        }
        out.push_str("$upscope $end\n");
    }
}

/// The scopes a name is in, and its last part. The point in `%IX0.3` belongs to the name.
fn path(name: &str) -> (Vec<&str>, &str) {
    if name.starts_with('%') {
        return (Vec::new(), name);
    }
    let mut parts: Vec<&str> = name.split('.').map(str::trim).collect();
    let last = parts.pop().unwrap_or(name);
    (parts, last)
}

/// White space would end a name.
fn word(name: &str) -> String {
    name.chars()
        .map(|c| if c.is_whitespace() { '_' } else { c })
        .collect()
}

/// The kind of a variable and its width.
fn kind(ty: Scalar) -> (&'static str, u32) {
    match ty {
        Scalar::Bool => ("wire", 1),
        Scalar::Time => ("real", 64),
        Scalar::Date | Scalar::Tod | Scalar::Dt | Scalar::String(_) | Scalar::Enum(_) => ("string", 1),
        _ if ty.is_real() => ("real", 64),
        _ if ty.is_signed() => ("integer", ty.width()),
        _ => ("reg", ty.width()),
    }
}

/// The n-th short name that the dump uses: the 94 visible characters of ASCII as digits.
fn identifier(mut number: usize) -> String {
    let mut text = String::new();
    loop {
        text.push(char::from(b'!' + (number % 94) as u8));
        number /= 94;
        if number == 0 {
            return text;
        }
        number -= 1;
    }
}

fn push_change(value: &Value, ty: Scalar, identifier: &str, out: &mut String) {
    match value {
        Value::Bool(high) => out.push_str(&format!("{}{identifier}\n", u8::from(*high))),
        Value::Real(_) => out.push_str(&format!("r{} {identifier}\n", value_text::cell(value, ty))),
        Value::Int(nanoseconds) if ty == Scalar::Time => {
            out.push_str(&format!(
                "r{} {identifier}\n",
                value_text::milliseconds(*nanoseconds)
            ));
        }
        Value::Int(_) if ty.is_date() || matches!(ty, Scalar::Enum(_)) => {
            push_text(&value_text::cell(value, ty), identifier, out);
        }
        Value::Int(number) => {
            let mask = u64::MAX >> (64 - ty.width());
            out.push_str(&format!("b{:b} {identifier}\n", *number as u64 & mask));
        }
        Value::Text(_) => push_text(&value_text::cell(value, ty), identifier, out),
    }
}

/// White space ends a string's value, so it is written as GTKWave reads it: `\040`.
fn push_text(text: &str, identifier: &str, out: &mut String) {
    out.push('s');
    for c in text.chars() {
        match c {
            '\\' => out.push_str("\\\\"),
            c if c.is_ascii() && !c.is_ascii_graphic() => out.push_str(&format!("\\{:03o}", u32::from(c))),
            c => out.push(c),
        }
    }
    out.push_str(&format!(" {identifier}\n"));
}

/// The coarsest time scale that an interval is a whole number of, and that number.
fn time_scale(interval: i64) -> (&'static str, i64) {
    let scales = [
        ("1 s", 1_000_000_000),
        ("100 ms", 100_000_000),
        ("10 ms", 10_000_000),
        ("1 ms", 1_000_000),
        ("100 us", 100_000),
        ("10 us", 10_000),
        ("1 us", 1_000),
        ("100 ns", 100),
        ("10 ns", 10),
    ];
    scales
        .into_iter()
        .find(|(_, size)| interval % size == 0)
        .map_or(("1 ns", interval), |(scale, size)| (scale, interval / size))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identifiers_are_all_different() {
        let all: std::collections::HashSet<String> = (0..20_000).map(identifier).collect();
        assert_eq!(all.len(), 20_000);
        assert_eq!([identifier(0), identifier(93), identifier(94)], ["!", "~", "!!"]);
    }

    #[test]
    fn the_time_scale_is_the_coarsest_that_fits() {
        assert_eq!(time_scale(10_000_000), ("10 ms", 1));
        assert_eq!(time_scale(12_500_000), ("100 us", 125));
        assert_eq!(time_scale(2_000_000_000), ("1 s", 2));
        assert_eq!(time_scale(7), ("1 ns", 7));
    }

    #[test]
    fn names_that_hold_points() {
        assert_eq!(path("warmup.ET"), (vec!["warmup"], "ET"));
        assert_eq!(path("run"), (vec![], "run"));
        assert_eq!(path("%IX0.3"), (vec![], "%IX0.3"));
    }
}
