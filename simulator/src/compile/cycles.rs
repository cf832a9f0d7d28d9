//! Timers that count scans and counters of 16 bits, as LDmicro has them. What they count is a variable like any other;
//! what else they remember belongs to the place of the block.

use super::arguments::Arguments;
use super::{Cell, Compiler, Result};
use crate::code::Instr;
use crate::memory::{Bit, Word};
use crate::operation::IntegerOp;
use crate::routine::Routine;
use ladder_analysis::program::ExprKind;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_instructions::Op;

impl Compiler<'_> {
    /// `[TON]` `[TOF]` `[RTO]`
    pub(super) fn scan_timer(&mut self, op: Op, arguments: Arguments, en: Bit) -> Result<Bit> {
        let routine = match op {
            Op::Ton => Routine::ScanTon,
            Op::Tof => Routine::ScanTof,
            Op::Rto => Routine::ScanRto,
            _ => return Err(arguments.not_in_profile()),
        };
        let (bits, words) = self.home_of(arguments)?;
        let preset = self.scans(arguments)?;
        let (out, started) = (self.layout.bit(), self.layout.bit());
        self.remember(Cell::Bit(started));
        self.routine(routine, &[out.0, en.0, preset.0, bits.0, words.0, started.0]);
        Ok(out)
    }

    /// As many scans as go into a delay, less the one in which it ends.
    fn scans(&mut self, arguments: Arguments) -> Result<Word> {
        let delay = arguments.value(1)?;
        if let ExprKind::Constant(Value::Int(nanoseconds)) = delay.kind {
            let scans = nanoseconds / self.interval - 1;
            return match scans {
                ..1 => Err(arguments.refused(
                    "Timer period too short (needs faster cycle time): a timer of this profile takes two scans or more"
                        .into(),
                )),
                1..=MOST_SCANS => Ok(self.constant(scans)),
                _ => Err(arguments.refused(format!(
                    "Timer period too long (max {MOST_SCANS} times cycle time); use a slower cycle time"
                ))),
            };
        }
        let (delay, interval, one) = (self.word(delay)?, self.constant(self.interval), self.constant(1));
        let scans = self.integer(IntegerOp::Div, Scalar::Lint, delay, interval);
        Ok(self.integer(IntegerOp::Sub, Scalar::Lint, scans, one))
    }

    /// `[CTU]` `[CTD]` `[CTC]`
    pub(super) fn wrapping_counter(&mut self, op: Op, arguments: Arguments, en: Bit) -> Result<Bit> {
        let routine = match op {
            Op::Ctu => Routine::WrappingCtu,
            Op::Ctd => Routine::WrappingCtd,
            Op::Ctc => Routine::WrappingCtc,
            _ => return Err(arguments.not_in_profile()),
        };
        let (bits, words) = self.home_of(arguments)?;
        let most = self.word(arguments.value(1)?)?;
        let (out, before) = (self.layout.bit(), self.layout.bit());
        self.remember(Cell::Bit(before));
        self.routine(routine, &[out.0, en.0, most.0, bits.0, words.0, before.0]);
        Ok(out)
    }

    /// `(RES)`: what is counted becomes 0, and nothing else happens.
    pub(super) fn clear_count(&mut self, en: Bit, at: Word) -> Bit {
        let out = self.layout.bit();
        let from = self.constant(0);
        self.emit(Instr::MoveWhen {
            out,
            en,
            to: at,
            from,
        });
        en
    }
}

/// What a count can reach.
const MOST_SCANS: i64 = i16::MAX as i64;
