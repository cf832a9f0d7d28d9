//! All of a machine's state that scans change, apart from its clock and from what it sent.

use super::delta::{Bytes, Way, move_cells, move_queue, move_texts, write_cells, write_queue, write_texts};
use super::touched::Touched;
use crate::machine::Machine;
use crate::memory::Memory;

/// A copy of a machine's banks at one moment.
#[derive(Debug, Clone)]
pub(super) struct Banks {
    /// Without what is forced and what was sent.
    pub(super) memory: Memory,
    rows: Vec<u8>,
    reached: Vec<i64>,
    left_at: Vec<u32>,
}

/// What a machine holds in addition to its memory.
struct Rest<'m> {
    rows: &'m [u8],
    reached: &'m [i64],
    left_at: &'m [u32],
}

impl Banks {
    /// What a machine holds.
    pub(super) fn of(machine: &Machine) -> Banks {
        let memory = &machine.memory;
        Banks {
            memory: Memory {
                bits: memory.bits.clone(),
                words: memory.words.clone(),
                texts: memory.texts.clone(),
                received: memory.received.clone(),
                ..Memory::default()
            },
            rows: machine.rows.clone(),
            reached: machine.reached.clone(),
            left_at: machine.left_at.clone(),
        }
    }

    /// Makes a machine hold this.
    pub(super) fn restore(&self, machine: &mut Machine) {
        let memory = &mut machine.memory;
        memory.bits.copy_from_slice(&self.memory.bits);
        memory.words.copy_from_slice(&self.memory.words);
        machine.rows.copy_from_slice(&self.rows);
        machine.reached.copy_from_slice(&self.reached);
        machine.left_at.copy_from_slice(&self.left_at);
        memory.texts.clone_from(&self.memory.texts);
        memory.received.clone_from(&self.memory.received);
    }

    /// Writes how a machine differs, follows it, and marks what it touched.
    pub(super) fn follow(&mut self, machine: &Machine, touched: &mut Touched, out: &mut Vec<u8>) {
        let rest = Rest {
            rows: &machine.rows,
            reached: &machine.reached,
            left_at: &machine.left_at,
        };
        self.write(&machine.memory, rest, touched, out);
    }

    /// The same for banks of a later moment.
    pub(super) fn follow_banks(&mut self, newer: &Banks, touched: &mut Touched, out: &mut Vec<u8>) {
        let rest = Rest {
            rows: &newer.rows,
            reached: &newer.reached,
            left_at: &newer.left_at,
        };
        self.write(&newer.memory, rest, touched, out);
    }

    fn write(&mut self, memory: &Memory, rest: Rest<'_>, touched: &mut Touched, out: &mut Vec<u8>) {
        let old = &mut self.memory;
        write_cells(out, &mut old.bits, &memory.bits, |run| touched.mark_bits(run));
        write_cells(out, &mut old.words, &memory.words, |run| touched.mark_words(run));
        write_texts(out, &mut old.texts, &memory.texts, |at| touched.mark_text(at));
        write_cells(out, &mut self.rows, rest.rows, |_| ());
        write_cells(out, &mut self.reached, rest.reached, |_| ());
        write_cells(out, &mut self.left_at, rest.left_at, |_| ());
        write_queue(out, &mut old.received, &memory.received);
    }

    /// Goes over a difference that [`Banks::follow`] wrote.
    pub(super) fn go(&mut self, mut bytes: Bytes<'_>, way: Way) {
        let bytes = &mut bytes;
        self.go_over_tags(bytes, way);
        move_cells(bytes, &mut self.rows);
        move_cells(bytes, &mut self.reached);
        move_cells(bytes, &mut self.left_at);
        move_queue(bytes, &mut self.memory.received, way);
    }

    /// The same for the memory of tags alone, which comes first.
    pub(super) fn go_over_tags(&mut self, bytes: &mut Bytes<'_>, way: Way) {
        move_cells(bytes, &mut self.memory.bits);
        move_cells(bytes, &mut self.memory.words);
        move_texts(bytes, &mut self.memory.texts, way);
    }
}
