//! Literals: from their text to a value (LANGUAGE §3).

use crate::values::types::Scalar;

/// A literal's value before its place gives it a type.
#[derive(Debug, Clone, PartialEq)]
pub enum Literal {
    /// `TRUE`, `FALSE`.
    Bool(bool),
    /// `42`, `16#FF`.
    Int(i128),
    /// `3.14`.
    Real(f64),
    /// A duration in nanoseconds.
    Time(i64),
    /// A day: nanoseconds since 1970-01-01.
    Date(i64),
    /// A time of day: nanoseconds since midnight.
    Tod(i64),
    /// A day and time: nanoseconds since 1970-01-01.
    Dt(i64),
    /// A text.
    Text(Box<[u8]>),
    /// `INT#5`: a value that names its type.
    Typed(Scalar, Box<Literal>),
}

/// Why a text is not a literal.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum LiteralProblem {
    /// It is not written like a literal; with what to do.
    Malformed(String),
    /// It names a value that its own type cannot hold.
    OutOfRange(String),
}

type Parsed<T> = Result<T, LiteralProblem>;

fn malformed<T>(message: impl Into<String>) -> Parsed<T> {
    Err(LiteralProblem::Malformed(message.into()))
}

fn out_of_range<T>(message: impl Into<String>) -> Parsed<T> {
    Err(LiteralProblem::OutOfRange(message.into()))
}

/// Reads a literal token.
///
/// # Errors
/// It is not a literal of its kind, or its value does not fit into any type.
pub fn literal(text: &str) -> Parsed<Literal> {
    if let Some(rest) = text.strip_prefix('\'') {
        return string(rest.strip_suffix('\'').unwrap_or(rest)).map(Literal::Text);
    }
    if text.eq_ignore_ascii_case("TRUE") || text.eq_ignore_ascii_case("FALSE") {
        return Ok(Literal::Bool(text.eq_ignore_ascii_case("TRUE")));
    }
    let Some((prefix, rest)) = text.split_once('#') else {
        return number(text);
    };
    match prefix.to_ascii_uppercase().as_str() {
        "T" | "TIME" | "LTIME" => time(rest).map(Literal::Time),
        "D" | "DATE" => date(rest).map(Literal::Date),
        "TOD" | "TIME_OF_DAY" => time_of_day(rest).map(Literal::Tod),
        "DT" | "DATE_AND_TIME" => date_and_time(rest).map(Literal::Dt),
        "2" | "8" | "16" => based(prefix, rest).map(Literal::Int),
        word if word.starts_with(|c: char| c.is_ascii_digit()) => {
            malformed(format!("numbers are written in base 2, 8, 10 or 16, not {word}"))
        }
        word => match Scalar::from_name(word) {
            Some(scalar) => typed(scalar, rest),
            None => malformed(format!("`{prefix}` names no type")),
        },
    }
}

/// `INT#5`, `WORD#16#00FF`, `REAL#1`, `BOOL#1`, `STRING#'text'`
fn typed(scalar: Scalar, rest: &str) -> Parsed<Literal> {
    if scalar.is_string() {
        let inside = rest.strip_prefix('\'').and_then(|text| text.strip_suffix('\''));
        return match inside {
            Some(text) => string(text).map(Literal::Text),
            None => malformed("a text is between apostrophes: STRING#'text'"),
        };
    }
    let (negative, magnitude) = match rest.strip_prefix('-') {
        Some(m) => (true, m),
        None => (false, rest.strip_prefix('+').unwrap_or(rest)),
    };
    if scalar == Scalar::Bool {
        return match rest.to_ascii_uppercase().as_str() {
            "1" | "TRUE" => Ok(Literal::Typed(scalar, Box::new(Literal::Bool(true)))),
            "0" | "FALSE" => Ok(Literal::Typed(scalar, Box::new(Literal::Bool(false)))),
            _ => malformed("a BOOL literal is BOOL#0, BOOL#1, BOOL#TRUE or BOOL#FALSE"),
        };
    }
    let value = match magnitude.split_once('#') {
        Some((base @ ("2" | "8" | "16"), digits)) => Literal::Int(based(base, digits)?),
        Some(_) => return malformed("numbers are written in base 2, 8, 10 or 16"),
        None => match number(magnitude)? {
            Literal::Time(_) => return malformed("a unit belongs to a TIME literal such as T#5s"),
            value => value,
        },
    };
    let sign = |n: i128| if negative { -n } else { n };
    let value = match (value, scalar) {
        (Literal::Int(n), _) if scalar.is_real() => Literal::Real(sign(n) as f64),
        (Literal::Real(r), _) if scalar.is_real() => Literal::Real(if negative { -r } else { r }),
        (Literal::Int(n), _) => match scalar.bounds() {
            Some((low, high)) if !(low..=high).contains(&sign(n)) => {
                return out_of_range(format!("{scalar} holds {low} to {high}"));
            }
            Some(_) => Literal::Int(sign(n)),
            None => return malformed(format!("{scalar} does not take a number")),
        },
        _ => return malformed(format!("{scalar} holds whole numbers only")),
    };
    Ok(Literal::Typed(scalar, Box::new(value)))
}

fn based(base: &str, digits: &str) -> Parsed<i128> {
    let radix = base.parse().unwrap_or(10);
    let digits = digits.strip_prefix('+').unwrap_or(digits);
    let plain = without_underscores(digits, radix)?;
    if plain.is_empty() || !plain.chars().all(|c| c.is_digit(radix)) {
        return malformed(format!("`{digits}` is not a number in base {base}"));
    }
    match u64::from_str_radix(&plain, radix) {
        Ok(n) => Ok(i128::from(n)),
        Err(_) => out_of_range("numbers have at most 64 bits"),
    }
}

/// An underscore is between two digits.
fn without_underscores(text: &str, radix: u32) -> Parsed<String> {
    let is_digit = |letter: Option<char>| letter.is_some_and(|letter| letter.is_digit(radix));
    let is_between = |(at, _): (usize, &str)| {
        is_digit(text[..at].chars().next_back()) && is_digit(text[at + 1..].chars().next())
    };
    if !text.match_indices('_').all(is_between) {
        return malformed("an underscore belongs between two digits");
    }
    Ok(text.replace('_', ""))
}

/// An integer, a real, or a duration without its prefix.
fn number(text: &str) -> Parsed<Literal> {
    let mantissa = text.trim_end_matches(|c: char| c.is_ascii_digit() || c == '_' || c == '-' || c == '+');
    let real = text.contains('.') || mantissa.ends_with(['e', 'E']);
    let digits_only = |s: &str| s.chars().all(|c| c.is_ascii_digit() || c == '_');
    if digits_only(text) {
        let plain = without_underscores(text, 10)?;
        return match plain.parse::<u64>() {
            Ok(n) => Ok(Literal::Int(i128::from(n))),
            Err(_) => out_of_range("numbers have at most 64 bits"),
        };
    }
    let real_shape = real
        && text
            .chars()
            .all(|c| c.is_ascii_digit() || matches!(c, '.' | '_' | 'e' | 'E' | '-' | '+'));
    if real_shape {
        let plain = without_underscores(text, 10)?;
        return match plain.parse::<f64>() {
            Ok(value) if value.is_finite() => Ok(Literal::Real(value)),
            Ok(_) => out_of_range("the number is too large for LREAL"),
            Err(_) => malformed("a real number is written like 3.14 or 1.0e-3"),
        };
    }
    if text.starts_with(|c: char| c.is_ascii_digit()) && text.ends_with(|c: char| c.is_ascii_alphabetic()) {
        return time(text).map(Literal::Time);
    }
    malformed("this is not a number")
}

/// The units of a duration, longest first, with their nanoseconds.
const UNITS: [(&str, i128); 7] = [
    ("d", 86_400_000_000_000),
    ("h", 3_600_000_000_000),
    ("m", 60_000_000_000),
    ("s", 1_000_000_000),
    ("ms", 1_000_000),
    ("us", 1_000),
    ("ns", 1),
];

/// `5s`, `1h30m`, `-250ms`, `1.5s`, `2d_4h`, `90m`: units in falling order, each once; only the first may hold more than the
/// next larger unit has, only the last a fraction (LANGUAGE §3).
fn time(text: &str) -> Parsed<i64> {
    let (negative, mut rest) = match text.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    };
    if rest.is_empty() {
        return malformed("a duration is written like T#5s, T#1h30m or T#250ms");
    }
    let mut total: i128 = 0;
    let mut next_unit = 0;
    let mut fraction_seen = false;
    while !rest.is_empty() {
        if fraction_seen {
            return malformed("only the last part of a duration may have a fraction");
        }
        let number_len = rest
            .find(|c: char| !(c.is_ascii_digit() || c == '.' || c == '_'))
            .unwrap_or(rest.len());
        let (number, after) = rest.split_at(number_len);
        let unit_len = after
            .find(|c: char| !c.is_ascii_alphabetic())
            .unwrap_or(after.len());
        let (unit, after) = after.split_at(unit_len);
        let unit = unit.to_ascii_lowercase();
        let Some(index) = UNITS.iter().position(|(name, _)| *name == unit) else {
            return malformed(format!("a duration has the units d h m s ms us ns, not `{unit}`"));
        };
        if index < next_unit {
            return malformed("the units of a duration come in falling order, each once");
        }
        let is_first = next_unit == 0;
        next_unit = index + 1;
        let (whole, fraction) = match number.split_once('.') {
            Some((whole, fraction)) => {
                fraction_seen = true;
                (whole, fraction)
            }
            None => (number, ""),
        };
        let whole: i128 = match without_underscores(whole, 10)?.parse() {
            Ok(n) => n,
            Err(_) => return malformed(format!("a number is missing before `{unit}`")),
        };
        let size = UNITS[index].1;
        if let Some((_, larger)) = index.checked_sub(1).map(|larger| UNITS[larger])
            && !is_first
            && whole >= larger / size
        {
            let limit = larger / size;
            return malformed(format!(
                "after another unit `{unit}` stays below {limit}: only the first part of a duration may be longer"
            ));
        }
        total = total.saturating_add(whole.saturating_mul(size));
        if fraction_seen {
            let digits = without_underscores(fraction, 10)?;
            if digits.is_empty() || digits.len() > 18 || !digits.bytes().all(|b| b.is_ascii_digit()) {
                return malformed("a fraction has 1 to 18 digits");
            }
            let nanoseconds = digits.parse().unwrap_or(0i128) * size;
            let parts = 10i128.pow(digits.len() as u32);
            if nanoseconds % parts != 0 {
                return out_of_range(format!(
                    "a TIME is a whole number of nanoseconds, and {number}{unit} is none: write fewer decimals"
                ));
            }
            total = total.saturating_add(nanoseconds / parts);
        }
        rest = match after.strip_prefix('_') {
            // Two parts may be held apart by one.
            Some("") => {
                return malformed(
                    "an underscore belongs between two digits, or between the parts of a duration",
                );
            }
            Some(next) => next,
            None => after,
        };
    }
    let signed = if negative { -total } else { total };
    match i64::try_from(signed) {
        Ok(ns) => Ok(ns),
        Err(_) => out_of_range("TIME holds about 292 years"),
    }
}

/// Days since 1970-01-01 of a day of the Gregorian calendar.
fn days(year: i64, month: i64, day: i64) -> i64 {
    let y = if month <= 2 { year - 1 } else { year };
    let era = y.div_euclid(400);
    let year_of_era = y.rem_euclid(400);
    let day_of_year = (153 * ((month + 9) % 12) + 2) / 5 + day - 1;
    let day_of_era = year_of_era * 365 + year_of_era / 4 - year_of_era / 100 + day_of_year;
    era * 146_097 + day_of_era - 719_468
}

const DAY: i64 = 86_400_000_000_000;

/// A number of digits and nothing else.
fn digits(text: &str) -> Option<i64> {
    let is_plain = text.bytes().all(|byte| byte.is_ascii_digit());
    text.parse().ok().filter(|_| is_plain)
}

fn date(text: &str) -> Parsed<i64> {
    let example = "a date is written like D#2026-11-21";
    let parts: Option<Vec<i64>> = text.split('-').map(digits).collect();
    let Some(&[year, month, day]) = parts.as_deref() else {
        return malformed(example);
    };
    let leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
    let length = match month {
        2 => 28 + i64::from(leap),
        4 | 6 | 9 | 11 => 30,
        1..=12 => 31,
        _ => return malformed(format!("there is no month {month}; {example}")),
    };
    if !(1..=length).contains(&day) {
        return malformed(format!("this month has no day {day}; {example}"));
    }
    match days(year, month, day).checked_mul(DAY) {
        Some(ns) => Ok(ns),
        None => out_of_range("dates reach from 1678 to 2262"),
    }
}

fn time_of_day(text: &str) -> Parsed<i64> {
    let example = "a time of day is written like TOD#13:45:00.5";
    let parts: Vec<&str> = text.split(':').collect();
    let &[hour, minute, second] = parts.as_slice() else {
        return malformed(example);
    };
    let (second, fraction) = second.split_once('.').unwrap_or((second, ""));
    let (Some(h), Some(m), Some(s)) = (digits(hour), digits(minute), digits(second)) else {
        return malformed(example);
    };
    if !(0..24).contains(&h) || !(0..60).contains(&m) || !(0..60).contains(&s) {
        return malformed(format!("hours go to 23, minutes and seconds to 59; {example}"));
    }
    if fraction.len() > 9 || !fraction.bytes().all(|b| b.is_ascii_digit()) {
        return malformed("a second has at most nine decimals");
    }
    let nanoseconds = format!("{fraction:0<9}").parse::<i64>().unwrap_or(0);
    Ok(((h * 60 + m) * 60 + s) * 1_000_000_000 + nanoseconds)
}

fn date_and_time(text: &str) -> Parsed<i64> {
    let Some((day, time)) = text.rsplit_once('-') else {
        return malformed("a date and time is written like DT#2026-11-21-13:45:00");
    };
    match date(day)?.checked_add(time_of_day(time)?) {
        Some(ns) => Ok(ns),
        None => out_of_range("dates reach from 1678 to 2262"),
    }
}

/// The bytes of a string's text between the quotes.
fn string(text: &str) -> Parsed<Box<[u8]>> {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find('$') {
        bytes.extend_from_slice(&rest.as_bytes()[..at]);
        let after = &rest[at + 1..];
        let escape = after.bytes().next().unwrap_or(b' ').to_ascii_uppercase();
        let (byte, len) = match escape {
            b'\'' | b'$' => (escape, 1),
            b'L' | b'N' => (b'\n', 1),
            b'R' => (b'\r', 1),
            b'T' => (b'\t', 1),
            b'P' => (0x0c, 1),
            _ => match after.get(..2).and_then(|hex| u8::from_str_radix(hex, 16).ok()) {
                Some(byte) if after.is_char_boundary(2) => (byte, 2),
                _ => return malformed("after `$` comes one of $ ' L N R T P, or two hexadecimal digits"),
            },
        };
        bytes.push(byte);
        rest = &after[len..];
    }
    bytes.extend_from_slice(rest.as_bytes());
    Ok(bytes.into())
}

#[cfg(test)]
mod tests {
    use super::*;
    use expect_test::{Expect, expect};

    fn check(texts: &[&str], expected: Expect) {
        let mut table = String::new();
        for text in texts {
            let value = match literal(text) {
                Ok(value) => format!("{value:?}"),
                Err(LiteralProblem::Malformed(m)) => format!("malformed: {m}"),
                Err(LiteralProblem::OutOfRange(m)) => format!("out of range: {m}"),
            };
            table.push_str(&format!("{text}  {value}\n"));
        }
        expected.assert_eq(&table);
    }

    #[test]
    fn numbers() {
        check(
            &[
                "42",
                "1_000",
                "16#FF",
                "8#17",
                "2#1010_0101",
                "3.14",
                "1.0e-3",
                "1e3",
                "TRUE",
                "INT#5",
                "INT#-5",
                "WORD#16#00FF",
                "REAL#1",
                "BOOL#1",
                "2#12",
                "3#1",
                "1__0",
                "SINT#200",
                "18446744073709551616",
                "FOO#1",
                "16#F_F",
                "1_e5",
                "1.0e_5",
                "1_0.2_5e1_0",
                "1_",
                "16#FF_",
                "2#_1",
                "INT#5_",
                "REAL#1_",
            ],
            expect![[r#"
                42  Int(42)
                1_000  Int(1000)
                16#FF  Int(255)
                8#17  Int(15)
                2#1010_0101  Int(165)
                3.14  Real(3.14)
                1.0e-3  Real(0.001)
                1e3  Real(1000.0)
                TRUE  Bool(true)
                INT#5  Typed(Int, Int(5))
                INT#-5  Typed(Int, Int(-5))
                WORD#16#00FF  Typed(Word, Int(255))
                REAL#1  Typed(Real, Real(1.0))
                BOOL#1  Typed(Bool, Bool(true))
                2#12  malformed: `12` is not a number in base 2
                3#1  malformed: numbers are written in base 2, 8, 10 or 16, not 3
                1__0  malformed: an underscore belongs between two digits
                SINT#200  out of range: SINT holds -128 to 127
                18446744073709551616  out of range: numbers have at most 64 bits
                FOO#1  malformed: `FOO` names no type
                16#F_F  Int(255)
                1_e5  malformed: an underscore belongs between two digits
                1.0e_5  malformed: an underscore belongs between two digits
                1_0.2_5e1_0  Real(102500000000.0)
                1_  malformed: an underscore belongs between two digits
                16#FF_  malformed: an underscore belongs between two digits
                2#_1  malformed: an underscore belongs between two digits
                INT#5_  malformed: an underscore belongs between two digits
                REAL#1_  malformed: an underscore belongs between two digits
            "#]],
        );
    }

    #[test]
    fn times_and_dates() {
        check(
            &[
                "T#5s",
                "5s",
                "T#1h30m",
                "T#90m",
                "T#1h59m59s999ms",
                "T#1h90m",
                "T#1d24h",
                "T#2s1000ms",
                "T#1h_60m",
                "TIME#-250ms",
                "T#1.5s",
                "T#2d_4h",
                "1h30m",
                "T#90m",
                "T#1s1s",
                "T#1s5m",
                "T#1.5m3s",
                "T#",
                "5x",
                "D#2026-11-21",
                "D#1970-01-01",
                "D#2023-02-29",
                "TOD#13:45:00.5",
                "DT#2026-11-21-13:45:00",
                "T#5_s",
                "T#5s_",
                "T#1_000ms",
                "T#1h__2m",
                "T#0.5us",
                "T#0.5ns",
                "T#1.0000000001s",
                "T#1.0000000000s",
                "TOD#+1:00:00",
                "TOD#1_0:00:00",
                "D#2026-11-21-",
            ],
            expect![[r#"
                T#5s  Time(5000000000)
                5s  Time(5000000000)
                T#1h30m  Time(5400000000000)
                T#90m  Time(5400000000000)
                T#1h59m59s999ms  Time(7199999000000)
                T#1h90m  malformed: after another unit `m` stays below 60: only the first part of a duration may be longer
                T#1d24h  malformed: after another unit `h` stays below 24: only the first part of a duration may be longer
                T#2s1000ms  malformed: after another unit `ms` stays below 1000: only the first part of a duration may be longer
                T#1h_60m  malformed: after another unit `m` stays below 60: only the first part of a duration may be longer
                TIME#-250ms  Time(-250000000)
                T#1.5s  Time(1500000000)
                T#2d_4h  Time(187200000000000)
                1h30m  Time(5400000000000)
                T#90m  Time(5400000000000)
                T#1s1s  malformed: the units of a duration come in falling order, each once
                T#1s5m  malformed: the units of a duration come in falling order, each once
                T#1.5m3s  malformed: only the last part of a duration may have a fraction
                T#  malformed: a duration is written like T#5s, T#1h30m or T#250ms
                5x  malformed: a duration has the units d h m s ms us ns, not `x`
                D#2026-11-21  Date(1795219200000000000)
                D#1970-01-01  Date(0)
                D#2023-02-29  malformed: this month has no day 29; a date is written like D#2026-11-21
                TOD#13:45:00.5  Tod(49500500000000)
                DT#2026-11-21-13:45:00  Dt(1795268700000000000)
                T#5_s  malformed: an underscore belongs between two digits
                T#5s_  malformed: an underscore belongs between two digits, or between the parts of a duration
                T#1_000ms  Time(1000000000)
                T#1h__2m  malformed: an underscore belongs between two digits
                T#0.5us  Time(500)
                T#0.5ns  out of range: a TIME is a whole number of nanoseconds, and 0.5ns is none: write fewer decimals
                T#1.0000000001s  out of range: a TIME is a whole number of nanoseconds, and 1.0000000001s is none: write fewer decimals
                T#1.0000000000s  Time(1000000000)
                TOD#+1:00:00  malformed: a time of day is written like TOD#13:45:00.5
                TOD#1_0:00:00  malformed: a time of day is written like TOD#13:45:00.5
                D#2026-11-21-  malformed: a date is written like D#2026-11-21
            "#]],
        );
    }

    #[test]
    fn strings() {
        check(
            &["'text'", "'a$'b$$c'", "'$N$41'", "'$Q'", "''"],
            expect![[r"
                'text'  Text([116, 101, 120, 116])
                'a$'b$$c'  Text([97, 39, 98, 36, 99])
                '$N$41'  Text([10, 65])
                '$Q'  malformed: after `$` comes one of $ ' L N R T P, or two hexadecimal digits
                ''  Text([])
            "]],
        );
    }
}
