//! Words, literals and signs.

use super::value::{Type, Value};

/// A token.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Token {
    /// A word in capitals.
    Word(String),
    /// A direct address.
    Address,
    /// A literal.
    Literal(Value),
    /// An operator or bracket.
    Sign(&'static str),
}

const SIGNS: [&str; 21] = [
    ":=", "=>", "<>", "<=", ">=", "..", "+", "-", "*", "/", "=", "<", ">", "(", ")", "[", "]", ",", ";", ":",
    ".",
];

/// The tokens of a text.
pub(super) fn tokens(text: &str) -> Result<Vec<Token>, String> {
    let mut all = Vec::new();
    let mut rest = text;
    loop {
        rest = rest.trim_start();
        let Some(c) = rest.chars().next() else {
            return Ok(all);
        };
        if let Some(comment) = rest.strip_prefix("(*") {
            rest = comment.split_once("*)").ok_or("a comment without an end")?.1;
        } else if c.is_ascii_alphabetic() || c == '_' {
            let word = run(rest, |c| c.is_ascii_alphanumeric() || c == '_');
            let upper = word.to_ascii_uppercase();
            if rest[word.len()..].starts_with('#') {
                let literal = run(&rest[word.len() + 1..], |c| {
                    c.is_ascii_alphanumeric() || "_.:#-".contains(c)
                });
                rest = &rest[word.len() + 1 + literal.len()..];
                all.push(Token::Literal(typed(&upper, literal)?));
                continue;
            }
            rest = &rest[word.len()..];
            all.push(match upper.as_str() {
                "TRUE" => Token::Literal(Value::Bool(true)),
                "FALSE" => Token::Literal(Value::Bool(false)),
                _ => Token::Word(upper),
            });
        } else if c.is_ascii_digit() {
            let mut word = run(rest, |c| c.is_ascii_alphanumeric() || c == '_');
            if let Some((base, digits)) = rest[word.len()..].strip_prefix('#').map(|after| (word, after)) {
                let digits = run(digits, |c| c.is_ascii_alphanumeric());
                let number = u64::from_str_radix(digits, base.parse().map_err(|_| "a base")?);
                rest = &rest[base.len() + 1 + digits.len()..];
                all.push(Token::Literal(Value::Int(
                    number.map_err(|_| "digits")? as i64,
                    None,
                )));
                continue;
            }
            let after = &rest[word.len()..];
            if after.starts_with('.') && !after.starts_with("..") {
                word = &rest[..word.len() + 1 + run(&after[1..], |c| c.is_ascii_alphanumeric()).len()];
                if word.ends_with(['E', 'e']) {
                    let exponent = run(&rest[word.len()..], |c| c.is_ascii_digit() || c == '-');
                    word = &rest[..word.len() + exponent.len()];
                }
                all.push(Token::Literal(Value::Real(word.parse().map_err(|_| word)?, None)));
            } else {
                let number: u64 = word.parse().map_err(|_| format!("{word} is no number"))?;
                all.push(Token::Literal(Value::Int(number as i64, None)));
            }
            rest = &rest[word.len()..];
        } else if c == '%' {
            rest = &rest[run(&rest[1..], |c| c.is_ascii_alphanumeric() || c == '.').len() + 1..];
            all.push(Token::Address);
        } else if c == '\'' {
            let (text, length) = string(rest)?;
            rest = &rest[length..];
            all.push(Token::Literal(Value::Text(text)));
        } else {
            let sign = SIGNS.into_iter().find(|sign| rest.starts_with(sign));
            let sign = sign.ok_or_else(|| format!("what is {}", &rest[..rest.len().min(20)]))?;
            rest = &rest[sign.len()..];
            all.push(Token::Sign(sign));
        }
    }
}

fn run(text: &str, holds: impl Fn(char) -> bool) -> &str {
    &text[..text.find(|c| !holds(c)).unwrap_or(text.len())]
}

fn string(text: &str) -> Result<(Vec<u8>, usize), String> {
    let bytes = text.as_bytes();
    let mut out = Vec::new();
    let mut at = 1;
    loop {
        match bytes.get(at) {
            Some(b'\'') => return Ok((out, at + 1)),
            Some(b'$') => match bytes.get(at + 1) {
                Some(c @ (b'\'' | b'$')) => {
                    out.push(*c);
                    at += 2;
                }
                _ => {
                    let hex = text.get(at + 1..at + 3).ok_or("a text")?;
                    out.push(u8::from_str_radix(hex, 16).map_err(|_| "a text")?);
                    at += 3;
                }
            },
            Some(c) => {
                out.push(*c);
                at += 1;
            }
            None => return Err("a text without an end".into()),
        }
    }
}

fn typed(ty: &str, literal: &str) -> Result<Value, String> {
    match ty {
        "T" => duration(literal)
            .ok_or_else(|| format!("T#{literal}"))
            .map(Value::Time),
        "D" => day(literal)
            .ok_or_else(|| format!("D#{literal}"))
            .map(|day| Value::Clock(day, "DATE")),
        "TOD" => time(literal)
            .ok_or_else(|| format!("TOD#{literal}"))
            .map(|time| Value::Clock(time, "TOD")),
        "DT" => {
            let (date, clock) = literal.rsplit_once('-').ok_or("a date")?;
            let both = day(date)
                .zip(time(clock))
                .ok_or_else(|| format!("DT#{literal}"))?;
            Ok(Value::Clock(both.0 + both.1, "DT"))
        }
        _ => {
            let ty = Type::named(ty).ok_or_else(|| format!("{ty}#{literal}"))?;
            let digits = literal.strip_prefix("16#").ok_or("a typed literal")?;
            let number = u64::from_str_radix(digits, 16).map_err(|_| "a typed literal")?;
            Ok(Value::Int(number as i64, Some(ty)))
        }
    }
}

fn duration(text: &str) -> Option<i64> {
    let (sign, mut rest) = text.strip_prefix('-').map_or((1, text), |rest| (-1, rest));
    let mut total = 0i128;
    while !rest.is_empty() {
        let number = run(rest, |c| c.is_ascii_digit() || c == '.');
        rest = &rest[number.len()..];
        let unit = run(rest, |c| c.is_ascii_alphabetic());
        rest = &rest[unit.len()..];
        let unit: i128 = match unit {
            "d" => 86_400_000_000_000,
            "h" => 3_600_000_000_000,
            "m" => 60_000_000_000,
            "s" => 1_000_000_000,
            "ms" => 1_000_000,
            _ => return None,
        };
        let (whole, fraction) = number.split_once('.').unwrap_or((number, ""));
        total += whole.parse::<i128>().ok()? * unit;
        if !fraction.is_empty() {
            total += fraction.parse::<i128>().ok()? * unit / 10i128.pow(fraction.len() as u32);
        }
    }
    i64::try_from(sign * total).ok()
}

fn day(text: &str) -> Option<i64> {
    let mut parts = text.split('-').map(|part| part.parse::<i64>().ok());
    let (mut year, month, day) = (parts.next()??, parts.next()??, parts.next()??);
    if month <= 2 {
        year -= 1;
    }
    let era = year.div_euclid(400);
    let of_era = year - era * 400;
    let of_year = (153 * (month + if month > 2 { -3 } else { 9 }) + 2) / 5 + day - 1;
    Some((era * 146_097 + of_era * 365 + of_era / 4 - of_era / 100 + of_year - 719_468) * 86_400_000_000_000)
}

fn time(text: &str) -> Option<i64> {
    let mut parts = text.split(':');
    let (hour, minute) = (
        parts.next()?.parse::<i64>().ok()?,
        parts.next()?.parse::<i64>().ok()?,
    );
    Some((hour * 60 + minute) * 60_000_000_000 + duration(&format!("{}s", parts.next()?))?)
}
