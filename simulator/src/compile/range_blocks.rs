//! Blocks that work on ranges of arrays (LANGUAGE §5.2).

use super::arguments::Arguments;
use super::place::Slot;
use super::range::{Span, constant};
use super::{Compiler, Result};
use crate::code::Instr;
use crate::memory::{Bit, Word};
use crate::operation::IntegerOp;
use crate::routine::{Routine, type_operand};
use ladder_analysis::program::{Argument, Expr, ExprKind, RangeRef};
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;

/// The routine for a type's bank, of those for bits, words and texts.
pub(super) fn of_bank(ty: Scalar, routines: [Routine; 3]) -> Routine {
    match ty {
        Scalar::Bool => routines[0],
        Scalar::String(_) => routines[2],
        _ => routines[1],
    }
}

impl Compiler<'_> {
    /// `[BMOV]`
    pub(super) fn move_range(&mut self, arguments: Arguments, en: Bit) -> Result<Bit> {
        let (to, from) = (arguments.range(0)?, arguments.range(1)?);
        let (out, start) = self.begin_powered(en);
        let (to_span, from_span) = self.spans(to, from)?;
        let routine = of_bank(
            to.element,
            [Routine::CopyBits, Routine::CopyWords, Routine::CopyTexts],
        );
        self.routine(routine, &[to_span.operands(), from_span.operands()].concat());
        self.end_powered(start);
        Ok(out)
    }

    /// Two ranges, of which one may be an index alone: it is then as long as the other.
    pub(super) fn spans(&mut self, to: &RangeRef, from: &RangeRef) -> Result<(Span, Span)> {
        Ok(match (&to.last, &from.last) {
            (Some(_), Some(_)) => (self.range(to)?, self.range(from)?),
            (Some(_), None) => {
                let span = self.range(to)?;
                (span, self.range_from(from, span.count)?)
            }
            (None, Some(_)) => {
                let span = self.range(from)?;
                (self.range_from(to, span.count)?, span)
            }
            (None, None) => {
                let one = self.constant(to.per_index);
                (self.range_from(to, one)?, self.range_from(from, one)?)
            }
        })
    }

    /// `[FILL]`
    pub(super) fn fill_range(&mut self, arguments: Arguments, en: Bit) -> Result<Bit> {
        let (range, value) = (arguments.range(0)?, arguments.value(1)?);
        let (out, start) = self.begin_powered(en);
        let [first, count] = self.range(range)?.operands();
        let value = self.expression(value)?.number();
        let routine = of_bank(
            range.element,
            [Routine::FillBits, Routine::FillWords, Routine::FillTexts],
        );
        self.routine(routine, &[first, count, value]);
        self.end_powered(start);
        Ok(out)
    }

    /// `[SHIFT]`: once for each rise of EN. The power after it is EN.
    pub(super) fn shift_range(&mut self, arguments: Arguments, en: Bit) -> Result<Bit> {
        let (range, value) = (arguments.range(0)?, arguments.value(1)?);
        let out = self.layout.bit();
        self.emit(Instr::Follow { out, en });
        let rise = self.edge(Bit::HIGH, en, true);
        let (_, start) = self.begin_powered(rise);
        let [first, count] = self.range(range)?.operands();
        let mut value = self.expression(value)?;
        if let Slot::Text(text) = value {
            // It may be an element of the range.
            let to = Slot::Text(self.layout.text(self.text_room(text)));
            self.copy(to, value);
            value = to;
        }
        let routine = of_bank(
            range.element,
            [Routine::ShiftBits, Routine::ShiftWords, Routine::ShiftTexts],
        );
        self.routine(routine, &[first, count, value.number()]);
        self.end_powered(start);
        Ok(out)
    }

    /// `[PACK]`
    pub(super) fn pack(&mut self, arguments: Arguments, en: Bit) -> Result<Bit> {
        let (place, ty) = arguments.place(0)?;
        let (out, start) = self.begin_powered(en);
        let spot = self.spot(place)?;
        let value = match arguments.get(1)? {
            Argument::Range(range) => {
                if ty == Scalar::Bool || ty.is_string() || !packs(range.element) {
                    return Err(arguments.refused(format!("{} cannot be packed into {ty}", range.element)));
                }
                let to = self.layout.word();
                let [first, count] = self.range(range)?.operands();
                match range.element {
                    Scalar::Bool => self.routine(Routine::PackBits, &[to.0, type_operand(ty), first, count]),
                    element => {
                        let operands = [to.0, type_operand(ty), first, count, type_operand(element)];
                        self.routine(Routine::PackWords, &operands);
                    }
                }
                Slot::Word(to)
            }
            argument => {
                let value = arguments.as_value(argument)?;
                match self.expression(value)? {
                    Slot::Text(text) => self.read_text(text, ty),
                    _ => {
                        return Err(
                            arguments.refused("a range or a STRING is packed, no single value".into())
                        );
                    }
                }
            }
        };
        self.write_result(spot, value);
        self.end_powered(start);
        Ok(out)
    }

    /// `[UNPACK]`
    pub(super) fn unpack(&mut self, arguments: Arguments, en: Bit) -> Result<Bit> {
        let value = arguments.value(1)?;
        let (out, start) = self.begin_powered(en);
        match arguments.get(0)? {
            Argument::Range(range) => {
                if value.ty == Scalar::Bool || value.ty.is_string() || !packs(range.element) {
                    return Err(
                        arguments.refused(format!("{} cannot be unpacked into {}", value.ty, range.element))
                    );
                }
                let [first, count] = self.range(range)?.operands();
                let (from, ty) = (self.word(value)?, type_operand(value.ty));
                match range.element {
                    Scalar::Bool => self.routine(Routine::UnpackBits, &[first, count, from.0, ty]),
                    element => {
                        let operands = [first, count, type_operand(element), from.0, ty];
                        self.routine(Routine::UnpackWords, &operands);
                    }
                }
            }
            argument => {
                let (place, ty) = arguments.as_place(argument)?;
                if !ty.is_string() {
                    return Err(arguments.refused("a value is unpacked into a range or a STRING".into()));
                }
                let spot = self.spot(place)?;
                let from = self.expression(value)?;
                let text = self.as_text(from, value.ty);
                self.store(spot, Slot::Text(text));
            }
        }
        self.end_powered(start);
        Ok(out)
    }

    /// `[SEARCH]`
    pub(super) fn search(&mut self, arguments: Arguments, en: Bit) -> Result<Bit> {
        let (place, ty) = arguments.place(0)?;
        let Argument::Operator(op) = *arguments.get(1)? else {
            return Err(arguments.mismatch());
        };
        let (wanted, range) = (arguments.value(2)?, arguments.range(3)?);
        let (out, start) = self.begin_powered(en);
        let spot = self.spot(place)?;
        let Slot::Word(before) = self.load(spot) else {
            return Err(arguments.mismatch());
        };
        // The index is found in a word of its own, so that a forced y keeps its value.
        let y = self.layout.word();
        self.emit(Instr::Move { to: y, from: before });
        let found_spot = match arguments.named("FOUND") {
            Some(argument) => Some(self.spot(arguments.as_place(argument)?.0)?),
            None => None,
        };
        let next = match arguments.named_value("NEXT")? {
            Some(next) => self.bit(next)?,
            None => Bit::LOW,
        };
        let wanted_type = type_operand(wanted.ty);
        let wanted = self.wanted(wanted, range.element)?.number();
        let span = self.range(range)?;
        let (first_index, base) = self.index_at_slot(range, span)?;
        let [first, count] = span.operands();
        let found = self.layout.bit();
        self.routine(
            Routine::Search,
            &[
                y.0,
                type_operand(ty),
                first_index.0,
                super::conditions::test_of(op).operand(),
                wanted,
                wanted_type,
                first,
                count,
                type_operand(range.element),
                base,
                next.0,
                found.0,
            ],
        );
        self.store(spot, Slot::Word(y));
        if let Some(spot) = found_spot {
            self.store(spot, Slot::Bit(found));
        }
        self.end_powered(start);
        Ok(out)
    }

    /// What an array calls the element that is, or would be, in a slot: its index, and the slot.
    fn index_at_slot(&mut self, range: &RangeRef, span: Span) -> Result<(Word, u32)> {
        let (base, first_index, _) = self.bounds(range);
        let borrowed = self.borrowed(range);
        if let Some(row) = &range.row {
            if let (None, Some(own), Some(first)) = (borrowed, constant(&row.index), constant(&range.first)) {
                return Ok((self.constant(own - (first - first_index)), base));
            }
            let own = self.count(&row.index)?;
            return Ok((self.integer(IntegerOp::Sub, Scalar::Lint, own, span.start), 0));
        }
        let first_index = self.constant(first_index);
        Ok(match borrowed {
            Some(at) => (self.integer(IntegerOp::Sub, Scalar::Lint, first_index, at), 0),
            None => (first_index, base),
        })
    }

    /// What is searched for. A literal takes the elements' precision: 0.1 is found among REALs.
    fn wanted(&mut self, wanted: &Expr, element: Scalar) -> Result<Slot> {
        if let (ExprKind::Constant(Value::Real(real)), Scalar::Real) = (&wanted.kind, element) {
            return Ok(self.literal(&Value::Real(f64::from(*real as f32))));
        }
        self.expression(wanted)
    }

    /// `SUM(a[1..9])`
    pub(super) fn sum(&mut self, ty: Scalar, range: &RangeRef) -> Result<Word> {
        let to = self.layout.word();
        let [first, count] = self.range(range)?.operands();
        self.routine(
            Routine::Sum,
            &[to.0, type_operand(ty), first, count, type_operand(range.element)],
        );
        Ok(to)
    }
}

/// Elements that are parts of a value: BOOL, bit strings, integers.
fn packs(element: Scalar) -> bool {
    element == Scalar::Bool || element.is_bits() || element.is_integer()
}
