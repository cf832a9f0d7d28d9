//! Timers that count time in a unit, and counters whose output compares, as Click controllers have them.

use super::arguments::Arguments;
use super::{Cell, Compiler, Result};
use crate::layout::{counter, timer};
use crate::memory::{Bit, Word};
use crate::routine::{MOST_UNITS, Routine};
use ladder_analysis::program::ExprKind;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_instructions::Op;

/// The unit where none is given: a millisecond.
const UNIT: i64 = 1_000_000;

impl Compiler<'_> {
    /// `[TON]` `[TOF]` `[RTO]` `[RTOF]`
    pub(super) fn unit_timer(&mut self, op: Op, arguments: Arguments, en: Bit) -> Result<Bit> {
        let routine = match op {
            Op::Ton => Routine::UnitTon,
            Op::Tof => Routine::UnitTof,
            Op::Rto => Routine::UnitRto,
            Op::Rtof => Routine::UnitRtof,
            _ => return Err(arguments.not_in_profile()),
        };
        let (bits, words) = self.home_of(arguments)?;
        let (unit, preset) = self.units(arguments)?;
        self.inputs(arguments, &[("R", bits.offset(timer::R))])?;
        let interval = self.constant(self.interval);
        let (out, rest) = (self.layout.bit(), self.layout.word());
        self.remember(Cell::Word(rest));
        self.routine(
            routine,
            &[out.0, en.0, preset.0, bits.0, words.0, unit.0, interval.0, rest.0],
        );
        Ok(out)
    }

    /// The unit, and PT in it: a plain integer counts it, a time is brought to it.
    fn units(&mut self, arguments: Arguments) -> Result<(Word, Word)> {
        let preset = arguments.value(1)?;
        let base = arguments.named_value("B")?;
        let fixed = base.map_or(Some(UNIT), |base| match base.kind {
            ExprKind::Constant(Value::Int(unit)) => Some(unit),
            _ => None,
        });
        if let (Some(unit), ExprKind::Constant(Value::Int(number))) = (fixed, &preset.kind) {
            let units = match preset.ty {
                Scalar::Time => number / unit.max(1),
                _ => *number,
            };
            if units > MOST_UNITS {
                return Err(arguments.refused(format!(
                    "the preset is {units} units of the timer, which counts to {MOST_UNITS}; count in a longer unit, as \
                     in: B := T#1s"
                )));
            }
            return Ok((self.constant(unit), self.constant(units)));
        }
        let unit = match base {
            Some(base) => self.word(base)?,
            None => self.constant(UNIT),
        };
        let preset = self.ticks(preset, unit)?;
        Ok((unit, preset))
    }

    /// `[CTU]` `[CTD]` `[CTUD]`
    pub(super) fn comparing_counter(&mut self, op: Op, arguments: Arguments, en: Bit) -> Result<Bit> {
        let routine = match op {
            Op::Ctu => Routine::ComparingCtu,
            Op::Ctd => Routine::ComparingCtd,
            Op::Ctud => Routine::ComparingCtud,
            _ => return Err(arguments.not_in_profile()),
        };
        let lent = self.lend_state(arguments)?;
        let preset = self.word(arguments.value(1)?)?;
        let inputs = [("CD", counter::CD), ("R", counter::R), ("LD", counter::LD)];
        let inputs = inputs.map(|(name, member)| (name, lent.bits.offset(member)));
        self.inputs(arguments, &inputs)?;
        let out = self.layout.bit();
        self.routine(routine, &[out.0, en.0, preset.0, lent.bits.0, lent.words.0]);
        self.take_back(&lent);
        Ok(out)
    }
}
