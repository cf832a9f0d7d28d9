//! All of a machine's state that scans change, apart from its clock and from what it sent.

use super::delta::{Bytes, Way, move_cells, move_queue, move_texts, write_cells, write_queue, write_texts};
use crate::machine::Machine;
use crate::memory::Text;
use std::collections::VecDeque;

/// A copy of a machine's banks at one moment.
#[derive(Debug, Clone)]
pub(super) struct Banks {
    pub(super) bits: Vec<u8>,
    pub(super) words: Vec<i64>,
    pub(super) texts: Vec<Text>,
    rows: Vec<u8>,
    reached: Vec<i64>,
    left_at: Vec<u32>,
    received: VecDeque<u8>,
}

impl Banks {
    /// What a machine holds.
    pub(super) fn of(machine: &Machine) -> Banks {
        let memory = &machine.memory;
        Banks {
            bits: memory.bits.clone(),
            words: memory.words.clone(),
            texts: memory.texts.clone(),
            rows: machine.rows.clone(),
            reached: machine.reached.clone(),
            left_at: machine.left_at.clone(),
            received: memory.received.clone(),
        }
    }

    /// Makes a machine hold this.
    pub(super) fn restore(&self, machine: &mut Machine) {
        let memory = &mut machine.memory;
        memory.bits.copy_from_slice(&self.bits);
        memory.words.copy_from_slice(&self.words);
        machine.rows.copy_from_slice(&self.rows);
        machine.reached.copy_from_slice(&self.reached);
        machine.left_at.copy_from_slice(&self.left_at);
        memory.texts.clone_from(&self.texts);
        memory.received.clone_from(&self.received);
    }

    /// Writes how a machine differs, and follows it.
    pub(super) fn follow(&mut self, machine: &Machine, out: &mut Vec<u8>) {
        let memory = &machine.memory;
        write_cells(out, &mut self.bits, &memory.bits);
        write_cells(out, &mut self.words, &memory.words);
        write_texts(out, &mut self.texts, &memory.texts);
        write_cells(out, &mut self.rows, &machine.rows);
        write_cells(out, &mut self.reached, &machine.reached);
        write_cells(out, &mut self.left_at, &machine.left_at);
        write_queue(out, &mut self.received, &memory.received);
    }

    /// Goes over a difference that [`Banks::follow`] wrote.
    pub(super) fn go(&mut self, mut bytes: Bytes<'_>, way: Way) {
        let bytes = &mut bytes;
        move_cells(bytes, &mut self.bits);
        move_cells(bytes, &mut self.words);
        move_texts(bytes, &mut self.texts, way);
        move_cells(bytes, &mut self.rows);
        move_cells(bytes, &mut self.reached);
        move_cells(bytes, &mut self.left_at);
        move_queue(bytes, &mut self.received, way);
    }
}
