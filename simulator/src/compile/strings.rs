//! String functions, and numbers as text (LANGUAGE §5.2).

use super::place::Slot;
use super::{Compiler, Result};
use crate::memory::{Bit, TextSlot, Word};
use crate::routine::{Routine, type_operand};
use ladder_analysis::program::Expr;
use ladder_analysis::values::types::Scalar;
use ladder_instructions::Op;

/// The longest STRING there is.
const LONGEST: usize = u16::MAX as usize;
/// The longest number or time as text.
const NUMERAL: usize = 64;

impl Compiler<'_> {
    /// One of the nine string functions; the result has room for all it can be.
    pub(super) fn string_function(&mut self, op: Op, ty: Scalar, operands: &[&Expr]) -> Result<Option<Slot>> {
        // The texts are first, counts and positions after them.
        let texts: Vec<&&Expr> = operands.iter().filter(|operand| operand.ty.is_string()).collect();
        let texts: Vec<TextSlot> = texts
            .into_iter()
            .map(|text| self.text(text))
            .collect::<Result<_>>()?;
        let numbers: Vec<&&Expr> = operands
            .iter()
            .filter(|operand| !operand.ty.is_string())
            .collect();
        let numbers: Vec<Word> = numbers
            .into_iter()
            .map(|number| self.count(number))
            .collect::<Result<_>>()?;
        let routine = match op {
            Op::Len => Routine::Length,
            Op::Left => Routine::Left,
            Op::Right => Routine::Right,
            Op::Mid => Routine::Middle,
            Op::Concat => Routine::Concat,
            Op::Insert => Routine::Insert,
            Op::Delete => Routine::Delete,
            Op::Replace => Routine::Replace,
            Op::Find => Routine::Find,
            _ => return Ok(None),
        };
        let mut list = vec![0];
        if op == Op::Concat {
            list.push(texts.len() as u32);
        }
        list.extend(texts.iter().map(|text| text.0));
        list.extend(numbers.iter().map(|number| number.0));
        if matches!(op, Op::Len | Op::Find) {
            let to = self.layout.word();
            list[0] = to.0;
            self.routine(routine, &list);
            return Ok(Some(Slot::Word(self.fit_count(to, ty))));
        }
        let room: usize = match op {
            Op::Left | Op::Right | Op::Mid | Op::Delete => self.text_room(texts[0]),
            _ => texts.iter().map(|&text| self.text_room(text)).sum(),
        };
        let to = self.layout.text(room.min(LONGEST));
        list[0] = to.0;
        self.routine(routine, &list);
        Ok(Some(Slot::Text(to)))
    }

    /// A number, time or BOOL as text.
    pub(super) fn as_text(&mut self, value: Slot, ty: Scalar) -> TextSlot {
        let to = match value {
            Slot::Text(text) => return text,
            _ => {
                let longest = match ty {
                    Scalar::Enum(id) => id.get().values.iter().map(|(name, _)| name.len()).max(),
                    _ => None,
                };
                self.layout.text(longest.unwrap_or(0).max(NUMERAL))
            }
        };
        match value {
            Slot::Bit(bit) => self.routine(Routine::FormatBit, &[to.0, bit.0]),
            _ => self.routine(Routine::Format, &[to.0, value.number(), type_operand(ty)]),
        }
        to
    }

    /// A text as a number, time or BOOL.
    pub(super) fn read_text(&mut self, text: TextSlot, ty: Scalar) -> Slot {
        match ty {
            Scalar::String(_) => Slot::Text(text),
            Scalar::Bool => {
                let to: Bit = self.layout.bit();
                self.routine(Routine::ParseBit, &[to.0, text.0]);
                Slot::Bit(to)
            }
            _ => {
                let to = self.layout.word();
                self.routine(Routine::Parse, &[to.0, type_operand(ty), text.0]);
                Slot::Word(to)
            }
        }
    }
}
