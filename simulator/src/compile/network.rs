//! One network, step by step: where power begins, where wires meet, and the blocks between.

use super::{Compiler, MOST_INSTRUCTIONS, Result, flow, too_large};
use crate::code::{BlockPlace, ElementPlace, Instr, NetworkPlace};
use crate::memory::Bit;
use crate::places::BlockAt;
use ladder_analysis::program::{Block, BlockKind, Location, Step};
use ladder_instructions::{Op, Relay};

impl Compiler<'_> {
    /// One network: its steps in their order.
    pub(super) fn network(&mut self, index: usize) -> Result<()> {
        let program = self.program;
        let network = &program.networks[index];
        let outer_semantics = std::mem::replace(&mut self.semantics, program.semantics(network.location));
        let start = self.here();
        self.code.networks.push(NetworkPlace {
            start,
            network: index as u32,
        });
        if self.skippable[index] {
            let network = self.noted(self.regions.len() - 1);
            self.emit(Instr::Network { network });
        }
        self.at_any_time();
        let lights_itself = self.semantics.relay == Relay::Power && flow::holds(network, Op::Mcr);
        let outer = std::mem::take(&mut self.powers);
        let mut ends = Vec::with_capacity(network.steps.len());
        for (number, &step) in network.steps.iter().enumerate() {
            self.step = number;
            let power = match step {
                Step::Start { rail: false } => Bit::LOW,
                Step::Start { rail: true } => self.rail(lights_itself),
                Step::Join { upper, lower } => self.join(self.powers[upper], self.powers[lower]),
                Step::Block { block, en } => {
                    self.standing.push(BlockAt {
                        network: index,
                        block,
                    });
                    let power = self.block(&network.blocks[block], self.powers[en])?;
                    self.standing.pop();
                    power
                }
            };
            self.powers.push(power);
            ends.push(self.here());
        }
        self.elements
            .extend(network.elements.iter().map(|element| ElementPlace {
                kind: element.kind,
                location: Location {
                    file: network.location.file,
                    range: element.range,
                },
                power: self.powers[element.step],
                network: index as u32,
                step: element.step as u32,
                at: ends[element.step],
            }));
        if self.stretches[index].is_empty() {
            self.stretches[index] = start..self.here();
        }
        self.powers = outer;
        self.semantics = outer_semantics;
        if self.layout.is_too_large() || self.code.instrs.len() > MOST_INSTRUCTIONS {
            return Err(too_large(network.location));
        }
        Ok(())
    }

    /// The left rail of a network. One that holds an `<MCR>` always has a live rail.
    fn rail(&mut self, lights_itself: bool) -> Bit {
        if !self.region().has_mcr || lights_itself {
            return Bit::HIGH;
        }
        let out = self.layout.bit();
        self.emit(Instr::Rail { out });
        out
    }

    fn join(&mut self, upper: Bit, lower: Bit) -> Bit {
        match (upper, lower) {
            (Bit::LOW, one) | (one, Bit::LOW) => one,
            (Bit::HIGH, _) | (_, Bit::HIGH) => Bit::HIGH,
            _ if upper == lower => upper,
            _ => {
                let out = self.layout.bit();
                self.emit(Instr::Join { out, upper, lower });
                out
            }
        }
    }

    /// One block; gives its ENO.
    fn block(&mut self, block: &Block, en: Bit) -> Result<Bit> {
        self.placed(block, en, |compiler| match block.kind {
            BlockKind::Instruction(row) => compiler.instruction(row, block, en),
            BlockKind::User(index) => compiler.user_block(index, block, en),
        })
    }

    /// Code of a block, noted as such.
    pub(super) fn placed(
        &mut self,
        block: &Block,
        en: Bit,
        code: impl FnOnce(&mut Self) -> Result<Bit>,
    ) -> Result<Bit> {
        let number = self.code.blocks.len();
        let outer = std::mem::replace(&mut self.outer, number as u32);
        self.code.blocks.push(BlockPlace {
            start: self.here(),
            end: self.here(),
            outer,
            work_through: 0,
            out: en,
            location: block.location,
            controller: self.semantics.controller,
            is_of_plant: self.plant.is_some(),
        });
        let out = code(self)?;
        self.outer = outer;
        let end = self.here();
        let place = &mut self.code.blocks[number];
        (place.end, place.out) = (end, out);
        Ok(out)
    }
}
