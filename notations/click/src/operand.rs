//! Values and places as ladder text writes them.

use super::bank::Kind;
use super::model::{Constant, Operand};
use super::tags::Tags;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::real_text;

/// What a value is, if it is not a constant.
pub(super) fn kind(operand: &Operand) -> Option<Kind> {
    match operand {
        Operand::Constant(_) => None,
        Operand::Tag(tag) => Some(tag.bank.kind()),
        Operand::Pointer(pointer) => Some(pointer.bank.kind()),
    }
}

/// Whether a value of one kind can be where another is asked for, without `[TYP]`.
pub(super) const fn passes(from: Kind, to: Kind) -> bool {
    matches!(
        (from, to),
        (Kind::Int, Kind::Int | Kind::Int2 | Kind::Hex | Kind::Float)
            | (Kind::Hex, Kind::Hex | Kind::Int)
            | (Kind::Int2, Kind::Int2)
            | (Kind::Float, Kind::Float)
            | (Kind::Bit, Kind::Bit)
            | (Kind::Text, Kind::Text)
    )
}

/// Whether a constant can be where a kind is asked for.
pub(super) fn fits(constant: &Constant, kind: Kind) -> bool {
    match (constant, kind) {
        (Constant::Int(number), Kind::Int) => i16::try_from(*number).is_ok(),
        (Constant::Int(number), Kind::Int2) => i32::try_from(*number).is_ok(),
        (Constant::Int(number), Kind::Hex) => u16::try_from(*number).is_ok(),
        (Constant::Int(number), Kind::Bit) => matches!(number, 0 | 1),
        (Constant::Hex(number), Kind::Int | Kind::Hex) => u16::try_from(*number).is_ok(),
        (Constant::Hex(_), Kind::Int2) => true,
        (Constant::Int(_) | Constant::Hex(_) | Constant::Float(_), Kind::Float) => true,
        (Constant::Bit(_), Kind::Bit) => true,
        (Constant::Text(text), Kind::Text) => text.chars().count() == 1,
        _ => false,
    }
}

/// A constant where a kind of value is asked for. What does not fit is written as it is: the place then says so.
pub(super) fn literal(constant: &Constant, kind: Option<Kind>) -> String {
    match (constant, kind) {
        (Constant::Bit(true), _) | (Constant::Int(1), Some(Kind::Bit)) => "TRUE".to_owned(),
        (Constant::Bit(false), _) | (Constant::Int(0), Some(Kind::Bit)) => "FALSE".to_owned(),
        (Constant::Int(number), _) => number.to_string(),
        // The same bits, with a sign.
        (Constant::Hex(number @ 0..=0xFFFF), Some(Kind::Int)) => (*number as u16 as i16).to_string(),
        (Constant::Hex(number), Some(Kind::Int2)) => (*number as i32).to_string(),
        (Constant::Hex(number), Some(Kind::Float)) => number.to_string(),
        (Constant::Hex(number), _) => format!("16#{number:04X}"),
        (Constant::Float(number), _) => real(*number),
        (Constant::Text(text), _) => string(text),
    }
}

/// A real, with a point.
fn real(number: f64) -> String {
    let text = format!("{number:?}");
    match text.find('e') {
        Some(at) if !text.contains('.') => format!("{}.0{}", &text[..at], &text[at..]),
        _ => text,
    }
}

/// A REAL of a program as a number whose decimals are the fewest that read back the same.
pub(super) fn shortest(number: f64) -> f64 {
    if f64::from(number as f32).to_bits() == number.to_bits() {
        return real_text(number, Scalar::Real).parse().unwrap_or(number);
    }
    number
}

/// A string of ladder text. What is not a printable ASCII is given by its code.
pub(super) fn string(text: &str) -> String {
    let mut out = String::from("'");
    for c in text.chars() {
        match c {
            '\'' | '$' => out.extend(['$', c]),
            // A comment begins nowhere inside a string, but people read it more easily so.
            ' '..='~' => out.push(c),
            c => out.push_str(&format!("${:02X}", u32::from(c).min(0xFF))),
        }
    }
    out.push('\'');
    out
}

/// Blocks one after the other, as they come to be: what an instruction needs before it, then itself.
#[derive(Debug, Default)]
pub(super) struct Chain {
    pub(super) blocks: Vec<String>,
    /// Why it does not say quite the same.
    pub(super) remark: Option<String>,
    /// How many pointers have something added to them.
    pointers: usize,
}

impl Chain {
    pub(super) fn push(&mut self, block: String) {
        self.blocks.push(block);
    }

    /// A value where a kind of value is asked for, or none in particular.
    pub(super) fn value(&mut self, tags: &mut Tags<'_>, operand: &Operand, kind: Option<Kind>) -> String {
        match operand {
            Operand::Constant(constant) => literal(constant, kind),
            other => self.place(tags, other),
        }
    }

    /// A place where a value goes. A constant, which is none, is written as it is.
    pub(super) fn place(&mut self, tags: &mut Tags<'_>, operand: &Operand) -> String {
        match operand {
            Operand::Constant(constant) => literal(constant, None),
            Operand::Tag(tag) => tags.text(tag),
            Operand::Pointer(pointer) => {
                let by = tags.text(&pointer.by);
                let index = match pointer.offset {
                    0 => by,
                    offset => {
                        // An instruction may have two of them, and both are ready before it reads.
                        let what = match self.pointers {
                            0 => "a pointer and what is added to it",
                            _ => "another pointer and what is added to it",
                        };
                        self.pointers += 1;
                        let index = tags.helper("pointer", "DINT", what);
                        self.push(format!("[ADD]( {index}, {by}, {offset} )"));
                        index
                    }
                };
                format!("{}[{index}]", pointer.bank.array())
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn constants_take_the_kind_of_their_place() {
        let hex = Constant::Hex(0xFFFF);
        assert_eq!(literal(&hex, Some(Kind::Hex)), "16#FFFF");
        assert_eq!(literal(&hex, Some(Kind::Int)), "-1");
        assert_eq!(literal(&hex, Some(Kind::Int2)), "65535");
        assert_eq!(literal(&Constant::Int(1), Some(Kind::Bit)), "TRUE");
        assert_eq!(literal(&Constant::Float(1e30), None), "1.0e30");
        assert_eq!(literal(&Constant::Text("a'$\n".to_owned()), None), "'a$'$$$0A'");
    }
}
