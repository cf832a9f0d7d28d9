//! Program flow (LANGUAGE §5.5): the main program, functions, jumps, calls, loops.

use super::arguments::Arguments;
use super::call_graph::Cycles;
use super::{Compiler, Result};
use crate::code::{Instr, NOTHING_SAVED};
use crate::memory::Bit;
use ladder_analysis::program::{Argument, BlockKind, Network, Program};
use ladder_instructions::Op;
use std::ops::Range;

/// A stretch of networks that jumps and loops do not leave: the main program, a function, a block's body.
#[derive(Debug)]
pub(super) struct Region {
    networks: Range<usize>,
    /// The function, if it is one.
    function: Option<usize>,
    /// Whether the rails can be switched off here.
    pub(super) has_mcr: bool,
    /// The first instruction of each network, and the one behind the last.
    starts: Vec<u32>,
    /// Jumps, to be aimed when all networks stand: instruction and network.
    jumps: Vec<(u32, usize)>,
    /// Loops likewise: the instruction that enters, the first network of the body, the network behind it.
    loops: Vec<(u32, usize, usize)>,
}

/// Whether a network holds a block of this instruction.
pub(super) fn holds(network: &Network, op: Op) -> bool {
    network.blocks.iter().any(|block| is(&block.kind, op))
}

/// Whether a block is this instruction.
pub(super) fn is(kind: &BlockKind, op: Op) -> bool {
    matches!(kind, BlockKind::Instruction(row) if row.op == op)
}

/// Whether any block of the program may be reached twice in one scan.
pub(super) fn may_repeat(program: &Program) -> bool {
    let mut called = vec![false; program.functions.len()];
    for (index, network) in program.networks.iter().enumerate() {
        for block in &network.blocks {
            let repeats = match &block.kind {
                BlockKind::Instruction(row) => {
                    match (row.op, block.arguments.first().map(|bound| &bound.argument)) {
                        (Op::For, _) => true,
                        (Op::Jmp, Some(Argument::Label(Some(target)))) => *target <= index,
                        (Op::Call, Some(Argument::Function(function))) => {
                            std::mem::replace(&mut called[*function], true)
                        }
                        _ => false,
                    }
                }
                BlockKind::User(_) => false,
            };
            if repeats {
                return true;
            }
        }
    }
    false
}

/// Whether what stands behind this network, or the rest of it, may not be reached in some scan.
fn may_leave(network: &Network) -> bool {
    network.blocks.iter().any(|block| match block.kind {
        BlockKind::Instruction(row) => {
            matches!(row.op, Op::Jmp | Op::Ret | Op::End | Op::For | Op::Call)
        }
        BlockKind::User(_) => true,
    })
}

impl Compiler<'_> {
    pub(super) fn region(&mut self) -> &mut Region {
        self.regions
            .last_mut()
            .expect("networks are compiled inside a region")
    }

    /// The main program, then every function.
    pub(super) fn regions(&mut self) -> Result<()> {
        let program = self.program;
        self.cycles = Cycles::of(program);
        let main = program.main.clone();
        if let Some(first) = main.clone().find(|&index| may_leave(&program.networks[index])) {
            self.skippable[first..main.end].fill(true);
        }
        self.stretch(main, None)?;
        for (index, function) in program.functions.iter().enumerate() {
            self.functions[index] = self.here();
            self.skippable[function.networks.clone()].fill(true);
            self.stretch(function.networks.clone(), Some(index))?;
        }
        Ok(())
    }

    fn stretch(&mut self, networks: Range<usize>, function: Option<usize>) -> Result<()> {
        let program = self.program;
        self.regions.push(Region {
            has_mcr: program.networks[networks.clone()]
                .iter()
                .any(|network| holds(network, Op::Mcr)),
            networks: networks.clone(),
            function,
            starts: Vec::with_capacity(networks.len() + 1),
            jumps: Vec::new(),
            loops: Vec::new(),
        });
        for index in networks {
            let start = self.here();
            self.region().starts.push(start);
            self.network(index)?;
            self.loop_ends(index);
        }
        let end = self.here();
        self.region().starts.push(end);
        self.emit(Instr::Finish);
        self.aim();
        Ok(())
    }

    /// What stands behind a network with `<NEXT>` or `<FOR>`. A network with both ends the one loop before it
    /// enters the other.
    fn loop_ends(&mut self, index: usize) {
        let program = self.program;
        let network = &program.networks[index];
        if holds(network, Op::Next) {
            self.emit(Instr::Again);
        }
        if holds(network, Op::For) {
            let end = self.region().networks.end;
            let mut behind = index + 1..end;
            // Without a <NEXT> the analysis has refused the program; the loop would reach to the end.
            let last = behind
                .find(|&at| holds(&program.networks[at], Op::Next))
                .unwrap_or(end - 1);
            let at = self.here();
            self.region().loops.push((at, index + 1, last + 1));
            self.emit(Instr::Enter { body: 0, behind: 0 });
        }
    }

    /// Aims the jumps and loops of the region that was compiled.
    fn aim(&mut self) {
        let Some(region) = self.regions.pop() else { return };
        let start = |network: usize| region.starts[network - region.networks.start];
        for &(at, network) in &region.jumps {
            if let Instr::Jump { to, .. } = &mut self.code.instrs[at as usize] {
                *to = start(network);
            }
        }
        for &(at, first, next) in &region.loops {
            self.code.instrs[at as usize] = Instr::Enter {
                body: start(first),
                behind: start(next),
            };
        }
    }

    /// The network that is being compiled.
    fn current_network(&mut self) -> usize {
        let region = self.region();
        region.networks.start + region.starts.len() - 1
    }

    /// `<JMP>`: no power passes it. With EN low there is none, with EN high it leaves.
    pub(super) fn jump(&mut self, arguments: Arguments, en: Bit) -> Result<Bit> {
        let Argument::Label(Some(target)) = *arguments.get(0)? else {
            return Err(arguments.mistaken());
        };
        let (at, network) = (self.here(), self.current_network());
        if !self.region().networks.contains(&target) {
            return Err(arguments.mistaken());
        }
        self.region().jumps.push((at, target));
        self.emit(Instr::Jump {
            en,
            to: 0,
            step: self.step as u32,
            network: network as u32,
        });
        Ok(Bit::LOW)
    }

    /// `<CALL>`: its power is EN, whatever the function does.
    pub(super) fn call(&mut self, arguments: Arguments, en: Bit) -> Result<Bit> {
        let Argument::Function(function) = *arguments.get(0)? else {
            return Err(arguments.mistaken());
        };
        let at = self.here();
        self.calls.push((at, function));
        let caller = self.region().function;
        let saved = match caller {
            // The call may come back to this network before it returns, and would overwrite its powers.
            Some(caller) if self.cycles.are_together(caller, function) => {
                let mut powers = self.powers.clone();
                powers.retain(|&power| power != Bit::LOW && power != Bit::HIGH);
                self.code.saved.push(powers);
                self.code.saved.len() as u32 - 1
            }
            _ => NOTHING_SAVED,
        };
        self.emit(Instr::Call { en, to: 0, saved });
        Ok(en)
    }

    /// `<RET>`
    pub(super) fn ret(&mut self, en: Bit) -> Bit {
        let network = self.current_network() as u32;
        self.emit(Instr::Return {
            en,
            step: self.step as u32,
            network,
        });
        Bit::LOW
    }

    /// `<END>`
    pub(super) fn end(&mut self, en: Bit) -> Bit {
        let network = self.current_network() as u32;
        self.emit(Instr::End {
            en,
            step: self.step as u32,
            network,
        });
        Bit::LOW
    }

    /// `<FOR>`: notes the turns; the loop is entered at the end of the network. With EN low the count is not read.
    pub(super) fn for_loop(&mut self, arguments: Arguments, en: Bit) -> Result<Bit> {
        // A slot of its own: reading the count may fault.
        let (out, start) = self.begin_powered(en);
        let turns = self.count(arguments.value(0)?)?;
        if self.code.instrs.len() == start + 1 {
            self.code.instrs.truncate(start);
            self.emit(Instr::For { en, turns });
            return Ok(en);
        }
        self.end_powered(start);
        // Behind the skip, so that a loop without power notes that it makes no turn. A fault passes this by, and
        // the loop before it left no turns.
        self.emit(Instr::For { en: out, turns });
        Ok(out)
    }

    /// `<MCR>`
    pub(super) fn mcr(&mut self, en: Bit) -> Bit {
        self.emit(Instr::Mcr { en });
        en
    }
}
