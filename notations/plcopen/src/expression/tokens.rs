//! Words, literals and signs of an expression.

use super::Meaning;
use crate::scope::{LONGEST as LONGEST_NAME, is_plain, member};
use crate::standard;
use ladder_format::program::{Literal, Path};

/// A longer expression is not read.
const LONGEST: usize = 2_000;

/// A part of an expression.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Token {
    Word(String),
    /// `Phase.IDLE`
    Enumerator(Path),
    Literal(Literal, Option<&'static str>),
    Sign(&'static str),
}

const SIGNS: [&str; 18] = [
    "<>", "<=", ">=", "**", "(", ")", "[", "]", ",", ".", "+", "-", "*", "/", "=", "<", ">", "&",
];

pub(super) fn tokens(text: &str, meaning: Meaning<'_>) -> Result<Vec<Token>, String> {
    if text.len() > LONGEST {
        return Err(format!("it is longer than {LONGEST} characters"));
    }
    let mut tokens = Vec::new();
    let mut rest = text.trim();
    while let Some(c) = rest.chars().next() {
        let length = if c.is_whitespace() {
            rest = rest.trim_start();
            continue;
        } else if let Some(length) = odd_name(rest, tokens.last(), meaning) {
            tokens.push(Token::Word(rest[..length].to_owned()));
            length
        } else if c.is_alphabetic() || c == '_' || c == '%' {
            let length = word_length(rest);
            let word = &rest[..length];
            if rest[length..].starts_with('#') {
                let (token, length) = prefixed(rest, length)?;
                tokens.push(token);
                length
            } else {
                tokens.push(Token::Word(word.to_owned()));
                length
            }
        } else if c.is_ascii_digit() {
            // After a point it is a bit: nothing more belongs to it.
            let is_bit = tokens.last() == Some(&Token::Sign("."));
            let length = if is_bit { digits(rest) } else { number_length(rest) };
            let ty = rest[..length].contains('.').then_some("LREAL");
            tokens.push(Token::Literal(Literal::read(&rest[..length])?, ty));
            length
        } else if c == '\'' || c == '"' {
            let (string, length) = quoted(rest, c)?;
            tokens.push(Token::Literal(Literal::read(string)?, Some("STRING")));
            length
        } else {
            let sign = SIGNS.iter().find(|sign| rest.starts_with(**sign));
            let sign =
                sign.ok_or_else(|| format!("`{}` has no place in an expression here", c.escape_debug()))?;
            tokens.push(match *sign {
                "&" => Token::Word("AND".to_owned()),
                "**" => Token::Sign("^"),
                sign => Token::Sign(sign),
            });
            sign.len()
        };
        rest = &rest[length..];
    }
    Ok(tokens)
}

/// How long the name at the beginning is, if it is more than a word: some editors take `pump 1` and `valve-2`. Of several
/// it is the longest.
fn odd_name(text: &str, before: Option<&Token>, meaning: Meaning<'_>) -> Option<usize> {
    let Meaning { shared, scope } = meaning;
    let is_member = before == Some(&Token::Sign("."));
    let has_none = if is_member {
        shared.odd_members.is_empty()
    } else {
        !scope.has_odd() && !shared.globals.has_odd()
    };
    if has_none {
        return None;
    }
    let is_name = |name: &str| {
        if is_member {
            shared.odd_members.contains(&name.to_lowercase())
        } else {
            scope.get(name).or_else(|| shared.globals.get(name)).is_some()
        }
    };
    let ends = text.char_indices().take(LONGEST_NAME);
    let ends = ends.map(|(at, c)| at + c.len_utf8()).filter(|end| {
        let next = text[*end..].chars().next();
        !next.is_some_and(|c| c.is_alphanumeric() || c == '_')
    });
    ends.filter(|end| !is_plain(&text[..*end]) && is_name(&text[..*end]))
        .last()
}

fn word_length(text: &str) -> usize {
    // An address has points in it.
    let is_address = text.starts_with('%');
    let goes_on = |c: char| c.is_alphanumeric() || c == '_' || (is_address && matches!(c, '%' | '.' | '*'));
    text.find(|c| !goes_on(c)).unwrap_or(text.len())
}

fn digits(text: &str) -> usize {
    text.find(|c: char| !c.is_ascii_digit()).unwrap_or(text.len())
}

/// `T#5s`, `INT#16#FF`, `Phase#IDLE`: what it is, and how long.
fn prefixed(text: &str, word: usize) -> Result<(Token, usize), String> {
    let prefix = text[..word].to_ascii_uppercase();
    let after = &text[word + 1..];
    let is_part = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '.' | '#' | ':');
    let sign = usize::from(after.starts_with(['-', '+']));
    let mut length = after[sign..]
        .find(|c| !is_part(c))
        .map_or(after.len(), |end| end + sign);
    let ty = match prefix.as_str() {
        "T" | "TIME" | "LT" | "LTIME" => Some("TIME"),
        "D" | "DATE" | "LD" | "LDATE" => Some("DATE"),
        "TOD" | "TIME_OF_DAY" | "LTOD" => Some("TOD"),
        "DT" | "DATE_AND_TIME" | "LDT" => Some("DT"),
        other => standard::elementary(other),
    };
    let Some(ty) = ty else {
        let value = &after[..length];
        let path = Path::tag(member(&text[..word])).member(member(value));
        return Ok((Token::Enumerator(path), word + 1 + length));
    };
    // Dates have signs between their numbers.
    if matches!(ty, "DATE" | "DT") {
        let is_date = |c: char| is_part(c) || c == '-';
        length = after.find(|c| !is_date(c)).unwrap_or(after.len());
    }
    let value = &after[..length];
    if value.is_empty() || value.matches('#').count() > 1 {
        return Err(format!(
            "`{}` is no literal",
            text[..word + 1 + length].escape_debug()
        ));
    }
    let prefix = match prefix.as_str() {
        "LT" | "LTIME" => "T",
        "LD" | "LDATE" => "D",
        "LTOD" => "TOD",
        "LDT" => "DT",
        other => other,
    };
    let value = value.strip_prefix('+').unwrap_or(value);
    // A literal holds one sign of numbers: INT#16#FF is 16#FF.
    let text = if value.contains('#') {
        value.to_owned()
    } else {
        format!("{prefix}#{value}")
    };
    Ok((Token::Literal(Literal::read(text)?, Some(ty)), word + 1 + length))
}

/// `16#FF`, `1_000`, `1.5e-3`.
fn number_length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let run = |from: usize| {
        let rest = &bytes[from..];
        from + rest
            .iter()
            .position(|c| !c.is_ascii_digit() && *c != b'_')
            .unwrap_or(rest.len())
    };
    let mut end = run(0);
    if bytes.get(end) == Some(&b'#') {
        let rest = &bytes[end + 1..];
        return end
            + 1
            + rest
                .iter()
                .position(|c| !c.is_ascii_alphanumeric() && *c != b'_')
                .unwrap_or(rest.len());
    }
    if bytes.get(end) == Some(&b'.') && bytes.get(end + 1).is_some_and(u8::is_ascii_digit) {
        end = run(end + 1);
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        if bytes.get(end + 1 + sign).is_some_and(u8::is_ascii_digit) {
            end = run(end + 1 + sign);
        }
    }
    end
}

/// A string with single quotes, and how long it was.
fn quoted(text: &str, quote: char) -> Result<(String, usize), String> {
    let mut out = String::from("'");
    let mut chars = text.char_indices().skip(1);
    while let Some((at, c)) = chars.next() {
        match c {
            '$' => {
                let (_, next) = chars.next().ok_or("a string does not end")?;
                if next == '"' {
                    out.push('"');
                } else {
                    out.extend(['$', next]);
                }
            }
            c if c == quote => return Ok((out + "'", at + c.len_utf8())),
            '\'' => out.push_str("$'"),
            c if c.is_control() => return Err("a line ends in a string".to_owned()),
            c => out.push(c),
        }
    }
    Err("a string does not end".to_owned())
}
