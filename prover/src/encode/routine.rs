//! Routines: the rarer work. What is not followed leaves what it writes open, or says that it cannot be followed.

use super::Scan;
use crate::graph::Lit;
use crate::number::Number;
use ladder_simulator::compiled::{Bit, Routine, Word};

impl Scan<'_, '_> {
    pub(super) fn routine(&mut self, at: u32, routine: Routine, operands: u32) {
        let pool = &self.code.operands[operands as usize..];
        if self.on_ranges(at, routine, pool) {
            return;
        }
        if self.alone.is_some() && writes_unseen(routine) {
            return self.block("texts are not followed", at);
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
            (Routine::ParseBit, [to, ..]) => {
                let bits = self.open_bits("texts are not tracked", at, 2);
                self.fault(at, bits[1]);
                self.write_bit(Bit(*to), bits[0]);
            }
            (
                Routine::FillTexts
                | Routine::RepeatTexts
                | Routine::ShiftTexts
                | Routine::Concat
                | Routine::Format
                | Routine::FormatBit
                | Routine::Send
                | Routine::SendText,
                _,
            ) => {}
            (
                Routine::Left
                | Routine::Right
                | Routine::Middle
                | Routine::Insert
                | Routine::Delete
                | Routine::Replace,
                _,
            ) => {
                let fault = self.open_bits("texts are not tracked", at, 1)[0];
                self.fault(at, fault);
            }
            (Routine::Length | Routine::Find, [to, ..]) => {
                let bits = self.open_bits("texts are not tracked", at, 16);
                self.write_word(Word(*to), Number::unsigned(bits));
            }
            (Routine::Curve, [to, ..]) => {
                let mut bits = self.open_bits("points on curves are not tracked", at, 65);
                let fault = bits.pop().unwrap_or(Lit::FALSE);
                self.fault(at, fault);
                self.write_word(Word(*to), Number::of_bits(bits));
            }
            (other, _) => {
                let name = format!("{other:?}");
                self.block(format!("this block is not followed ({name})"), at);
            }
        }
    }

    /// Of each number from 0 whether the selector is it; a fault if it is none.
    fn selected(&mut self, at: u32, selector: Word, count: usize) -> Vec<Lit> {
        let selector = self.word(selector);
        let which: Vec<Lit> = (0..count)
            .map(|n| self.world.graph.equal(&selector, &Number::constant(n as i64)))
            .collect();
        let some = self.world.graph.any(which.iter().copied());
        self.fault(at, !some);
        which
    }
}

/// Whether it writes something that is not tracked: texts, and the serial port.
const fn writes_unseen(routine: Routine) -> bool {
    matches!(
        routine,
        Routine::SelectText
            | Routine::FillTexts
            | Routine::RepeatTexts
            | Routine::ShiftTexts
            | Routine::Concat
            | Routine::Format
            | Routine::FormatBit
            | Routine::Send
            | Routine::SendText
            | Routine::Left
            | Routine::Right
            | Routine::Middle
            | Routine::Insert
            | Routine::Delete
            | Routine::Replace
    )
}
