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
use ladder_instructions::Op;

/// A part of a structure or array, found.
#[derive(Clone, Copy)]
enum Part {
    Value(Spot),
    Range(Scalar, Span),
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

    /// `[MOV]`, `[SEL]` and `[MUX]` of structures and arrays: all parts are found, and chosen, before one is written.
    pub(super) fn select_parts(&mut self, op: Op, arguments: Arguments, en: Bit) -> Result<Bit> {
        let (out, start) = self.begin_powered(en);
        let to = self.whole(arguments, arguments.get(0)?)?;
        let selector = match op {
            Op::Sel => {
                let to = self.layout.word();
                let from = self.bit(arguments.value(1)?)?;
                self.emit(Instr::BitToWord { to, from });
                Some(to)
            }
            Op::Mux => Some(self.count(arguments.value(1)?)?),
            _ => None,
        };
        let given = arguments.by_place().skip(1 + usize::from(selector.is_some()));
        let wholes = given
            .map(|argument| {
                let parts = self.whole(arguments, argument)?;
                Ok(parts.into_iter().map(|part| self.read_part(part)).collect())
            })
            .collect::<Result<Vec<Vec<Slot>>>>()?;
        let mut moves = Vec::with_capacity(to.len());
        for (number, part) in to.into_iter().enumerate() {
            let values: Option<Vec<Slot>> = wholes.iter().map(|whole| whole.get(number).copied()).collect();
            let values = values.ok_or_else(|| arguments.mismatch())?;
            let value = match (selector, values.as_slice()) {
                (Some(selector), values) => self.select_slot(selector, values),
                (None, [value]) => *value,
                _ => return Err(arguments.mismatch()),
            };
            moves.push((part, value));
        }
        for (part, value) in moves {
            match (part, value) {
                (Part::Value(to), value) => self.store(to, value),
                (Part::Range(element, to), Slot::Word(start)) => {
                    self.copy_range(element, to, Span { start, ..to });
                }
                _ => return Err(arguments.mismatch()),
            }
        }
        self.end_powered(start);
        Ok(out)
    }

    /// `[BMOV]` of ranges of structures.
    pub(super) fn move_ranges(&mut self, arguments: Arguments, en: Bit) -> Result<Bit> {
        let (Argument::Parts(to), Argument::Parts(from)) = (arguments.get(0)?, arguments.get(1)?) else {
            return Err(arguments.mismatch());
        };
        let (out, start) = self.begin_powered(en);
        let mut found = Vec::with_capacity(to.len());
        for pair in to.iter().zip(from) {
            let (Argument::Range(to), Argument::Range(from)) = pair else {
                return Err(arguments.mismatch());
            };
            found.push((to.element, self.spans(to, from)?));
        }
        for (element, (to, from)) in found {
            self.copy_range(element, to, from);
        }
        self.end_powered(start);
        Ok(out)
    }

    /// `[FILL]` of ranges of structures.
    pub(super) fn fill_ranges(&mut self, arguments: Arguments, en: Bit) -> Result<Bit> {
        let (out, start) = self.begin_powered(en);
        let to = self.whole(arguments, arguments.get(0)?)?;
        let mut values = Vec::with_capacity(to.len());
        for part in self.whole(arguments, arguments.get(1)?)? {
            let slot = self.read_part(part);
            values.push((part, slot));
        }
        for (to, (from, value)) in to.into_iter().zip(values) {
            let Part::Range(element, to) = to else {
                return Err(arguments.mismatch());
            };
            let [first, count] = to.operands();
            match from {
                Part::Value(_) => {
                    let routine = of_bank(
                        element,
                        [Routine::FillBits, Routine::FillWords, Routine::FillTexts],
                    );
                    self.routine(routine, &[first, count, value.number()]);
                }
                Part::Range(_, from) => {
                    let routine = of_bank(
                        element,
                        [Routine::RepeatBits, Routine::RepeatWords, Routine::RepeatTexts],
                    );
                    self.routine(routine, &[to.operands(), from.operands()].concat());
                }
            }
        }
        self.end_powered(start);
        Ok(out)
    }

    /// Finds the parts of a whole.
    fn whole(&mut self, arguments: Arguments, argument: &Argument) -> Result<Vec<Part>> {
        let Argument::Parts(parts) = argument else {
            return Err(arguments.mismatch());
        };
        parts
            .iter()
            .map(|part| match part {
                Argument::Place(place, _) => self.spot(place).map(Part::Value),
                Argument::Range(range) => Ok(Part::Range(range.element, self.range(range)?)),
                _ => Err(arguments.mismatch()),
            })
            .collect()
    }

    /// The value of a part; of a range where it begins.
    fn read_part(&mut self, part: Part) -> Slot {
        match part {
            Part::Value(spot) => self.load(spot),
            Part::Range(_, span) => Slot::Word(span.start),
        }
    }

    fn copy_range(&mut self, element: Scalar, to: Span, from: Span) {
        let routine = of_bank(
            element,
            [Routine::CopyBits, Routine::CopyWords, Routine::CopyTexts],
        );
        self.routine(routine, &[to.operands(), from.operands()].concat());
    }
}
