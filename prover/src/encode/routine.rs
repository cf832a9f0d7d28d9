//! Routines: the rarer work. What is not followed leaves what it writes open.

use super::Scan;
use super::controller::Relay;
use crate::graph::Lit;
use crate::number::Number;
use ladder_simulator::compiled::{Bit, Routine, Word};

impl Scan<'_, '_> {
    pub(super) fn routine(&mut self, at: u32, routine: Routine, operands: u32) {
        let pool = &self.code.operands[operands as usize..];
        if self.alone.is_some() && writes_unseen(routine) {
            return self.block("texts are not followed", at);
        }
        if self.on_ranges(at, routine, pool) {
            return;
        }
        match (routine, pool) {
            (Routine::SelectBit, [to, selector, count, list @ ..]) => {
                let list = &list[..*count as usize];
                let which = self.selected(at, Word(*selector), list.len());
                let mut value = Lit::FALSE;
                for (from, is_it) in list.iter().zip(which) {
                    let bit = self.bit(Bit(*from));
                    value = self.world.graph.choose(is_it, bit, value);
                }
                self.write_bit(Bit(*to), value);
            }
            (Routine::SelectWord, [to, selector, count, list @ ..]) => {
                let list = &list[..*count as usize];
                let which = self.selected(at, Word(*selector), list.len());
                let mut value = Number::constant(0);
                for (from, is_it) in list.iter().zip(which) {
                    let word = self.word(Word(*from));
                    value = self.world.graph.choose_number(is_it, &word, &value);
                }
                self.write_word(Word(*to), value);
            }
            // Nothing of what they write is tracked: texts, and the serial port.
            (Routine::SelectText, [_, selector, count, ..]) => {
                self.selected(at, Word(*selector), *count as usize);
            }
            (Routine::Length | Routine::Find, [to, ..]) => {
                let bits = self.open_bits(TEXTS, at, 16);
                self.write_word(Word(*to), Number::unsigned(bits));
            }
            (Routine::Search, _) => {
                if self.search(pool).is_none() {
                    self.open_routine(at, routine, pool, "searches for texts and reals are not tracked");
                }
            }
            (Routine::OpenTable | Routine::OpenCurve, _) => {
                if self.open_table(routine, pool).is_none() {
                    self.open_routine(at, routine, pool, CURVES);
                }
            }
            (Routine::Curve, _) => {
                if self.curve(pool).is_none() {
                    self.open_routine(at, routine, pool, CURVES);
                }
            }
            (Routine::ScanTon | Routine::ScanTof | Routine::ScanRto, _) => self.scan_timer(routine, pool),
            (Routine::WrappingCtu | Routine::WrappingCtd | Routine::WrappingCtc, _) => {
                self.wrapping_counter(routine, pool);
            }
            (Routine::TickTon | Routine::TickTof, _) => self.tick_timer(routine, pool),
            (Routine::TickReset, _) => self.reset_tick_timer(pool),
            (Routine::LatchingCtu | Routine::LatchingCtd, _) => self.latching_counter(routine, pool),
            (Routine::LatchingReset, _) => self.reset_latching_counter(pool),
            (Routine::UnitTon | Routine::UnitTof | Routine::UnitRto | Routine::UnitRtof, _) => {
                if !self.unit_timer(routine, pool) {
                    self.open_routine(at, routine, pool, "timers whose unit is a tag are not tracked");
                }
            }
            (Routine::ComparingCtu | Routine::ComparingCtd | Routine::ComparingCtud, _) => {
                self.comparing_counter(routine, pool);
            }
            (Routine::Step, _) => {
                if self.step(pool).is_none() {
                    self.open_routine(
                        at,
                        routine,
                        pool,
                        "powers, and arithmetic of reals, are not tracked",
                    );
                }
            }
            (Routine::Cut | Routine::Clamp | Routine::Round, _) => {
                if self.brought(routine, pool).is_none() {
                    self.open_routine(
                        at,
                        routine,
                        pool,
                        "reals that become whole numbers are not tracked",
                    );
                }
            }
            (Routine::Controller, _) => self.controller(pool),
            (Routine::EndOnDivision, [division, ..]) => {
                let division = self.bit(Bit(*division));
                let ends = self.world.graph.and(self.act, division);
                self.faulted = self.world.graph.or(self.faulted, ends);
                self.ended = self.world.graph.or(self.ended, ends);
            }
            (Routine::Receive | Routine::ReceiveNewest, [to, came, ..]) => {
                let bits = self.open_bits("the serial port is not tracked", at, 9);
                self.write_bit(Bit(*came), bits[8]);
                self.write_word_if(bits[8], Word(*to), &Number::unsigned(bits[..8].to_vec()));
            }
            (other, _) => self.open_routine(at, other, pool, TEXTS),
        }
    }

    /// Of each number from 0 whether the selector is it; a fault if it is none.
    fn selected(&mut self, at: u32, selector: Word, count: usize) -> Vec<Lit> {
        let selector = self.word(selector);
        let which: Vec<Lit> = (0..count)
            .map(|n| self.world.graph.equal(&selector, &Number::constant(n as i64)))
            .collect();
        let some = self.world.graph.any(which.iter().copied());
        self.fault_of(at, Some(Relay::Other), !some);
        which
    }
}

const TEXTS: &str = "texts and the serial port are not tracked";
const CURVES: &str = "curves of reals, and those whose points are tags, are not tracked";

/// Whether it writes something that is not tracked: texts, and the serial port.
pub(super) const fn writes_unseen(routine: Routine) -> bool {
    matches!(
        routine,
        Routine::SelectText
            | Routine::FillTexts
            | Routine::RepeatTexts
            | Routine::ShiftTexts
            | Routine::CopyTexts
            | Routine::Concat
            | Routine::Format
            | Routine::FormatBit
            | Routine::Send
            | Routine::SendText
            | Routine::SendTextSlowly
            | Routine::SendWhenFree
            | Routine::SendScanTime
            | Routine::Left
            | Routine::Right
            | Routine::Middle
            | Routine::Insert
            | Routine::Delete
            | Routine::Replace
    )
}
