//! Timers, counters and bistables (LANGUAGE §5.3): their inputs are copied into the tag's members, then the tag
//! is evaluated.

use super::arguments::Arguments;
use super::chosen::StateSpot;
use super::{Compiler, Result};
use crate::code::Instr;
use crate::layout::{Home, counter, state_size, timer};
use crate::memory::{Bit, Word};
use crate::operation::{Conversion, Width};
use ladder_analysis::program::{Expr, ExprKind};
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_instructions::{FirstEdges, Op, StateType};

/// A state that a routine works on.
pub(super) struct Lent {
    pub(super) state: StateType,
    pub(super) bits: Bit,
    pub(super) words: Word,
    /// The words with the slots that it is a copy of.
    chosen: Option<(Word, Word)>,
}

impl Compiler<'_> {
    /// Where the state of a timer or counter is that has its block alone.
    pub(super) fn home_of(&self, arguments: Arguments) -> Result<(Bit, Word)> {
        match self.homes[arguments.state(0)?.0 as usize] {
            Home::State { bits, words, .. } => Ok((bits, words)),
            _ => Err(arguments.mismatch()),
        }
    }

    /// A state for a routine, which works on fixed slots: one that an index chooses is lent to it as a copy.
    pub(super) fn lend_state(&mut self, arguments: Arguments) -> Result<Lent> {
        let found = self.state_spot(arguments.get(0)?)?;
        let (state, spot) = found.ok_or_else(|| arguments.mismatch())?;
        let (at_bits, at_words) = match spot {
            StateSpot::Fixed { bits, words } => {
                return Ok(Lent {
                    state,
                    bits,
                    words,
                    chosen: None,
                });
            }
            StateSpot::At { bits, words } => (bits, words),
        };
        let (bit_count, word_count) = state_size(state);
        let all_bits: Vec<Bit> = (0..bit_count).map(|_| self.layout.bit()).collect();
        let all_words: Vec<Word> = (0..word_count).map(|_| self.layout.word()).collect();
        let (Some(&bits), Some(&words)) = (all_bits.first(), all_words.first()) else {
            return Err(arguments.mismatch());
        };
        for (n, to) in (0..).zip(all_bits) {
            self.layout.keep(to);
            let at = self.slot_offset(at_bits, n);
            self.emit(Instr::LoadBit { to, at });
        }
        for (n, to) in (0..).zip(all_words) {
            let at = self.slot_offset(at_words, n);
            self.emit(Instr::LoadWord { to, at });
        }
        Ok(Lent {
            state,
            bits,
            words,
            chosen: Some((at_bits, at_words)),
        })
    }

    /// Puts a copy back.
    pub(super) fn take_back(&mut self, lent: &Lent) {
        let Some((bits, words)) = lent.chosen else { return };
        let (bit_count, word_count) = state_size(lent.state);
        for n in 0..bit_count {
            let (at, from) = (self.slot_offset(bits, n), lent.bits.offset(n));
            self.emit(Instr::StoreBit { at, from });
        }
        for n in 0..word_count {
            let (at, from) = (self.slot_offset(words, n), lent.words.offset(n));
            self.emit(Instr::StoreWord { at, from });
        }
    }

    /// Where the state of a timer, counter or bistable begins.
    fn state(&mut self, arguments: Arguments) -> Result<StateSpot> {
        let found = self.state_spot(arguments.get(0)?)?;
        found.map(|(_, spot)| spot).ok_or_else(|| arguments.mismatch())
    }

    /// Where a state begins that is always the same one. One that an index chooses is evaluated here: none is left to do.
    fn fixed_or_chosen(
        &mut self,
        state: StateSpot,
        op: Op,
        (out, en): (Bit, Bit),
        operand: u32,
    ) -> Option<(Bit, Word)> {
        match state {
            StateSpot::Fixed { bits, words } => Some((bits, words)),
            StateSpot::At { bits, words } => {
                self.emit(Instr::StateAt {
                    op,
                    out,
                    en,
                    operand,
                    bits,
                    words,
                });
                None
            }
        }
    }

    /// The same as [`Compiler::inputs`], of a state that may be chosen by a computed index.
    fn inputs_of(&mut self, arguments: Arguments, state: StateSpot, inputs: &[(&str, u32)]) -> Result<()> {
        let (bits, at) = match state {
            StateSpot::Fixed { bits, .. } => (bits, None),
            StateSpot::At { bits, .. } => (Bit(0), Some(bits)),
        };
        let Some(at) = at else {
            let inputs: Vec<(&str, Bit)> = (inputs.iter())
                .map(|&(name, member)| (name, bits.offset(member)))
                .collect();
            return self.inputs(arguments, &inputs);
        };
        let mut moves = Vec::new();
        for &(name, member) in inputs {
            if let Some(value) = arguments.named_value(name)? {
                let from = self.bit(value)?;
                let value = self.layout.bit();
                self.emit(Instr::MoveBit { to: value, from });
                moves.push((self.slot_offset(at, member), value));
            }
        }
        for (at, from) in moves {
            self.emit(Instr::StoreBit { at, from });
        }
        Ok(())
    }

    /// Copies named operands into members, once all of them are read. A block without one leaves its member low.
    pub(super) fn inputs(&mut self, arguments: Arguments, inputs: &[(&str, Bit)]) -> Result<()> {
        let mut moves = Vec::new();
        for &(name, member) in inputs {
            if let Some(value) = arguments.named_value(name)? {
                moves.push((member, self.bit(value)?));
            }
        }
        for n in 1..moves.len() {
            // It reads a member that is written before.
            if moves[..n].iter().any(|&(member, _)| member == moves[n].1) {
                let to = self.layout.bit();
                self.emit(Instr::MoveBit { to, from: moves[n].1 });
                moves[n].1 = to;
            }
        }
        for (to, from) in moves {
            self.emit(Instr::MoveBit { to, from });
        }
        Ok(())
    }

    pub(super) fn timer(&mut self, op: Op, arguments: Arguments, en: Bit) -> Result<Bit> {
        let state = self.state(arguments)?;
        let out = self.layout.bit();
        let pt = self.preset(arguments.value(1)?)?;
        self.inputs_of(arguments, state, &[("R", timer::R)])?;
        let Some((bits, words)) = self.fixed_or_chosen(state, op, (out, en), pt.0) else {
            return Ok(out);
        };
        self.emit(match op {
            Op::Tof => Instr::Tof {
                out,
                en,
                pt,
                bits,
                words,
            },
            Op::Tp => Instr::Tp {
                out,
                en,
                pt,
                bits,
                words,
            },
            Op::Rto => Instr::Rto {
                out,
                en,
                pt,
                bits,
                words,
            },
            Op::Rtof => Instr::Rtof {
                out,
                en,
                pt,
                bits,
                words,
            },
            _ => Instr::Ton {
                out,
                en,
                pt,
                bits,
                words,
            },
        });
        Ok(out)
    }

    /// A TIME, or a plain integer in milliseconds.
    fn preset(&mut self, value: &Expr) -> Result<Word> {
        if value.ty == Scalar::Time {
            return self.word(value);
        }
        let conversion = Conversion::Preset(Width::of(value.ty));
        if let ExprKind::Constant(Value::Int(number)) = value.kind
            && let Ok(nanoseconds) = crate::operation::convert(conversion, number)
        {
            return Ok(self.constant(nanoseconds));
        }
        let word = self.word(value)?;
        Ok(self.convert(conversion, word))
    }

    pub(super) fn counter(&mut self, op: Op, arguments: Arguments, en: Bit) -> Result<Bit> {
        let state = self.state(arguments)?;
        let out = self.layout.bit();
        let pv = self.word(arguments.value(1)?)?;
        let inputs = [("CD", counter::CD), ("R", counter::R), ("LD", counter::LD)];
        self.inputs_of(arguments, state, &inputs)?;
        let Some((bits, words)) = self.fixed_or_chosen(state, op, (out, en), pv.0) else {
            return Ok(out);
        };
        // What was high before does not count.
        let is_primed = self.semantics.first_edges == FirstEdges::None;
        let before = bits.offset(counter::UP_BEFORE);
        self.layout.memory.set_bit(before, is_primed);
        self.emit(match op {
            Op::Ctd => Instr::Ctd {
                out,
                en,
                pv,
                bits,
                words,
            },
            Op::Ctud => Instr::Ctud {
                out,
                en,
                pv,
                bits,
                words,
            },
            Op::Ctc => Instr::Ctc {
                out,
                en,
                pv,
                bits,
                words,
            },
            _ => Instr::Ctu {
                out,
                en,
                pv,
                bits,
                words,
            },
        });
        Ok(out)
    }

    pub(super) fn bistable(&mut self, op: Op, arguments: Arguments, en: Bit) -> Result<Bit> {
        let state = self.state(arguments)?;
        let out = self.layout.bit();
        let reset = match arguments.named_value("R")? {
            Some(value) => self.bit(value)?,
            None => Bit::LOW,
        };
        let Some((bits, _)) = self.fixed_or_chosen(state, op, (out, en), reset.0) else {
            return Ok(out);
        };
        self.emit(match op {
            Op::Rs => Instr::Rs { out, en, reset, bits },
            _ => Instr::Sr { out, en, reset, bits },
        });
        Ok(out)
    }
}
