//! Arrays of several dimensions, and whole structures and arrays.

use super::arguments::Arguments;
use super::place::{Slot, Spot};
use super::range::Span;
use super::range_blocks::of_bank;
use super::{Compiler, Result};
use crate::code::{ArrayPlace, Instr};
use crate::memory::{Bit, Word};
use crate::operation::IntegerOp;
use crate::routine::Routine;
use ladder_analysis::program::{Argument, ExprKind, Subscript};
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;

/// A part of a whole that is copied, found: where it is read and written.
enum Found {
    Value(Spot, Slot),
    Range(Scalar, Span, Span),
}

impl Compiler<'_> {
    /// Where an element is among all of its array: each index is checked against its own bounds.
    pub(super) fn offset(&mut self, subscripts: &[Subscript]) -> Result<Word> {
        let mut known = 0;
        let mut sum: Option<Word> = None;
        for subscript in subscripts {
            if let ExprKind::Constant(Value::Int(index)) = subscript.index.kind {
                known += (index - subscript.first) * subscript.stride;
                continue;
            }
            let index = self.count(&subscript.index)?;
            let to = self.layout.word();
            let array = self.array(ArrayPlace {
                base: 0,
                first: subscript.first,
                last: subscript.last,
            });
            self.emit(Instr::Index { to, index, array });
            let term = match subscript.stride {
                1 => to,
                stride => {
                    let stride = self.constant(stride);
                    self.integer(IntegerOp::Mul, Scalar::Lint, to, stride)
                }
            };
            sum = Some(match sum {
                Some(sum) => self.integer(IntegerOp::Add, Scalar::Lint, sum, term),
                None => term,
            });
        }
        let known_word = self.constant(known);
        Ok(match sum {
            Some(sum) if known != 0 => self.integer(IntegerOp::Add, Scalar::Lint, sum, known_word),
            Some(sum) => sum,
            None => known_word,
        })
    }

    /// `[MOV]` of a structure or array: all of its parts are found before one is written.
    pub(super) fn move_parts(&mut self, arguments: Arguments, en: Bit) -> Result<Bit> {
        let (Argument::Parts(to), Argument::Parts(from)) = (arguments.get(0)?, arguments.get(1)?) else {
            return Err(arguments.mismatch());
        };
        let (out, start) = self.begin_powered(en);
        let mut found = Vec::with_capacity(to.len());
        for (to, from) in to.iter().zip(from) {
            found.push(match (to, from) {
                (Argument::Place(to, _), Argument::Place(from, _)) => {
                    let (to, from) = (self.spot(to)?, self.spot(from)?);
                    Found::Value(to, self.load(from))
                }
                (Argument::Range(to), Argument::Range(from)) => {
                    Found::Range(to.element, self.range(to)?, self.range(from)?)
                }
                _ => return Err(arguments.mismatch()),
            });
        }
        for part in found {
            match part {
                Found::Value(to, value) => self.store(to, value),
                Found::Range(element, to, from) => {
                    let routine = of_bank(
                        element,
                        [Routine::CopyBits, Routine::CopyWords, Routine::CopyTexts],
                    );
                    self.routine(routine, &[to.operands(), from.operands()].concat());
                }
            }
        }
        self.end_powered(start);
        Ok(out)
    }
}
