//! Values and places as ladder text writes them.

use super::act::Refusal;
use super::bank::Kind;
use super::model::{Constant, Operand, Pointer};
use super::tags::Tags;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::real_text;
use ladder_format::program::{self, Block, Expression, Literal, Path};
use ladder_instructions::Op;

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
///
/// # Errors
///
/// Click has no such value.
pub(super) fn literal(constant: &Constant, kind: Option<Kind>) -> Result<Literal, Refusal> {
    Ok(match (constant, kind) {
        (Constant::Bit(on), _) => Literal::from(*on),
        (Constant::Int(number @ 0..=1), Some(Kind::Bit)) => Literal::from(*number == 1),
        (Constant::Int(number), _) => Literal::from(*number),
        // The same bits, with a sign.
        (Constant::Hex(number @ 0..=0xFFFF), Some(Kind::Int)) => {
            Literal::from(i64::from(*number as u16 as i16))
        }
        (Constant::Hex(number), Some(Kind::Int2)) => Literal::from(i64::from(*number as i32)),
        (Constant::Hex(number), Some(Kind::Float)) => Literal::from(i64::from(*number)),
        (Constant::Hex(number), _) => Literal::read(format!("16#{number:04X}"))?,
        (Constant::Float(number), _) => Literal::read(real(*number))?,
        (Constant::Text(text), _) if text.is_ascii() => Literal::text(text),
        (Constant::Text(_), _) => return Err("Click's texts are ASCII".to_owned()),
    })
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

/// Blocks one after the other, as they come to be: what an instruction needs before it, then itself.
#[derive(Debug, Default)]
pub(super) struct Chain {
    pub(super) blocks: Vec<Block>,
    /// Why it does not say quite the same.
    pub(super) remark: Option<String>,
    /// How many pointers have something added to them.
    pointers: usize,
}

impl Chain {
    /// Adds an instruction.
    pub(super) fn push<O: Into<program::Operand>>(
        &mut self,
        op: Op,
        operands: impl IntoIterator<Item = O>,
    ) -> Result<(), Refusal> {
        self.blocks.push(Block::of(op, operands)?);
        Ok(())
    }

    /// A value where a kind of value is asked for, or none in particular: where it goes, for example.
    pub(super) fn value(
        &mut self,
        tags: &mut Tags<'_>,
        operand: &Operand,
        kind: Option<Kind>,
    ) -> Result<Expression, Refusal> {
        match operand {
            Operand::Constant(constant) => Ok(literal(constant, kind)?.into()),
            Operand::Tag(tag) => Ok(tags.place(tag)),
            Operand::Pointer(pointer) => self.pointed(tags, pointer),
        }
    }

    fn pointed(&mut self, tags: &mut Tags<'_>, pointer: &Pointer) -> Result<Expression, Refusal> {
        let by = tags.place(&pointer.by);
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
                self.push(Op::Add, [index.clone(), by, i64::from(offset).into()])?;
                index
            }
        };
        Ok(Path::tag(pointer.bank.array()).index([index]).into())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn constants_take_the_kind_of_their_place() {
        let check = |constant: Constant, kind, expected: &str| {
            assert_eq!(
                literal(&constant, kind).as_ref().map(Literal::as_str),
                Ok(expected)
            );
        };
        check(Constant::Hex(0xFFFF), Some(Kind::Hex), "16#FFFF");
        check(Constant::Hex(0xFFFF), Some(Kind::Int), "-1");
        check(Constant::Hex(0xFFFF), Some(Kind::Int2), "65535");
        check(Constant::Int(1), Some(Kind::Bit), "TRUE");
        check(Constant::Float(1e30), None, "1.0e30");
        check(Constant::Text("a'$\n".to_owned()), None, "'a$'$$$0A'");
        assert!(literal(&Constant::Text("é".to_owned()), None).is_err());
    }
}
