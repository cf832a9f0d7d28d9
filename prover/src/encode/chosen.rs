//! Timers, counters and bistables that an index chooses: each of them runs where it is the one.

use super::Scan;
use super::uses::{Access, Cell, chosen, for_each_access};
use crate::graph::Lit;
use crate::number::Number;
use ladder_simulator::compiled::{Instr, Word};

/// Of more the states are open.
const MOST_STATES: usize = 64;

impl Scan<'_, '_> {
    pub(super) fn chosen_state(&mut self, at: u32, instr: Instr, bits: Word) {
        let number = self.word(bits);
        let all: Vec<(u32, Instr)> = chosen(&self.reach, &instr)
            .into_iter()
            .flatten()
            .map(|(bits, _, instr)| (bits, instr))
            .collect();
        if all.is_empty() {
            return self.stop("an index chooses a timer, counter or bistable", at);
        }
        if all.len() > MOST_STATES || self.alone.is_some() {
            let mut cells: Vec<Cell> = Vec::new();
            for_each_access(self.code, &self.reach, at..at + 1, &mut |_, cell, access| {
                if access != Access::Read {
                    cells.push(cell);
                }
            });
            return self.open_cells(at, cells, "an index chooses one of very many timers or counters");
        }
        let act = self.act;
        for (bits, instr) in all {
            let graph = &mut self.world.graph;
            let is_it = graph.equal(&number, &Number::constant(i64::from(bits)));
            self.act = graph.and(act, is_it);
            if self.act != Lit::FALSE {
                self.instr(at, instr);
            }
        }
        self.act = act;
    }
}
