//! Values as people enter them from outside a program: in a cell, on a command line, in an editor.

use crate::constant;
use crate::literal::{Literal, LiteralProblem, literal};
use crate::rule::Rule;
use crate::types::Scalar;
use crate::value::Value;
use ladder_syntax::TextRange;

/// Reads a value for a tag of a type: a literal of the language, which a BOOL may also be given as `0` or `1`, a
/// TIME as `5s` or as a number of milliseconds, and a STRING without its quotes.
///
/// # Errors
/// Why it is no value of that type, in words for the person who entered it.
pub fn read(text: &str, ty: Scalar) -> Result<Value, String> {
    let text = text.trim();
    let no_value = || format!("`{text}` is no {ty}; {}", example(ty));
    let (negative, entered) = match text.strip_prefix('-') {
        _ if ty.is_string() && !text.starts_with('\'') => (false, Ok(Literal::Text(text.as_bytes().into()))),
        // The digits of nothing are no number, though the literal's reader is never given nothing.
        _ if text.is_empty() => return Err(no_value()),
        Some(magnitude) => (true, literal(magnitude)),
        None => (false, literal(text.strip_prefix('+').unwrap_or(text))),
    };
    let entered = match entered {
        Ok(Literal::Int(ms)) if ty == Scalar::Time => Literal::Time(nanoseconds(text, ms as f64)?),
        Ok(Literal::Real(ms)) if ty == Scalar::Time => Literal::Time(nanoseconds(text, ms)?),
        Ok(other) => other,
        Err(LiteralProblem::OutOfRange(problem)) => return Err(format!("`{text}`: {problem}")),
        Err(LiteralProblem::Malformed(_)) => return Err(no_value()),
    };
    constant::place(&entered, negative, ty, TextRange::default()).map_err(|problem| match problem.rule {
        Rule::TypeMismatch => no_value(),
        _ => problem.message,
    })
}

/// Milliseconds, with up to six decimals that count.
fn nanoseconds(text: &str, milliseconds: f64) -> Result<i64, String> {
    let nanoseconds = (milliseconds * 1e6).round();
    if nanoseconds.abs() < i64::MAX as f64 {
        return Ok(nanoseconds as i64);
    }
    Err(format!("`{text}`: TIME holds about 292 years"))
}

/// How a value of a type is entered.
fn example(ty: Scalar) -> &'static str {
    match ty {
        Scalar::Bool => "write 0, 1, FALSE or TRUE",
        Scalar::Time => "write a duration such as 5s or 250ms, or a number of milliseconds",
        Scalar::Date => "write a date such as D#2026-11-21",
        Scalar::Tod => "write a time of day such as TOD#13:45:00",
        Scalar::Dt => "write a date and time such as DT#2026-11-21-13:45:00",
        Scalar::String(_) => "write a text",
        Scalar::Real | Scalar::Lreal => "write a number such as 2.5",
        _ => "write a whole number",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use expect_test::{Expect, expect};

    fn check(entries: &[(&str, Scalar)], expected: Expect) {
        let shown: Vec<String> = entries
            .iter()
            .map(|(text, ty)| match read(text, *ty) {
                Ok(value) => format!("{text}: {value:?}"),
                Err(problem) => format!("{text}: {problem}"),
            })
            .collect();
        expected.assert_eq(&(shown.join("\n") + "\n"));
    }

    #[test]
    fn values() {
        use Scalar::*;
        check(
            &[
                ("1", Bool),
                ("false", Bool),
                ("BOOL#1", Bool),
                (" -7 ", Int),
                ("+7", Int),
                ("16#FF", Byte),
                ("INT#-5", Dint),
                ("2.5", Lreal),
                ("-1", Real),
                ("1e3", Lreal),
                ("5s", Time),
                ("-T#1h30m", Time),
                ("250", Time),
                ("-0.5", Time),
                ("D#2026-11-21", Date),
                ("hello", String(80)),
                ("'a$Nb'", String(80)),
                ("", String(80)),
                ("18446744073709551615", Ulint),
                ("-128", Sint),
            ],
            expect![[r#"
                1: Bool(true)
                false: Bool(false)
                BOOL#1: Bool(true)
                 -7 : Int(-7)
                +7: Int(7)
                16#FF: Int(255)
                INT#-5: Int(-5)
                2.5: Real(2.5)
                -1: Real(-1.0)
                1e3: Real(1000.0)
                5s: Int(5000000000)
                -T#1h30m: Int(-5400000000000)
                250: Int(250000000)
                -0.5: Int(-500000)
                D#2026-11-21: Int(1795219200000000000)
                hello: Text([104, 101, 108, 108, 111])
                'a$Nb': Text([97, 10, 98])
                : Text([])
                18446744073709551615: Int(-1)
                -128: Int(-128)
            "#]],
        );
    }

    #[test]
    fn no_values() {
        use Scalar::*;
        check(
            &[
                ("2", Bool),
                ("high", Bool),
                ("-1", Bool),
                ("5s", Int),
                ("2.5", Int),
                ("70000", Int),
                ("-1", Uint),
                ("abc", Dint),
                ("", Dint),
                ("--5", Dint),
                ("1e400", Lreal),
                ("1e39", Real),
                ("5x", Time),
                ("1e30", Time),
                ("today", Date),
                ("toolong", String(3)),
                ("STRING#1", Int),
                ("LINT#5", Int),
            ],
            expect![[r#"
                2: `2` is no BOOL; write 0, 1, FALSE or TRUE
                high: `high` is no BOOL; write 0, 1, FALSE or TRUE
                -1: `-1` is no BOOL; write 0, 1, FALSE or TRUE
                5s: `5s` is no INT; write a whole number
                2.5: `2.5` is no INT; write a whole number
                70000: 70000 is outside of INT, which holds -32768 to 32767
                -1: -1 is outside of UINT, which holds 0 to 65535
                abc: `abc` is no DINT; write a whole number
                : `` is no DINT; write a whole number
                --5: `--5` is no DINT; write a whole number
                1e400: `1e400`: the number is too large for LREAL
                1e39: the number is too large for REAL
                5x: `5x` is no TIME; write a duration such as 5s or 250ms, or a number of milliseconds
                1e30: `1e30`: TIME holds about 292 years
                today: `today` is no DATE; write a date such as D#2026-11-21
                toolong: the text has 7 characters, STRING[3] holds 3
                STRING#1: `STRING#1` is no INT; write a whole number
                LINT#5: `LINT#5` is no INT; write a whole number
            "#]],
        );
    }
}
