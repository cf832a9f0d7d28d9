//! Plants (LANGUAGE §9): what runs before the main program in each scan, with or without power of the controller.

use super::flow::Kind;
use super::{Compiler, Result};
use crate::code::Instr;
use crate::memory::{Bit, Memory};
use crate::system::System;
use ladder_analysis::program::{BlockKind, Network, Program};
use ladder_instructions::Op;
use std::ops::Range;

/// The cells that were laid out while a plant was compiled, beside those of its tags.
#[derive(Debug, Clone)]
pub(crate) struct Laid {
    pub(crate) bits: Range<usize>,
    pub(crate) words: Range<usize>,
    pub(crate) texts: Range<usize>,
}

/// What plants have of their own in memory.
#[derive(Debug)]
pub(crate) struct PlantCells {
    /// Their system tags.
    pub(crate) system: System,
    /// What their networks remember.
    pub(crate) laid: Vec<Laid>,
}

/// How far memory was laid out.
#[derive(Clone, Copy)]
struct Mark(usize, usize, usize);

impl Mark {
    fn of(memory: &Memory) -> Mark {
        Mark(memory.bits.len(), memory.words.len(), memory.texts.len())
    }

    fn until(self, memory: &Memory) -> Laid {
        let end = Mark::of(memory);
        Laid {
            bits: self.0..end.0,
            words: self.1..end.1,
            texts: self.2..end.2,
        }
    }
}

impl Compiler<'_> {
    /// What runs before the main program: the networks that hand values over and call the plants. Without power the scan ends
    /// after them.
    pub(super) fn plants(&mut self) -> Result<()> {
        let program = self.program;
        if program.plants.is_empty() {
            return Ok(());
        }
        let start = Mark::of(&self.layout.memory);
        self.ended = (program.plants.iter())
            .map(|plant| {
                ends(program, plant.file).then(|| {
                    let bit = self.layout.bit();
                    self.layout.keep(bit);
                    bit
                })
            })
            .collect();
        let system = System::new(&mut self.layout);
        let off = self.layout.bit();
        self.emit(Instr::NotBit {
            to: off,
            a: Bit::POWER,
        });
        let (step, network) = (0, program.networks.len() as u32);
        // What the plants see of a controller without power was written when it lost it.
        let wiring = program.wiring.clone();
        let is_call = |network: &Network| matches!(network.blocks[0].kind, BlockKind::Instruction(row) if row.op == Op::Call);
        let inputs = program.networks[wiring.clone()]
            .iter()
            .take_while(|network| !is_call(network));
        let calls = wiring.start + inputs.count();
        let at = self.here();
        self.emit(Instr::Jump {
            en: off,
            to: 0,
            step,
            network,
        });
        self.stretch(wiring.start..calls, Kind::Main)?;
        let after = self.here();
        if let Instr::Jump { to, .. } = &mut self.code.instrs[at as usize] {
            *to = after;
        }
        self.stretch(calls..wiring.end, Kind::Main)?;
        self.plant_cells = Some(PlantCells {
            system,
            laid: vec![start.until(&self.layout.memory)],
        });
        self.emit(Instr::Return {
            en: off,
            step,
            network,
        });
        self.code.main = self.here();
        Ok(())
    }

    /// Compiles a function, which may be one of a plant.
    pub(super) fn compile_function(&mut self, index: usize) -> Result<()> {
        let program = self.program;
        let function = &program.functions[index];
        let file = program
            .networks
            .get(function.networks.start)
            .map(|first| first.location.file);
        self.plant = program.plants.iter().position(|plant| Some(plant.file) == file);
        let Some(cells) = self.plant_cells.as_ref().filter(|_| self.plant.is_some()) else {
            return self.stretch(function.networks.clone(), Kind::Function(index));
        };
        let outer = std::mem::replace(&mut self.system, cells.system);
        let start = Mark::of(&self.layout.memory);
        self.stretch(function.networks.clone(), Kind::Function(index))?;
        let laid = start.until(&self.layout.memory);
        if let Some(cells) = &mut self.plant_cells {
            cells.laid.push(laid);
        }
        (self.system, self.plant) = (outer, None);
        Ok(())
    }

    /// Whether a plant that is called has not ended: the power with which that is done.
    pub(super) fn unless_ended(&mut self, function: usize, en: Bit) -> Bit {
        let plants = &self.program.plants;
        let plant = plants.iter().position(|plant| plant.function == function);
        let Some(ended) = plant.and_then(|plant| self.ended[plant]) else {
            return en;
        };
        let out = self.layout.bit();
        self.emit(Instr::NotBit { to: out, a: ended });
        out
    }

    /// What notes that the plant has ended that is being compiled.
    pub(super) fn plant_ended(&self) -> Option<Bit> {
        self.plant.and_then(|plant| self.ended[plant])
    }
}

/// Whether a program in this file may end itself.
fn ends(program: &Program, file: u32) -> bool {
    let networks = program
        .networks
        .iter()
        .filter(|network| network.location.file == file);
    let mut blocks = networks.flat_map(|network| &network.blocks);
    blocks.any(|block| matches!(block.kind, BlockKind::Instruction(row) if row.op == Op::End))
}
