//! Ranges of arrays, `a[3..9]`, and the contacts and coils that take one.

use super::{Compiler, Result};
use crate::code::Instr;
use crate::layout::{Borrowed, Home};
use crate::memory::{Bit, Word};
use crate::operation::IntegerOp;
use crate::routine::Routine;
use ladder_analysis::program::{Expr, ExprKind, RangeRef};
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;

/// A range: the words that hold the slot of its first element, and how many there are.
#[derive(Debug, Clone, Copy)]
pub(super) struct Span {
    pub(super) start: Word,
    pub(super) count: Word,
}

impl Span {
    pub(super) const fn operands(self) -> [u32; 2] {
        [self.start.0, self.count.0]
    }
}

impl Compiler<'_> {
    /// Finds a range. An end that is left out is the end of the array.
    pub(super) fn range(&mut self, range: &RangeRef) -> Result<Span> {
        let (base, first, last) = self.bounds(range);
        let borrowed = self.borrowed(range);
        let ends = (
            constant(&range.first),
            range.last.as_deref().map_or(Some(last), constant),
        );
        if let (Some(from), Some(to)) = ends
            && first <= from
            && from <= to
            && to <= last
        {
            let start = match borrowed {
                Some(at) => self.slot_offset(at, (from - first) as u32),
                None => self.constant(i64::from(base) + (from - first)),
            };
            let count = self.constant(to - from + 1);
            return Ok(Span { start, count });
        }
        let from = self.count(&range.first)?;
        let to = match &range.last {
            Some(to) => self.count(to)?,
            None => self.constant(last),
        };
        let mut span = Span {
            start: self.layout.word(),
            count: self.layout.word(),
        };
        let (first, last) = (self.constant(first), self.constant(last));
        self.routine(
            Routine::Range,
            &[from.0, to.0, base, first.0, last.0, span.start.0, span.count.0],
        );
        if let Some(at) = borrowed {
            span.start = self.integer(IntegerOp::Add, Scalar::Lint, span.start, at);
        }
        Ok(span)
    }

    /// A range that begins at an index and has this many elements.
    pub(super) fn range_from(&mut self, range: &RangeRef, count: Word) -> Result<Span> {
        let (base, first, last) = self.bounds(range);
        let start = self.found_from(&range.first, count, (base, first, last))?;
        if let Some(row) = &range.row {
            // It ends with its own array.
            self.found_from(&row.index, count, (0, row.bounds.0, row.bounds.1))?;
        }
        let start = match self.borrowed(range) {
            Some(at) => self.integer(IntegerOp::Add, Scalar::Lint, start, at),
            None => start,
        };
        Ok(Span { start, count })
    }

    /// The slot of an element after which there are as many as a range has, of an array with a first slot and bounds.
    fn found_from(&mut self, from: &Expr, count: Word, (base, first, last): (u32, i64, i64)) -> Result<Word> {
        let from = self.count(from)?;
        let start = self.layout.word();
        let (first, last) = (self.constant(first), self.constant(last));
        self.routine(
            Routine::RangeFrom,
            &[from.0, count.0, base, first.0, last.0, start.0],
        );
        Ok(start)
    }

    /// The word that holds the slot of an array's first element, where an in-out stands for the array.
    pub(super) fn borrowed(&self, range: &RangeRef) -> Option<Word> {
        match self.homes[range.tag.0 as usize] {
            Home::Borrowed(Borrowed::Elements { at, .. }) => Some(at),
            _ => None,
        }
    }

    /// The slot of an array's first element, counted from where an in-out begins, and its bounds.
    pub(super) fn bounds(&self, range: &RangeRef) -> (u32, i64, i64) {
        let (base, first, len) = match self.homes[range.tag.0 as usize] {
            Home::Bits { at, first, len } => (at.0, first, len),
            Home::Words { at, first, len, .. } => (at.0, first, len),
            Home::Texts { at, first, len, .. } => (at.0, first, len),
            Home::Borrowed(Borrowed::Elements { first, len, .. }) => (0, first, len),
            _ => (0, 0, 1),
        };
        (base, first, first + i64::from(len) - 1)
    }

    pub(super) fn routine(&mut self, routine: Routine, operands: &[u32]) {
        let at = self.code.operands.len() as u32;
        for &operand in operands {
            // Which of them are bits only the routine knows. To keep one too many costs nothing that counts.
            self.layout.keep(Bit(operand));
        }
        self.code.operands.extend_from_slice(operands);
        self.emit(Instr::Routine {
            routine,
            operands: at,
        });
    }

    /// `[ ]` and `[/]` on a range: all high, or all low.
    pub(super) fn contact_on_range(&mut self, range: &RangeRef, en: Bit, open: bool) -> Result<Bit> {
        let (out, start) = self.begin_powered(en);
        let [first, count] = self.range(range)?.operands();
        let routine = if open { Routine::AllHigh } else { Routine::AllLow };
        self.routine(routine, &[out.0, first, count]);
        self.end_powered(start);
        Ok(out)
    }

    /// `( )` on a range.
    pub(super) fn coil_on_range(&mut self, range: &RangeRef, en: Bit) -> Result<Bit> {
        let (out, [first, count]) = self.coil_range(range, en)?;
        self.routine(Routine::FillBits, &[first, count, en.0]);
        Ok(out)
    }

    /// `(S)` on a range: its power is that of all of it.
    pub(super) fn set_coil_on_range(&mut self, range: &RangeRef, en: Bit) -> Result<Bit> {
        let out = self.layout.bit();
        let [first, count] = self.range(range)?.operands();
        self.routine(Routine::SetBits, &[en.0, first, count]);
        self.routine(Routine::AllHigh, &[out.0, first, count]);
        Ok(out)
    }

    /// `(R)` on a range.
    pub(super) fn reset_coil_on_range(&mut self, range: &RangeRef, en: Bit) -> Result<Bit> {
        let (out, [first, count]) = self.coil_range(range, en)?;
        self.routine(Routine::ResetBits, &[en.0, first, count]);
        Ok(out)
    }

    /// The range that a coil writes and the power after it, see `coil_place`.
    fn coil_range(&mut self, range: &RangeRef, en: Bit) -> Result<(Bit, [u32; 2])> {
        let out = self.layout.bit();
        let start = self.code.instrs.len();
        self.emit(Instr::Follow { out, en });
        let span = self.range(range)?.operands();
        if self.code.instrs.len() > start + 1 {
            return Ok((out, span));
        }
        self.code.instrs.truncate(start);
        Ok((en, span))
    }
}

/// The value of an index that is written as a number.
pub(super) fn constant(index: &Expr) -> Option<i64> {
    match index.kind {
        ExprKind::Constant(Value::Int(number)) => Some(number),
        _ => None,
    }
}
