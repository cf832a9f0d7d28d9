//! Coils (LANGUAGE §5.4). They act at every evaluation, so what they write is found at every evaluation too.

use super::arguments::Arguments;
use super::chosen::StateSpot;
use super::number_coils::is_number_coil;
use super::place::{Slot, Spot};
use super::{Compiler, Result};
use crate::code::Instr;
use crate::layout::{Home, counter, timer};
use crate::memory::Bit;
use ladder_analysis::program::Argument;
use ladder_instructions::{Coil, Edge, Instruction, SetPower, Timing};

impl Compiler<'_> {
    /// A coil, by what it writes.
    pub(super) fn coil(&mut self, row: &Instruction, arguments: Arguments, en: Bit) -> Result<Bit> {
        match row.coil {
            Some(coil) if is_number_coil(arguments) => self.coil_on_number(coil, arguments, en),
            Some(Coil::Follows) => self.plain_coil(arguments, en, true),
            Some(Coil::Negated) => self.plain_coil(arguments, en, false),
            Some(Coil::Sets) => self.set_coil(arguments, en),
            Some(Coil::Resets) => self.reset_coil(arguments, en),
            Some(Coil::OnEdge(edge)) => self.edge_coil(arguments, en, edge == Edge::Rising),
            None => Ok(en),
        }
    }

    /// `( )` and `(/)`
    fn plain_coil(&mut self, arguments: Arguments, en: Bit, follows: bool) -> Result<Bit> {
        if let Argument::Range(range) = arguments.get(0)? {
            return self.coil_on_range(range, en);
        }
        let (spot, out) = self.coil_place(arguments, en)?;
        if let Spot::Bit(tag) = spot {
            self.emit(if follows {
                Instr::Coil { en, tag }
            } else {
                Instr::NegatedCoil { en, tag }
            });
            return Ok(en);
        }
        let value = if follows {
            en
        } else {
            let to = self.layout.bit();
            self.emit(Instr::NotBit { to, a: en });
            to
        };
        self.store(spot, Slot::Bit(value));
        Ok(out)
    }

    /// `(S)`: its power is the tag's, or EN.
    fn set_coil(&mut self, arguments: Arguments, en: Bit) -> Result<Bit> {
        if let Argument::Range(range) = arguments.get(0)? {
            return self.set_coil_on_range(range, en);
        }
        let (place, _) = arguments.place(0)?;
        let follows_tag = self.semantics.set_power == SetPower::Tag;
        let out = self.layout.bit();
        let spot = self.spot(place)?;
        if let Spot::Bit(tag) = spot {
            self.emit(Instr::Set { en, tag });
            if !follows_tag {
                return Ok(en);
            }
            self.emit(Instr::Contact {
                out,
                en: Bit::HIGH,
                tag,
            });
            return Ok(out);
        }
        let Slot::Bit(before) = self.load(spot) else {
            return Err(arguments.mismatch());
        };
        self.emit(Instr::OrBit {
            to: out,
            a: en,
            b: before,
        });
        self.store(spot, Slot::Bit(out));
        // Read again: a forced tag does not take what is written.
        let Slot::Bit(after) = self.load(spot) else {
            return Err(arguments.mismatch());
        };
        self.emit(Instr::MoveBit { to: out, from: after });
        Ok(if follows_tag { out } else { en })
    }

    /// `(R)`, on timers and counters too.
    fn reset_coil(&mut self, arguments: Arguments, en: Bit) -> Result<Bit> {
        match arguments.get(0)? {
            Argument::Range(range) => return self.reset_coil_on_range(range, en),
            Argument::State(_) | Argument::ChosenState(_) => return self.clear(arguments, en),
            _ => {}
        }
        let (spot, out) = self.coil_place(arguments, en)?;
        if let Spot::Bit(tag) = spot {
            self.emit(Instr::Reset { en, tag });
            return Ok(en);
        }
        let Slot::Bit(before) = self.load(spot) else {
            return Err(arguments.mismatch());
        };
        let to = self.layout.bit();
        self.emit(Instr::NotBit { to, a: en });
        self.emit(Instr::AndBit { to, a: to, b: before });
        self.store(spot, Slot::Bit(to));
        Ok(out)
    }

    /// `(P)` and `(N)`
    fn edge_coil(&mut self, arguments: Arguments, en: Bit, rising: bool) -> Result<Bit> {
        // The edge first: a fault in finding the place must not keep the memory from its update.
        let memory = self.edge_memory(arguments.place(0).ok().map(|(place, _)| place))?;
        let edge = self.edge_with(memory, Bit::HIGH, en, rising);
        let (spot, out) = self.coil_place(arguments, en)?;
        if let Spot::Bit(tag) = spot {
            self.emit(Instr::Coil { en: edge, tag });
            return Ok(en);
        }
        self.store(spot, Slot::Bit(edge));
        Ok(out)
    }

    /// `(RES)`
    pub(super) fn clear(&mut self, arguments: Arguments, en: Bit) -> Result<Bit> {
        match self.semantics.timing {
            Timing::Clock | Timing::Units => return self.clear_chosen(arguments, en),
            Timing::Ticks => return self.reset_ticks(arguments, en),
            Timing::Scans => {}
        }
        let tag = arguments.state(0)?;
        let Home::State { state, words, .. } = self.homes[tag.0 as usize] else {
            return Err(arguments.mismatch());
        };
        let count = if state.is_timer() { timer::ET } else { counter::CV };
        Ok(self.clear_count(en, words.offset(count)))
    }

    /// The same, where a computed index may choose the timer or counter.
    fn clear_chosen(&mut self, arguments: Arguments, en: Bit) -> Result<Bit> {
        let out = self.layout.bit();
        let start = self.code.instrs.len();
        self.emit(Instr::Follow { out, en });
        let found = self.state_spot(arguments.get(0)?)?;
        let (state, spot) = found.ok_or_else(|| arguments.mismatch())?;
        match spot {
            StateSpot::Fixed { bits, words } => {
                self.code.instrs.truncate(start);
                self.emit(Instr::Clear {
                    en,
                    state,
                    bits,
                    words,
                });
                Ok(en)
            }
            StateSpot::At { bits, words } => {
                self.emit(Instr::ClearAt {
                    en,
                    state,
                    bits,
                    words,
                });
                Ok(out)
            }
        }
    }

    /// The place that a coil writes, and the power after it: EN, in a slot of its own where finding the place
    /// may fault and take it back.
    fn coil_place(&mut self, arguments: Arguments, en: Bit) -> Result<(Spot, Bit)> {
        let (place, _) = arguments.place(0)?;
        let out = self.layout.bit();
        let start = self.code.instrs.len();
        self.emit(Instr::Follow { out, en });
        let spot = self.spot(place)?;
        if self.code.instrs.len() > start + 1 {
            return Ok((spot, out));
        }
        self.code.instrs.truncate(start);
        Ok((spot, en))
    }
}
