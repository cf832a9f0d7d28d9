//! The texts of `FORMATTED_STRING`: characters by their codes, with LDmicro's escapes. In the profile `ldmicro` `[FMT]`
//! reads numbers and backslashes as LDmicro does; other escapes are characters of the text.

/// A part of a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Piece {
    /// A character below 256.
    Char(char),
    /// The variable, with this many digits; with its sign.
    Number { digits: char, signed: bool },
}

/// The text of `var length c0 c1 ..`, of which the escapes stay as they are; the fork also reads it as it is.
pub(super) fn spelled_out(fields: &[&str]) -> Option<String> {
    by_codes(fields).or_else(|| Some(fields.get(1..)?.join(" ")))
}

/// The same in pieces. None if LDmicro has no such text.
pub(super) fn read(fields: &[&str]) -> Option<Vec<Piece>> {
    let text = spelled_out(fields)?;
    let mut out = Vec::new();
    let mut rest = text.as_str();
    while let Some(c) = rest.chars().next() {
        let (piece, length) = match c {
            '\\' => escape(&rest[1..])?,
            c => (Piece::Char(c), 0),
        };
        out.push(piece);
        rest = &rest[c.len_utf8() + length..];
    }
    Some(out)
}

/// A text whose characters are given by their codes, after their number.
fn by_codes(fields: &[&str]) -> Option<String> {
    let length: usize = fields.get(1)?.parse().ok()?;
    let codes = fields.get(2..)?;
    let code = |code: &&str| code.parse::<u8>().ok().map(char::from);
    codes
        .iter()
        .map(code)
        .collect::<Option<String>>()
        .filter(|_| codes.len() == length)
}

/// What is after a backslash, and how long it is.
pub(super) fn escape(text: &str) -> Option<(Piece, usize)> {
    if let Some(number) = number(text) {
        return Some(number);
    }
    Some(match text.chars().next()? {
        'r' => (Piece::Char('\r'), 1),
        'n' => (Piece::Char('\n'), 1),
        'b' => (Piece::Char('\u{8}'), 1),
        'f' => (Piece::Char('\u{c}'), 1),
        '\\' => (Piece::Char('\\'), 1),
        'x' | 'X' => {
            let code = u8::from_str_radix(text.get(1..3)?, 16).ok()?;
            (Piece::Char(char::from(code)), 3)
        }
        // The others are the fork's, in files of both versions.
        'a' => (Piece::Char('\u{7}'), 1),
        'e' => (Piece::Char('\u{1b}'), 1),
        't' => (Piece::Char('\t'), 1),
        'v' => (Piece::Char('\u{b}'), 1),
        c @ ('\'' | '"' | '?') => (Piece::Char(c), 1),
        _ => return None,
    })
}

/// `3` or `-3`, after a backslash.
fn number(text: &str) -> Option<(Piece, usize)> {
    let signed = text.starts_with('-');
    let digits = text[usize::from(signed)..].chars().next()?;
    let number = Piece::Number { digits, signed };
    ('1'..='5')
        .contains(&digits)
        .then_some((number, 1 + usize::from(signed)))
}

/// How many numbers a text has.
pub(super) fn numbers(text: &[Piece]) -> usize {
    let is_number = |piece: &&Piece| matches!(piece, Piece::Number { .. });
    text.iter().filter(is_number).count()
}

/// The line for a text, as export spells it.
pub(super) fn line(variable: &str, text: &[Piece]) -> String {
    let spelled: String = text.iter().map(|piece| spelled(*piece)).collect();
    let mut line = format!("FORMATTED_STRING {variable} {}", spelled.chars().count());
    spelled
        .chars()
        .for_each(|c| line.push_str(&format!(" {}", u32::from(c))));
    line
}

fn spelled(piece: Piece) -> String {
    match piece {
        Piece::Number { digits, signed } => format!("\\{}{digits}", if signed { "-" } else { "" }),
        Piece::Char('\r') => "\\r".to_owned(),
        Piece::Char('\n') => "\\n".to_owned(),
        Piece::Char('\u{8}') => "\\b".to_owned(),
        Piece::Char('\u{c}') => "\\f".to_owned(),
        Piece::Char('\\') => "\\\\".to_owned(),
        Piece::Char(c) if u32::from(c) < 32 => format!("\\x{:02X}", u32::from(c)),
        Piece::Char(c) => c.to_string(),
    }
}

/// A text as a literal of ladder text, in the profile `ldmicro`.
pub(super) fn literal(text: &[Piece]) -> String {
    let mut out = String::from("'");
    for piece in text {
        match *piece {
            Piece::Number { .. } | Piece::Char('\\') => out.push_str(&spelled(*piece)),
            Piece::Char('\r') => out.push_str("$R"),
            Piece::Char('\n') => out.push_str("$N"),
            Piece::Char('\'') => out.push_str("$'"),
            Piece::Char('$') => out.push_str("$$"),
            Piece::Char(c) if c.is_control() || !c.is_ascii() => {
                out.push_str(&format!("${:02X}", u32::from(c)));
            }
            Piece::Char(c) => out.push(c),
        }
    }
    out.push('\'');
    out
}

/// The other way: from the text that `[FMT]` has, in the profile `ldmicro` or, with `%d` for a number, in another.
/// None if LDmicro cannot send it.
pub(super) fn from_value(text: &str, in_profile: bool) -> Option<Vec<Piece>> {
    let mut out = Vec::new();
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let after = &rest[c.len_utf8()..];
        let (piece, length) = match c {
            '\\' if in_profile => match number(after) {
                Some(number) => number,
                None => (Piece::Char('\\'), usize::from(after.starts_with('\\'))),
            },
            '%' if !in_profile => {
                let signed = Piece::Number {
                    digits: '5',
                    signed: true,
                };
                (signed, after.strip_prefix('d').map(|_| 1)?)
            }
            c if u32::from(c) > 255 => return None,
            c => (Piece::Char(c), 0),
        };
        out.push(piece);
        rest = &after[length..];
    }
    Some(out)
}
