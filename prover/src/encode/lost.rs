//! What is not followed: the cells that it may write are open, and so is whether it faults. Who goes on in a way that is not
//! followed is lost: at the end of the scan all that it may have written from there on is open for it.

use super::Scan;
use super::uses::{Access, Cell, for_each_access};
use super::world::Gap;
use crate::graph::Lit;
use crate::number::Number;
use ladder_analysis::values::types::Scalar;
use ladder_simulator::compiled::{Bit, Instr, Routine, Width, Word};
use rustc_hash::FxHashSet;

/// Who is lost.
#[derive(Debug)]
pub(super) struct Lost {
    who: Lit,
    /// The first instruction that may run then.
    from: u32,
    gap: Gap,
}

impl Scan<'_, '_> {
    /// These go on at an instruction or after it, and it is not known where.
    pub(super) fn lose(&mut self, who: Lit, from: u32, what: &str, at: u32) {
        if who == Lit::FALSE {
            return;
        }
        if self.alone.is_some() {
            return self.block(what, at);
        }
        let gap = Gap {
            what: what.into(),
            location: self.location(at),
        };
        // The caller of a function goes on too.
        let from = if self.open.is_empty() { from } else { 0 };
        self.leave(who, u32::MAX);
        self.lost.push(Lost { who, from, gap });
    }

    /// Nothing more is followed: all that the code writes is open.
    pub(crate) fn stop(&mut self, what: &str, at: u32) {
        self.lose(Lit::TRUE, 0, what, at);
        self.is_stopped = true;
    }

    /// Whether someone goes on in a way that is not known.
    pub(crate) fn has_lost(&self) -> bool {
        !self.lost.is_empty()
    }

    /// At the end: opens what they may have written.
    pub(super) fn open_lost(&mut self) {
        for lost in std::mem::take(&mut self.lost) {
            let from = self.first_reached(lost.from);
            let mut cells: FxHashSet<Cell> = FxHashSet::default();
            let all = from..self.code.instrs.len() as u32;
            for_each_access(self.code, &self.reach, all, &mut |_, cell, access| {
                if access != Access::Read {
                    cells.insert(cell);
                }
            });
            let mut cells: Vec<Cell> = cells.into_iter().collect();
            // The same order in each run.
            cells.sort_unstable_by_key(|cell| match *cell {
                Cell::Bit(Bit(at)) => (0, at),
                Cell::Word(Word(at)) => (1, at),
                Cell::Timer(Bit(at)) => (2, at),
                Cell::Elapsed(Word(at)) => (3, at),
                Cell::Unknown => (4, 0),
            });
            for cell in cells {
                self.open_cell(cell, lost.who, &lost.gap);
            }
            let open = self.world.open_bits(lost.gap, 2);
            let [faults, ends] = [0, 1].map(|n| self.world.graph.and(lost.who, open[n]));
            self.faulted = self.world.graph.or(self.faulted, faults);
            self.ended = self.world.graph.or(self.ended, ends);
        }
    }

    /// The first instruction that may run after another: jumps and loops go back.
    fn first_reached(&self, mut from: u32) -> u32 {
        loop {
            let before = from;
            for (at, instr) in (0u32..).zip(&self.code.instrs).skip(from as usize) {
                if let Instr::Jump { to, .. } = *instr
                    && at >= from
                {
                    from = from.min(to);
                }
            }
            for &(body, after) in &self.loops {
                if body < from && from < after {
                    from = body;
                }
            }
            if from == before {
                return from;
            }
        }
    }

    fn open_cell(&mut self, cell: Cell, who: Lit, gap: &Gap) {
        match cell {
            Cell::Bit(bit) if !self.memory.is_temporary_bit(bit) => {
                let open = self.world.open_bits(gap.clone(), 1)[0];
                let old = self.bit(bit);
                let value = self.world.graph.choose(who, open, old);
                self.memory.set_bit(bit, value);
            }
            Cell::Word(word) | Cell::Elapsed(word) if !self.memory.is_temporary_word(word) => {
                let open = self.open_value(word, gap);
                let old = self.word(word);
                let value = self.world.graph.choose_number(who, &open, &old);
                self.memory.set_word(word, value);
            }
            Cell::Timer(timer) => {
                let open = self.world.open_bits(gap.clone(), 3);
                let phase = self.memory.phase(self.world, timer);
                let phase = phase.iter().zip(open);
                let phase = phase.map(|(old, open)| self.world.graph.choose(who, open, *old));
                let phase = phase.collect();
                self.memory.set_phase(timer, phase);
                if let Some(age) = self.memory.known_age(timer) {
                    let open = Number::unsigned(self.world.open_bits(gap.clone(), age.len() - 1));
                    let age = self.world.graph.choose_number(who, &open, &age);
                    self.memory.set_age(timer, age);
                }
            }
            _ => {}
        }
    }

    /// Any value that a word may hold.
    fn open_value(&mut self, word: Word, gap: &Gap) -> Number {
        let ty = self.memory.type_of(word);
        let width = ty.map_or(Width::I64, Width::of);
        let bits = self.world.open_bits(gap.clone(), width.bits() as usize);
        if ty.is_some_and(Scalar::is_real) {
            let all = self.world.graph.all(bits[52..63].to_vec());
            self.world.valid.push(!all);
        }
        Number::of_bits(bits).wrapped(width)
    }

    /// A routine that is not followed.
    pub(super) fn open_routine(&mut self, at: u32, routine: Routine, pool: &[u32], what: &str) {
        let mut cells = Vec::new();
        routine.for_each_use(pool, &|words| self.reach.range(words), &mut |cell, access| {
            if access != Access::Read {
                cells.push(cell);
            }
        });
        if routine.can_fault() {
            let fault = self.open_bits(what, at, 1)[0];
            self.fault(at, fault);
        }
        self.open_cells(at, cells, what);
    }

    /// What an instruction writes that is not followed.
    pub(super) fn open_cells(&mut self, at: u32, cells: Vec<Cell>, what: &str) {
        let gap = Gap {
            what: what.into(),
            location: self.location(at),
        };
        for cell in cells {
            match cell {
                Cell::Bit(bit) => {
                    let open = self.world.open_bits(gap.clone(), 1)[0];
                    self.write_bit(bit, open);
                }
                Cell::Word(word) | Cell::Elapsed(word) => {
                    let open = self.open_value(word, &gap);
                    self.write_word(word, open);
                }
                Cell::Timer(_) => self.open_cell(cell, self.act, &gap),
                Cell::Unknown => self.stop(what, at),
            }
        }
    }
}
