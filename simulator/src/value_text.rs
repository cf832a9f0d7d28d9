//! Values as text: for traces, for people, and back.

use ladder_analysis::values::compound::Enumeration;
use ladder_analysis::values::literal::{Literal, LiteralProblem, literal};
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::{Value, wrap};
use ladder_analysis::with_article;
use ladder_syntax::Name;
use std::fmt::{self, Write};

/// A value as a cell of a trace: BOOL as 0 or 1, TIME in milliseconds, reals in the shortest form that reads back
/// the same, always with a point or exponent, bit strings as plain numbers, text as it is (bytes that are no text
/// as `$hh`).
pub fn cell(value: &Value, ty: Scalar) -> String {
    let mut text = String::new();
    // Writing to a string does not fail.
    let _ = write_cell(&mut text, value, ty);
    text
}

/// A value as a person reads it, and as the language writes it: `TRUE`, `T#1m30s`, `16#00FF`, `'text'`.
pub fn display(value: &Value, ty: Scalar) -> String {
    let mut text = String::new();
    let _ = write_display(&mut text, value, ty);
    text
}

/// Nanoseconds as a duration is written where nothing else can be meant: `1m30s`.
pub fn duration(nanoseconds: i64) -> String {
    let text = display(&Value::Int(nanoseconds), Scalar::Time);
    text.trim_start_matches("T#").to_owned()
}

/// Nanoseconds as milliseconds: whole, or with the decimals they need.
pub fn milliseconds(nanoseconds: i64) -> String {
    let mut text = String::new();
    let _ = write_milliseconds(&mut text, nanoseconds);
    text
}

/// See [`cell`]. Allocates nothing.
pub(crate) fn write_cell(out: &mut dyn Write, value: &Value, ty: Scalar) -> fmt::Result {
    match value {
        Value::Bool(high) => out.write_str(if *high { "1" } else { "0" }),
        // A REAL is shortest among 32-bit numbers: 0.1, not 0.10000000149011612.
        Value::Real(real) if ty == Scalar::Real => write!(out, "{:?}", *real as f32),
        Value::Real(real) => write!(out, "{real:?}"),
        Value::Text(bytes) => write_characters(out, bytes, false),
        Value::Int(number) => match ty {
            Scalar::Time => write_milliseconds(out, *number),
            Scalar::Date => write_date(out, *number),
            Scalar::Tod => write_time_of_day(out, *number),
            Scalar::Dt => {
                write_date(out, *number)?;
                out.write_str("-")?;
                write_time_of_day(out, *number)
            }
            // Held as the same 64 bits.
            Scalar::Ulint | Scalar::Lword => write!(out, "{}", *number as u64),
            Scalar::Enum(id) => match id.get().name_of(*number) {
                Some(name) => out.write_str(name),
                None => write!(out, "{number}"),
            },
            _ => write!(out, "{number}"),
        },
    }
}

/// See [`display`]. Allocates nothing.
pub(crate) fn write_display(out: &mut dyn Write, value: &Value, ty: Scalar) -> fmt::Result {
    match (value, ty) {
        (Value::Bool(high), _) => out.write_str(if *high { "TRUE" } else { "FALSE" }),
        (Value::Text(bytes), _) => {
            out.write_str("'")?;
            write_characters(out, bytes, true)?;
            out.write_str("'")
        }
        (Value::Int(number), Scalar::Time) => write_duration(out, *number),
        (Value::Int(_), Scalar::Date) => {
            out.write_str("D#")?;
            write_cell(out, value, ty)
        }
        (Value::Int(_), Scalar::Tod) => {
            out.write_str("TOD#")?;
            write_cell(out, value, ty)
        }
        (Value::Int(_), Scalar::Dt) => {
            out.write_str("DT#")?;
            write_cell(out, value, ty)
        }
        (Value::Int(number), _) if ty.is_bits() => {
            write!(
                out,
                "16#{:0width$X}",
                *number as u64,
                width = ty.width() as usize / 4
            )
        }
        _ => write_cell(out, value, ty),
    }
}

/// See [`milliseconds`]. Allocates nothing.
pub(crate) fn write_milliseconds(out: &mut dyn Write, nanoseconds: i64) -> fmt::Result {
    let sign = if nanoseconds < 0 { "-" } else { "" };
    let nanoseconds = nanoseconds.unsigned_abs();
    write!(out, "{sign}{}", nanoseconds / 1_000_000)?;
    write_fraction(out, nanoseconds % 1_000_000, 6)
}

/// A point and the digits of a fraction, without zeros at its end; nothing for 0.
fn write_fraction(out: &mut dyn Write, mut fraction: u64, mut digits: usize) -> fmt::Result {
    if fraction == 0 {
        return Ok(());
    }
    while fraction.is_multiple_of(10) {
        fraction /= 10;
        digits -= 1;
    }
    write!(out, ".{fraction:0digits$}")
}

/// `T#1h30m`, with the units that it needs.
fn write_duration(out: &mut dyn Write, nanoseconds: i64) -> fmt::Result {
    out.write_str(if nanoseconds < 0 { "T#-" } else { "T#" })?;
    let mut rest = nanoseconds.unsigned_abs();
    let units = [
        ("d", 86_400_000_000_000),
        ("h", 3_600_000_000_000),
        ("m", 60_000_000_000),
        ("s", 1_000_000_000),
        ("ms", 1_000_000),
        ("us", 1_000),
        ("ns", 1),
    ];
    if rest == 0 {
        out.write_str("0s")?;
    }
    for (unit, size) in units {
        let count = rest / size;
        rest %= size;
        if count > 0 {
            write!(out, "{count}{unit}")?;
        }
    }
    Ok(())
}

const DAY: i64 = 86_400_000_000_000;

/// `2026-11-21`: the Gregorian calendar, counted in eras of 400 years that begin in March.
fn write_date(out: &mut dyn Write, nanoseconds: i64) -> fmt::Result {
    let days = nanoseconds.div_euclid(DAY) + 719_468;
    let (era, day_of_era) = (days.div_euclid(146_097), days.rem_euclid(146_097));
    let year_of_era = (day_of_era - day_of_era / 1_460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let shifted = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * shifted + 2) / 5 + 1;
    let month = if shifted < 10 { shifted + 3 } else { shifted - 9 };
    let year = era * 400 + year_of_era + i64::from(month <= 2);
    write!(out, "{year:04}-{month:02}-{day:02}")
}

/// `13:45:00.5`
fn write_time_of_day(out: &mut dyn Write, nanoseconds: i64) -> fmt::Result {
    let of_day = nanoseconds.rem_euclid(DAY) as u64;
    let seconds = of_day / 1_000_000_000;
    write!(
        out,
        "{:02}:{:02}:{:02}",
        seconds / 3600,
        seconds / 60 % 60,
        seconds % 60
    )?;
    write_fraction(out, of_day % 1_000_000_000, 9)
}

fn write_characters(out: &mut dyn Write, bytes: &[u8], quoted: bool) -> fmt::Result {
    for chunk in bytes.utf8_chunks() {
        for c in chunk.valid().chars() {
            match c {
                '\'' if quoted => out.write_str("$'")?,
                '$' if quoted => out.write_str("$$")?,
                '\n' if quoted => out.write_str("$N")?,
                '\r' if quoted => out.write_str("$R")?,
                '\t' if quoted => out.write_str("$T")?,
                c if quoted && c.is_ascii_control() => write!(out, "${:02X}", c as u32)?,
                c => out.write_char(c)?,
            }
        }
        for byte in chunk.invalid() {
            write!(out, "${byte:02X}")?;
        }
    }
    Ok(())
}

/// Reads a value that a person or a file gives for a tag: a literal of the language without need of a prefix, BOOL
/// also as 0 and 1, TIME also as a number of milliseconds, text with or without quotes.
///
/// # Errors
/// What is wrong with it, and how it is written.
pub fn parse(text: &str, ty: Scalar) -> Result<Value, String> {
    let text = text.trim();
    if ty.is_string() {
        let quoted = text.len() > 1 && text.starts_with('\'') && text.ends_with('\'');
        if !quoted {
            return Ok(Value::Text(text.as_bytes().into()));
        }
    }
    if let Scalar::Enum(id) = ty {
        return enumeration_value(text, &id.get());
    }
    let wrong = || {
        format!(
            "`{text}` is not a value for {}: {}",
            with_article(ty),
            example(ty)
        )
    };
    if text.is_empty() {
        return Err(wrong());
    }
    let (negative, magnitude) = match text.strip_prefix('-') {
        Some(rest) if !rest.starts_with(['-', '+']) => (true, rest),
        Some(_) => return Err(wrong()),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    };
    let value = match literal(magnitude) {
        Ok(value) => value,
        Err(problem) => {
            // `2026-11-21` and `13:45:00` are literals after their prefix only.
            let prefixed = match ty {
                Scalar::Date => literal(&format!("D#{magnitude}")),
                Scalar::Tod => literal(&format!("TOD#{magnitude}")),
                Scalar::Dt => literal(&format!("DT#{magnitude}")),
                _ => Err(problem),
            };
            prefixed.map_err(|problem| match problem {
                LiteralProblem::Malformed(_) => wrong(),
                LiteralProblem::OutOfRange(why) => {
                    format!("`{text}` is not a value for {}: {why}", with_article(ty))
                }
            })?
        }
    };
    let value = match value {
        Literal::Typed(_, inner) => *inner,
        other => other,
    };
    let signed = |number: i128| if negative { -number } else { number };
    match (value, ty) {
        (Literal::Bool(high), Scalar::Bool) if !negative => Ok(Value::Bool(high)),
        (Literal::Int(number @ (0 | 1)), Scalar::Bool) if !negative => Ok(Value::Bool(number == 1)),
        (Literal::Int(number), _) if ty.is_real() => real(signed(number) as f64, ty).ok_or_else(wrong),
        (Literal::Real(number), _) if ty.is_real() => {
            real(if negative { -number } else { number }, ty).ok_or_else(wrong)
        }
        (Literal::Int(number), _) if ty.bounds().is_some() => {
            let (low, high) = ty.bounds().unwrap_or((0, 0));
            if !(low..=high).contains(&signed(number)) {
                return Err(format!("{text} does not fit: {ty} holds {low} to {high}"));
            }
            Ok(Value::Int(wrap(signed(number) as i64, ty)))
        }
        (Literal::Time(nanoseconds), Scalar::Time) => Ok(Value::Int(if negative {
            nanoseconds.saturating_neg()
        } else {
            nanoseconds
        })),
        (Literal::Int(number), Scalar::Time) => {
            let nanoseconds = i64::try_from(signed(number) * 1_000_000);
            nanoseconds
                .map(Value::Int)
                .map_err(|_| format!("{text} ms does not fit: TIME holds about 292 years"))
        }
        (Literal::Real(number), Scalar::Time) => {
            let nanoseconds = (if negative { -number } else { number } * 1e6).round();
            if nanoseconds.abs() < 9.2e18 {
                Ok(Value::Int(nanoseconds as i64))
            } else {
                Err(wrong())
            }
        }
        (Literal::Date(number), Scalar::Date)
        | (Literal::Tod(number), Scalar::Tod)
        | (Literal::Dt(number), Scalar::Dt)
            if !negative =>
        {
            Ok(Value::Int(number))
        }
        (Literal::Text(bytes), Scalar::String(_)) if !negative => Ok(Value::Text(bytes)),
        _ => Err(wrong()),
    }
}

/// `FILLING`, in any case, also with its type before it.
fn enumeration_value(text: &str, enumeration: &Enumeration) -> Result<Value, String> {
    let name = match text.split_once('.') {
        Some((ty, name)) if Name::new(ty.trim()) == Name::new(&enumeration.name) => name.trim(),
        _ => text,
    };
    let found = enumeration
        .number(name)
        .map(|number| Value::Int(i64::from(number)));
    found.ok_or_else(|| {
        const NAMED: usize = 20;
        let names = enumeration
            .values
            .iter()
            .take(NAMED)
            .map(|(name, _)| name.as_str());
        let names: Vec<&str> = names.collect();
        format!(
            "`{text}` is not a value of {}: write one of {}",
            enumeration.name,
            names.join(" ")
        )
    })
}

fn real(number: f64, ty: Scalar) -> Option<Value> {
    let number = if ty == Scalar::Real {
        f64::from(number as f32)
    } else {
        number
    };
    number.is_finite().then_some(Value::Real(number))
}

fn example(ty: Scalar) -> &'static str {
    match ty {
        Scalar::Bool => "write 0, 1, TRUE or FALSE",
        Scalar::Time => "write a duration as in 5s or T#1h30m, or a number of milliseconds",
        Scalar::Date => "write a date as in 2026-11-21",
        Scalar::Tod => "write a time of day as in 13:45:00",
        Scalar::Dt => "write a date and time as in 2026-11-21-13:45:00",
        Scalar::Real | Scalar::Lreal => "write a number as in 3.14 or 1.0e-3",
        Scalar::String(_) => "write a text, as it is or in quotes as in 'text'",
        _ => "write a whole number as in 42 or 16#FF",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn read_and_written() {
        let table = [
            ("1", Scalar::Bool, "1", "TRUE"),
            ("false", Scalar::Bool, "0", "FALSE"),
            ("-7", Scalar::Int, "-7", "-7"),
            ("16#ff", Scalar::Word, "255", "16#00FF"),
            (
                "18446744073709551615",
                Scalar::Ulint,
                "18446744073709551615",
                "18446744073709551615",
            ),
            ("0.1", Scalar::Real, "0.1", "0.1"),
            ("1", Scalar::Lreal, "1.0", "1.0"),
            ("1e300", Scalar::Lreal, "1e300", "1e300"),
            ("5s", Scalar::Time, "5000", "T#5s"),
            ("T#-1.5ms", Scalar::Time, "-1.5", "T#-1ms500us"),
            ("-250", Scalar::Time, "-250", "T#-250ms"),
            ("0.5", Scalar::Time, "0.5", "T#500us"),
            ("1h30m", Scalar::Time, "5400000", "T#1h30m"),
            ("0", Scalar::Time, "0", "T#0s"),
            ("2026-11-21", Scalar::Date, "2026-11-21", "D#2026-11-21"),
            ("TOD#13:45:00.5", Scalar::Tod, "13:45:00.5", "TOD#13:45:00.5"),
            (
                "2000-02-29-23:59:59",
                Scalar::Dt,
                "2000-02-29-23:59:59",
                "DT#2000-02-29-23:59:59",
            ),
            ("it is", Scalar::String(80), "it is", "'it is'"),
            ("'a$'b$00'", Scalar::String(80), "a'b\0", "'a$'b$00'"),
        ];
        for (text, ty, in_trace, shown) in table {
            let value = parse(text, ty).unwrap();
            assert_eq!(cell(&value, ty), in_trace, "{text}");
            assert_eq!(display(&value, ty), shown, "{text}");
            assert_eq!(parse(&display(&value, ty), ty).unwrap(), value, "{shown}");
        }
    }

    #[test]
    fn refused() {
        let check = |text, ty, expected: expect_test::Expect| {
            expected.assert_eq(&parse(text, ty).unwrap_err());
        };
        check(
            "2",
            Scalar::Bool,
            expect_test::expect!["`2` is not a value for a BOOL: write 0, 1, TRUE or FALSE"],
        );
        check(
            "40000",
            Scalar::Int,
            expect_test::expect!["40000 does not fit: INT holds -32768 to 32767"],
        );
        check(
            "five",
            Scalar::Time,
            expect_test::expect![
                "`five` is not a value for a TIME: write a duration as in 5s or T#1h30m, or a number of milliseconds"
            ],
        );
        check(
            "",
            Scalar::Dint,
            expect_test::expect!["`` is not a value for a DINT: write a whole number as in 42 or 16#FF"],
        );
        check(
            "1e39",
            Scalar::Real,
            expect_test::expect!["`1e39` is not a value for a REAL: write a number as in 3.14 or 1.0e-3"],
        );
    }
}
