//! `[LUT]` and `[PWL]` that write nothing outside their table ([`Tables::Open`](ladder_instructions::Tables)).

use super::arguments::Arguments;
use super::place::Slot;
use super::{Compiler, Result};
use crate::code::Instr;
use crate::memory::Bit;
use crate::routine::{Routine, type_operand};
use ladder_instructions::Op;

impl Compiler<'_> {
    pub(super) fn open_table(&mut self, op: Op, arguments: Arguments, en: Bit) -> Result<Bit> {
        let (place, ty) = arguments.place(0)?;
        if !ty.is_integer() {
            return self.data(op, arguments, en);
        }
        let (out, start) = self.begin_powered(en);
        let spot = self.spot(place)?;
        let values = arguments.values_from(1)?;
        let Some((index, entries)) = values.split_first() else {
            return Err(arguments.mismatch());
        };
        let index = self.word(index)?;
        let (to, hit) = (self.layout.word(), self.layout.bit());
        let mut list = vec![to.0, hit.0, type_operand(ty), index.0, entries.len() as u32];
        for entry in entries {
            list.push(self.word(entry)?.0);
        }
        let routine = match op {
            Op::Lut => Routine::OpenTable,
            _ => Routine::OpenCurve,
        };
        self.routine(routine, &list);
        let skip = self.code.instrs.len();
        let unused = self.layout.bit();
        let only_inside = |end| Instr::Powered {
            out: unused,
            en: hit,
            end,
        };
        self.emit(only_inside(0));
        self.store(spot, Slot::Word(to));
        self.code.instrs[skip] = only_inside(self.here());
        self.end_powered(start);
        Ok(out)
    }
}
