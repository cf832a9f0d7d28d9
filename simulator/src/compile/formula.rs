//! Arithmetic that notes what goes wrong and goes on ([`Division::Zero`](ladder_instructions::Division) and
//! [`Division::Dividend`](ladder_instructions::Division)).

use super::Compiler;
use super::place::Slot;
use crate::code::Instr;
use crate::memory::{Bit, Word};
use crate::routine::{Operation, Routine, type_operand};
use ladder_analysis::values::types::Scalar;
use ladder_instructions::{Conversion, Division, Op, Remainder};

/// The bits that note what went wrong in a block.
#[derive(Debug, Clone, Copy)]
pub(super) struct Slips {
    zero: Bit,
    range: Bit,
}

impl Compiler<'_> {
    /// Begins a block that computes, where its profile notes what goes wrong.
    pub(super) fn begin_slips(&mut self, op: Op) {
        let computes = matches!(
            op,
            Op::Calc | Op::Typ | Op::Add | Op::Sub | Op::Mul | Op::Div | Op::Mod | Op::Exp
        );
        if !matches!(self.semantics.division, Division::Zero | Division::Dividend) || !computes {
            return;
        }
        let (zero, range) = (self.layout.bit(), self.layout.bit());
        for to in [zero, range] {
            self.emit(Instr::MoveBit { to, from: Bit::LOW });
        }
        self.slips = Some(Slips { zero, range });
    }

    /// The value of such a block in the type of its result.
    pub(super) fn without_slips(&mut self, value: Slot, from: Scalar, to: Scalar) -> Slot {
        match (self.slips, value) {
            (Some(slips), Slot::Word(word)) if is_number(from) && is_number(to) => {
                let routine = match self.semantics.conversion {
                    Conversion::Wrapped => Routine::Round,
                    Conversion::Fault | Conversion::Clamped => Routine::Cut,
                };
                Slot::Word(self.brought(routine, to, from, word, slips))
            }
            _ => value,
        }
    }

    /// Ends it: what was noted goes to the controller's relays.
    pub(super) fn end_slips(&mut self) {
        let Some(slips) = self.slips.take() else { return };
        let relays = self.code.relays;
        for (en, tag) in [(slips.zero, relays.zero), (slips.range, relays.range)] {
            if let Some(tag) = tag {
                self.emit(Instr::Set { en, tag });
            }
        }
    }

    /// One step of arithmetic, where what goes wrong is noted.
    pub(super) fn step_noted(&mut self, op: Op, ty: Scalar, a: Word, b: Word) -> Option<Word> {
        let slips = self.slips?;
        let step = match op {
            Op::Add => Operation::Add,
            Op::Sub => Operation::Subtract,
            Op::Mul => Operation::Multiply,
            Op::Div | Op::Mod if self.semantics.division == Division::Dividend && ty.is_real() => {
                return None;
            }
            Op::Div if self.semantics.division == Division::Dividend => Operation::DivideUnlessZero,
            Op::Mod if self.semantics.division == Division::Dividend => Operation::RemainderUnlessZero,
            Op::Div => Operation::Divide,
            Op::Mod if self.semantics.remainder == Remainder::OfDivisor => Operation::Modulo,
            Op::Mod => Operation::Remainder,
            Op::Exp => Operation::Power,
            Op::Min => Operation::Least,
            _ => Operation::Greatest,
        };
        let to = self.layout.word();
        let operands = [
            to.0,
            step.operand(),
            type_operand(ty),
            a.0,
            b.0,
            slips.zero.0,
            slips.range.0,
        ];
        self.routine(Routine::Step, &operands);
        Some(to)
    }

    /// A number that `[TYP]` brings to another type, where what does not fit is not a fault.
    pub(super) fn clamped(&mut self, to: Scalar, from: Scalar, word: Word) -> Option<Word> {
        let slips = self.slips?;
        if !is_number(from) || !is_number(to) {
            return None;
        }
        let routine = match self.semantics.conversion {
            Conversion::Fault => return None,
            Conversion::Clamped => Routine::Clamp,
            Conversion::Wrapped => Routine::Round,
        };
        Some(self.brought(routine, to, from, word, slips))
    }

    /// The sum of a range, which is added up as a whole.
    pub(super) fn sum_noted(&mut self, ty: Scalar, word: Word) -> Word {
        match self.slips {
            Some(slips) => self.brought(Routine::Cut, ty, Scalar::Lint, word, slips),
            None => word,
        }
    }

    /// Whether what goes wrong is noted in the block that is being compiled.
    pub(super) const fn notes_slips(&self) -> bool {
        self.slips.is_some()
    }

    fn brought(&mut self, routine: Routine, to: Scalar, from: Scalar, word: Word, slips: Slips) -> Word {
        let place = self.layout.word();
        let operands = [
            place.0,
            type_operand(to),
            word.0,
            type_operand(from),
            slips.zero.0,
            slips.range.0,
        ];
        self.routine(routine, &operands);
        place
    }
}

fn is_number(ty: Scalar) -> bool {
    ty.is_number() || ty.is_bits()
}
