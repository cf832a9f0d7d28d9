//! The fields of an element's line.

/// What a field of an element is that is an operand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Slot {
    /// A variable that is written.
    Place,
    /// A variable or a literal that is read.
    Value,
    /// A number.
    Number,
}

/// The fields after the word.
pub(super) fn fields(text: &str) -> Vec<&str> {
    text.split(' ').skip(1).collect()
}

/// Whether an operand is a literal.
pub(super) fn is_literal(operand: &str) -> bool {
    operand.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '-' | '+' | '\''))
}

/// The value of a literal: `-5`, `'A'`, `0x1F`.
pub(super) fn literal(text: &str) -> Option<i64> {
    if let Some(inside) = text.strip_prefix('\'') {
        let mut chars = inside.strip_suffix('\'')?.chars();
        let c = match (chars.next()?, chars.next()) {
            ('\\', Some('n')) => '\n',
            ('\\', Some('r')) => '\r',
            ('\\', Some('t')) => '\t',
            (c, None) => c,
            _ => return None,
        };
        return Some(i64::from(u32::from(c)));
    }
    let (sign, digits) = match text.strip_prefix('-') {
        Some(digits) => (-1, digits),
        None => (1, text.strip_prefix('+').unwrap_or(text)),
    };
    let (base, digits) = match digits.get(..2) {
        Some("0x" | "0X") => (16, &digits[2..]),
        Some("0o") => (8, &digits[2..]),
        Some("0b") => (2, &digits[2..]),
        _ => (10, digits),
    };
    let number = u32::from_str_radix(digits, base).ok()?;
    Some(sign * i64::from(number))
}

/// A number as LDmicro's 16 bits hold it.
pub(super) fn wrapped(number: i64) -> i64 {
    i64::from(number as i16)
}

/// What a coil does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Coil {
    Plain,
    Negated,
    Set,
    Reset,
}

impl Coil {
    /// From `name negated set reset`: the first that is on counts.
    pub(super) fn of(fields: &[&str]) -> Coil {
        let on = |index: usize| fields.get(index).is_some_and(|field| *field != "0");
        match () {
            () if on(1) => Coil::Negated,
            () if on(2) => Coil::Set,
            () if on(3) => Coil::Reset,
            () => Coil::Plain,
        }
    }
}
