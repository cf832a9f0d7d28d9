//! Timers that count a time base and counters that latch, as iot-ladder-editor has them.

use super::arguments::Arguments;
use super::{Compiler, Result};
use crate::layout::{Home, counter};
use crate::memory::{Bit, Word};
use crate::operation::IntegerOp;
use crate::routine::Routine;
use ladder_analysis::program::{Argument, Expr, ExprKind};
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_instructions::{Counting, Op, StateType};

/// The time base where none is given.
const BASE: i64 = 100_000_000;

impl Compiler<'_> {
    /// `[TON]` `[TOF]`
    pub(super) fn tick_timer(&mut self, op: Op, arguments: Arguments, en: Bit) -> Result<Bit> {
        let routine = match op {
            Op::Ton => Routine::TickTon,
            Op::Tof => Routine::TickTof,
            _ => return Err(arguments.not_in_profile()),
        };
        let (bits, words) = self.home_of(arguments)?;
        let base = match arguments.named_value("B")? {
            Some(base) => self.word(base)?,
            None => self.constant(BASE),
        };
        let preset = self.ticks(arguments.value(1)?, base)?;
        let interval = self.constant(self.interval);
        let out = self.layout.bit();
        self.routine(
            routine,
            &[out.0, en.0, preset.0, bits.0, words.0, base.0, interval.0],
        );
        Ok(out)
    }

    /// PT: a plain integer counts the base, a time is brought to it.
    pub(super) fn ticks(&mut self, preset: &Expr, base: Word) -> Result<Word> {
        let word = self.word(preset)?;
        if preset.ty != Scalar::Time {
            return Ok(word);
        }
        let one = self.constant(1);
        // A base of 0 or less is none.
        let base = self.integer(IntegerOp::Max, Scalar::Lint, base, one);
        Ok(self.integer(IntegerOp::Div, Scalar::Lint, word, base))
    }

    /// `[CTU]` `[CTD]`
    pub(super) fn latching_counter(&mut self, op: Op, arguments: Arguments, en: Bit) -> Result<Bit> {
        let routine = match op {
            Op::Ctu => Routine::LatchingCtu,
            Op::Ctd => Routine::LatchingCtd,
            _ => return Err(arguments.not_in_profile()),
        };
        let (bits, words) = self.home_of(arguments)?;
        let preset = self.word(arguments.value(1)?)?;
        let out = self.layout.bit();
        self.routine(routine, &[out.0, en.0, preset.0, bits.0, words.0]);
        Ok(out)
    }

    /// Finds what counters begin with, and what a reset gives them again: operand `AC` of their block.
    pub(super) fn starting_counts(&mut self) {
        let program = self.program;
        let networks = &program.networks;
        for network in networks
            .iter()
            .filter(|network| program.semantics(network.location).counting == Counting::Latching)
        {
            for block in &network.blocks {
                let arguments = Arguments::of(block);
                let (Ok(tag), Some(Argument::Value(start))) = (arguments.state(0), arguments.named("AC"))
                else {
                    continue;
                };
                let ExprKind::Constant(Value::Int(number)) = start.kind else {
                    continue;
                };
                let word = self.constant(number);
                self.starts.insert(tag, word);
                if let Home::State { words, .. } = self.homes[tag.0 as usize] {
                    self.layout.memory.words[words.offset(counter::CV).0 as usize] = number;
                }
            }
        }
    }

    /// `(RES)`
    pub(super) fn reset_ticks(&mut self, arguments: Arguments, en: Bit) -> Result<Bit> {
        let tag = arguments.state(0)?;
        let Home::State { state, bits, words } = self.homes[tag.0 as usize] else {
            return Err(arguments.mismatch());
        };
        let start = match self.starts.get(&tag) {
            Some(&start) => start,
            None => self.constant(0),
        };
        let interval = self.constant(self.interval);
        let routine = if state.is_timer() {
            Routine::TickReset
        } else {
            Routine::LatchingReset
        };
        let is_known = state.is_timer() || state.is_counter();
        debug_assert!(is_known, "{} has nothing to reset", StateType::name(state));
        self.routine(routine, &[en.0, bits.0, words.0, start.0, interval.0]);
        Ok(en)
    }
}
