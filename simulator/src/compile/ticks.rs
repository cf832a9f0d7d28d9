//! Timers that count a time base and counters that latch, as iot-ladder-editor has them.

use super::arguments::Arguments;
use super::{Compiler, Result};
use crate::code::Instr;
use crate::layout::{Home, counter};
use crate::memory::{Bit, Word};
use crate::operation::IntegerOp;
use crate::routine::Routine;
use ladder_analysis::program::{Argument, Expr, ExprKind, TagId};
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
        let lent = self.lend_state(arguments)?;
        let base = match arguments.named_value("B")? {
            Some(base) => self.word(base)?,
            None => self.constant(BASE),
        };
        let preset = self.ticks(arguments.value(1)?, base)?;
        let interval = self.constant(self.interval);
        let out = self.layout.bit();
        self.routine(
            routine,
            &[
                out.0,
                en.0,
                preset.0,
                lent.bits.0,
                lent.words.0,
                base.0,
                interval.0,
            ],
        );
        self.take_back(&lent);
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
        let lent = self.lend_state(arguments)?;
        let preset = self.word(arguments.value(1)?)?;
        let out = self.layout.bit();
        self.routine(routine, &[out.0, en.0, preset.0, lent.bits.0, lent.words.0]);
        self.take_back(&lent);
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
                let Some(Argument::Value(start)) = arguments.named("AC") else {
                    continue;
                };
                let tags: Vec<TagId> = match arguments.get(0) {
                    Ok(Argument::State(tag)) => vec![*tag],
                    Ok(Argument::ChosenState(all)) => {
                        let tags = 0..all.count;
                        tags.map(|n| TagId(all.first.0 + n * all.step)).collect()
                    }
                    _ => continue,
                };
                let ExprKind::Constant(Value::Int(number)) = start.kind else {
                    continue;
                };
                let word = self.constant(number);
                for tag in tags {
                    self.starts.insert(tag, word);
                    if let Home::State { words, .. } = self.homes[tag.0 as usize] {
                        self.layout.memory.words[words.offset(counter::CV).0 as usize] = number;
                    }
                }
            }
        }
    }

    /// `(RES)`
    pub(super) fn reset_ticks(&mut self, arguments: Arguments, en: Bit) -> Result<Bit> {
        let out = self.layout.bit();
        self.emit(Instr::Follow { out, en });
        let lent = self.lend_state(arguments)?;
        let (state, bits, words) = (lent.state, lent.bits, lent.words);
        // What an index chooses among begins alike: one block is on all of it.
        let tag = match arguments.get(0)? {
            Argument::ChosenState(chosen) => Some(chosen.first),
            argument => argument.root(),
        };
        let start = match tag.and_then(|tag| self.starts.get(&tag)) {
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
        self.take_back(&lent);
        Ok(out)
    }
}
