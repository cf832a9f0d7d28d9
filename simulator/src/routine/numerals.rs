//! Numbers and times as text, and back (`[TYP]`, `[PACK]`, `[UNPACK]`), without allocating.

use super::Operands;
use crate::fault::Trouble;
use crate::memory::{Memory, TextSlot};
use crate::operation::{Width, finite};
use crate::value_text;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;

/// A word's value in its type.
fn value(word: i64, ty: Scalar) -> Value {
    if ty.is_real() {
        Value::Real(f64::from_bits(word as u64))
    } else {
        Value::Int(word)
    }
}

/// A number as a trace writes it, a time as the language does.
pub(super) fn format(memory: &mut Memory, with: &mut Operands) {
    let (to, word, ty) = (with.text(), with.value(memory), with.ty());
    write(memory, to, |text| {
        let value = value(word, ty);
        if ty == Scalar::Time || ty.is_date() {
            value_text::write_display(text, &value, ty)
        } else {
            value_text::write_cell(text, &value, ty)
        }
    });
}

pub(super) fn format_bit(memory: &mut Memory, with: &mut Operands) {
    let (to, value) = (with.text(), memory.bit(with.bit()));
    write(memory, to, |text| {
        text.write_str(if value { "TRUE" } else { "FALSE" })
    });
}

fn write(memory: &mut Memory, to: TextSlot, with: impl FnOnce(&mut dyn std::fmt::Write) -> std::fmt::Result) {
    let text = &mut memory.texts[to.0 as usize];
    text.set(&[]);
    // A text takes what it has room for and never refuses.
    let _ = with(text);
}

pub(super) fn parse(memory: &mut Memory, with: &mut Operands) -> Result<(), Trouble> {
    let (to, ty) = (with.word(), with.ty());
    let text = memory.text(with.text());
    with.count(text.len());
    let text = trimmed(text)?;
    memory.words[to.0 as usize] = match ty {
        Scalar::Time => time(text)?,
        Scalar::Real | Scalar::Lreal => {
            let value = real(text).ok_or(Trouble::Unparsable)?;
            let value = finite(value, ty == Scalar::Real).map_err(|_| Trouble::OutOfRange)?;
            value.to_bits() as i64
        }
        _ if ty.is_date() || ty.is_enumeration() => match value_text::parse(text, ty) {
            Ok(Value::Int(nanoseconds)) => nanoseconds,
            _ => return Err(Trouble::Unparsable),
        },
        _ => Width::of(ty).hold(whole(text)?)?,
    };
    Ok(())
}

/// A number must be that of a value.
pub(super) fn enumerate(memory: &mut Memory, with: &mut Operands) -> Result<(), Trouble> {
    let (to, ty, number) = (with.word(), with.ty(), with.value(memory));
    if let Scalar::Enum(id) = ty
        && id.get().name_of(number).is_none()
    {
        return Err(Trouble::OutOfRange);
    }
    memory.words[to.0 as usize] = number;
    Ok(())
}

pub(super) fn parse_bit(memory: &mut Memory, with: &mut Operands) -> Result<(), Trouble> {
    let to = with.bit();
    let text = memory.text(with.text());
    with.count(text.len());
    let text = trimmed(text)?;
    let value = match text {
        "1" => true,
        "0" => false,
        _ if text.eq_ignore_ascii_case("TRUE") => true,
        _ if text.eq_ignore_ascii_case("FALSE") => false,
        _ => return Err(Trouble::Unparsable),
    };
    memory.set_bit(to, value);
    Ok(())
}

fn trimmed(bytes: &[u8]) -> Result<&str, Trouble> {
    let text = std::str::from_utf8(bytes).map_err(|_| Trouble::Unparsable)?;
    Ok(text.trim_matches([' ', '\t']))
}

/// `42`, `-7`, `16#FF`, `1_000`
fn whole(text: &str) -> Result<i128, Trouble> {
    let (negative, text) = signed(text);
    let (radix, digits) = match text.split_once('#') {
        Some(("2", digits)) => (2, digits),
        Some(("8", digits)) => (8, digits),
        Some(("16", digits)) => (16, digits),
        Some(_) => return Err(Trouble::Unparsable),
        None => (10, text),
    };
    let value = number(digits, radix)?;
    Ok(if negative { -value } else { value })
}

fn signed(text: &str) -> (bool, &str) {
    match text.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    }
}

fn number(digits: &str, radix: u32) -> Result<i128, Trouble> {
    if !digits.starts_with(|c: char| c.is_digit(radix)) {
        return Err(Trouble::Unparsable);
    }
    let mut value: i128 = 0;
    for c in digits.chars().filter(|&c| c != '_') {
        let digit = c.to_digit(radix).ok_or(Trouble::Unparsable)?;
        // Past every type, and far from the end of i128.
        value = (value * i128::from(radix) + i128::from(digit)).min(1 << 100);
    }
    Ok(value)
}

/// Rust reads more than the language writes: `inf`, `nan`.
fn real(text: &str) -> Option<f64> {
    let known = |c: char| c.is_ascii_digit() || matches!(c, '.' | '+' | '-' | 'e' | 'E');
    text.chars().all(known).then(|| text.parse().ok()).flatten()
}

/// `T#1h30m`, `5s`, or a number of milliseconds.
fn time(text: &str) -> Result<i64, Trouble> {
    let after = |prefix: &str| {
        let head = text.get(..prefix.len())?;
        head.eq_ignore_ascii_case(prefix).then(|| &text[prefix.len()..])
    };
    let literal = after("TIME#").or_else(|| after("T#")).unwrap_or(text);
    let (negative, mut rest) = signed(literal);
    if literal.len() == text.len()
        && let Some(milliseconds) = real(rest)
    {
        let nanoseconds = (milliseconds * 1e6).round_ties_even() as i128;
        return Width::I64.hold(if negative { -nanoseconds } else { nanoseconds });
    }
    if rest.is_empty() {
        return Err(Trouble::Unparsable);
    }
    let mut total: i128 = 0;
    let mut last = i128::MAX;
    while !rest.is_empty() {
        let digits = rest
            .find(|c: char| c.is_ascii_alphabetic())
            .ok_or(Trouble::Unparsable)?;
        let (count, after) = rest.split_at(digits);
        let letters = after
            .find(|c: char| !c.is_ascii_alphabetic())
            .unwrap_or(after.len());
        let (unit, after) = after.split_at(letters);
        let unit = unit_of(unit)
            .filter(|&unit| unit < last)
            .ok_or(Trouble::Unparsable)?;
        last = unit;
        let (whole, fraction) = count.split_once('.').unwrap_or((count, ""));
        total += number(whole, 10)?.saturating_mul(unit);
        if !fraction.is_empty() {
            if fraction.len() > 18 || !after.is_empty() {
                return Err(Trouble::Unparsable);
            }
            total += number(fraction, 10)? * unit / 10i128.pow(fraction.len() as u32);
        }
        rest = after.strip_prefix('_').unwrap_or(after);
    }
    Width::I64.hold(if negative { -total } else { total })
}

/// The nanoseconds of a unit.
fn unit_of(unit: &str) -> Option<i128> {
    let units = [
        ("d", 86_400_000_000_000),
        ("h", 3_600_000_000_000),
        ("m", 60_000_000_000),
        ("s", 1_000_000_000),
        ("ms", 1_000_000),
        ("us", 1_000),
        ("ns", 1),
    ];
    units
        .iter()
        .find(|(name, _)| unit.eq_ignore_ascii_case(name))
        .map(|&(_, nanoseconds)| nanoseconds)
}
