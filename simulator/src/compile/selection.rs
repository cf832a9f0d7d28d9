//! One of several values, and curves (LANGUAGE §5.2): `[SEL]` `[MUX]` `[LUT]` `[PWL]`.

use super::place::Slot;
use super::{Compiler, Result};
use crate::code::Instr;
use crate::memory::{TextSlot, Word};
use crate::operation::Width;
use crate::routine::{Routine, type_operand};
use ladder_analysis::program::Expr;
use ladder_analysis::values::types::Scalar;

impl Compiler<'_> {
    /// `[SEL]`: both values are read, one is taken.
    pub(super) fn select(&mut self, operands: &[&Expr]) -> Result<Option<Slot>> {
        let [g, a, b] = operands else { return Ok(None) };
        let g = self.bit(g)?;
        let values = [self.expression(a)?, self.expression(b)?];
        let to = self.slot_like(&values);
        self.copy(to, values[0]);
        // Over `a` goes `b`, unless g is low. The power of the skip is not used.
        let out = self.layout.bit();
        let skip = self.code.instrs.len();
        self.emit(Instr::Powered { out, en: g, end: 0 });
        self.copy(to, values[1]);
        let end = self.here();
        self.code.instrs[skip] = Instr::Powered { out, en: g, end };
        Ok(Some(to))
    }

    /// `[MUX]` and `[LUT]`: all values are read, the k-th is taken.
    pub(super) fn choose(&mut self, operands: &[&Expr]) -> Result<Option<Slot>> {
        let [selector, values @ ..] = operands else {
            return Ok(None);
        };
        let selector = self.count(selector)?;
        let values: Vec<Slot> = values
            .iter()
            .map(|value| self.expression(value))
            .collect::<Result<_>>()?;
        Ok(Some(self.select_slot(selector, &values)))
    }

    /// The value that a selector names, in a slot of its own.
    pub(super) fn select_slot(&mut self, selector: Word, values: &[Slot]) -> Slot {
        let to = self.slot_like(values);
        let (routine, to_slot) = match to {
            Slot::Bit(to) => (Routine::SelectBit, to.0),
            Slot::Word(to) => (Routine::SelectWord, to.0),
            Slot::Text(to) => (Routine::SelectText, to.0),
        };
        let mut list = vec![to_slot, selector.0, values.len() as u32];
        list.extend(values.iter().map(|value| value.number()));
        self.routine(routine, &list);
        to
    }

    /// `[PWL]`
    pub(super) fn curve(&mut self, ty: Scalar, operands: &[&Expr]) -> Result<Option<Slot>> {
        let [x, points @ ..] = operands else {
            return Ok(None);
        };
        let x = self.word(x)?;
        let to = self.layout.word();
        let mut list = vec![to.0, type_operand(ty), x.0, points.len() as u32];
        for point in points {
            list.push(self.word(point)?.0);
        }
        self.routine(Routine::Curve, &list);
        Ok(Some(Slot::Word(to)))
    }

    /// A slot that has room for any of these values.
    fn slot_like(&mut self, values: &[Slot]) -> Slot {
        match values.first() {
            Some(Slot::Bit(_)) => Slot::Bit(self.layout.bit()),
            Some(Slot::Text(_)) => {
                let room = values.iter().map(|value| match value {
                    Slot::Text(text) => self.text_room(*text),
                    _ => 0,
                });
                let room = room.max().unwrap_or(0);
                Slot::Text(self.layout.text(room))
            }
            _ => Slot::Word(self.layout.word()),
        }
    }

    /// Copies a value to a slot of its own.
    pub(super) fn copy(&mut self, to: Slot, from: Slot) {
        match (to, from) {
            (Slot::Bit(to), Slot::Bit(from)) => self.emit(Instr::MoveBit { to, from }),
            (Slot::Word(to), Slot::Word(from)) => self.emit(Instr::Move { to, from }),
            (Slot::Text(to), Slot::Text(from)) => self.emit(Instr::MoveText { to, from }),
            _ => debug_assert!(false, "{from:?} does not fit {to:?}"),
        }
    }

    /// How many bytes a text slot has room for.
    pub(super) fn text_room(&self, slot: TextSlot) -> usize {
        self.layout.memory.texts[slot.0 as usize].room()
    }

    /// Brings a small count into a type that may be too narrow for it.
    pub(super) fn fit_count(&mut self, count: crate::memory::Word, ty: Scalar) -> crate::memory::Word {
        if Width::of(ty).bits() >= 32 {
            return count;
        }
        let conversion = crate::operation::Conversion::Fit {
            from: Width::I64,
            to: Width::of(ty),
        };
        self.convert(conversion, count)
    }
}
