//! What a scan has open where it is: the main program, functions that were called, bodies of user-defined blocks.

use super::{Simulation, Status};
use crate::places::BlockAt;
use ladder_analysis::program::{BlockKind, Location};
use std::collections::HashMap;

/// A part of a program that runs as a whole.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Routine {
    /// The main program.
    Main,
    /// A function: index into [`Program::functions`](ladder_analysis::program::Program::functions).
    Function(usize),
    /// The body of a user-defined block: index into [`Program::blocks`](ladder_analysis::program::Program::blocks).
    Block(usize),
}

/// One of the routines that are open.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Activation {
    /// The routine.
    pub routine: Routine,
    /// The network in which it is, by its number in the program.
    pub network: usize,
    /// The block that runs next there, or through which the routine within was entered; the network if no block of it
    /// is left.
    pub location: Location,
    /// Of a body the place that it runs for: index into [`Simulation::instances`].
    pub instance: Option<usize>,
}

/// Where the code of bodies is, and what blocks are at places of the text.
#[derive(Debug)]
pub(crate) struct Bodies {
    /// User-defined blocks with their code, in the order of that.
    all: Vec<Body>,
    blocks: HashMap<Location, BlockAt>,
    instances: HashMap<Vec<BlockAt>, usize>,
}

#[derive(Debug)]
struct Body {
    start: u32,
    end: u32,
    block: BlockAt,
}

impl Simulation {
    /// What the scan that is open has open, the innermost routine first; likewise of the scan in which a fault has stopped
    /// the program. Empty between two scans.
    pub fn activations(&self) -> Vec<Activation> {
        if !self.open && self.status != Status::Faulted {
            return Vec::new();
        }
        let mut found = Vec::new();
        for (depth, pc) in self.machine.open_scan().activations().enumerate() {
            self.activations_at(pc, depth == 0, &mut found);
        }
        found
    }

    /// How many blocks the scan that is open has evaluated, as the watchdog counts them: it only grows until the scan ends,
    /// and is the same whenever the scan is run again.
    pub fn blocks_done(&self) -> u64 {
        let budget = self.machine.open_scan().budget();
        self.options.watchdog.saturating_sub(budget)
    }

    /// The block that is drawn at a place of the text.
    pub(crate) fn block_at(&self, location: Location) -> Option<BlockAt> {
        let bodies = self.bodies.get_or_init(|| self.find_bodies());
        bodies.blocks.get(&location).copied()
    }

    fn activations_at(&self, pc: u32, innermost: bool, found: &mut Vec<Activation>) {
        let bodies = self.bodies.get_or_init(|| self.find_bodies());
        let around: Vec<&Body> = bodies
            .all
            .iter()
            .take_while(|body| body.start < pc)
            .filter(|body| pc < body.end)
            .collect();
        let path: Vec<BlockAt> = around.iter().map(|body| body.block).collect();
        let instance = |depth: usize| bodies.instances.get(&path[..depth]).copied();
        if let Some((network, location)) = self.standing_at(pc, innermost, bodies) {
            found.push(Activation {
                routine: self.routine_of(network),
                network,
                location,
                instance: instance(path.len()),
            });
        }
        for (depth, body) in around.iter().enumerate().rev() {
            let network = body.block.network;
            found.push(Activation {
                routine: self.routine_of(network),
                network,
                location: self.program.networks[network].blocks[body.block.block].location,
                instance: instance(depth),
            });
        }
    }

    /// The network and the block that an instruction belongs to; where the scan has halted there, those that run next.
    fn standing_at(&self, pc: u32, innermost: bool, bodies: &Bodies) -> Option<(usize, Location)> {
        let code = &self.compiled.code;
        let next = if innermost { code.block_from(pc) } else { None };
        if let Some(block) = next {
            return Some((bodies.blocks.get(&block.location)?.network, block.location));
        }
        if innermost && let Some(network) = code.networks_at(pc).last() {
            // Its first block, which is after what begins the network.
            let after = code.blocks.partition_point(|place| place.start < pc);
            let first = code.blocks[after..].iter().find(|place| place.start < place.end);
            let location = first.map(|place| place.location).filter(|location| {
                bodies
                    .blocks
                    .get(location)
                    .is_some_and(|at| at.network == network)
            });
            return Some((
                network,
                location.unwrap_or(self.program.networks[network].location),
            ));
        }
        // A block's code is after that of the blocks before it, and a body's is within its block's.
        let through = code.blocks.partition_point(|place| place.start <= pc);
        let around = code.blocks[..through].iter().rev().find(|place| pc < place.end)?;
        Some((bodies.blocks.get(&around.location)?.network, around.location))
    }

    fn routine_of(&self, network: usize) -> Routine {
        let program = &self.program;
        if let Some(block) = program
            .blocks
            .iter()
            .position(|block| block.networks.contains(&network))
        {
            return Routine::Block(block);
        }
        let function = program
            .functions
            .iter()
            .position(|function| function.networks.contains(&network));
        function.map_or(Routine::Main, Routine::Function)
    }

    fn find_bodies(&self) -> Bodies {
        let networks = self.program.networks.iter().enumerate();
        let blocks: HashMap<Location, BlockAt> = networks
            .flat_map(|(network, drawn)| {
                let blocks = drawn.blocks.iter().enumerate();
                blocks.map(move |(block, drawn)| (drawn.location, BlockAt { network, block }))
            })
            .collect();
        let is_user = |at: &BlockAt| {
            let kind = self.program.networks[at.network].blocks[at.block].kind;
            matches!(kind, BlockKind::User(_))
        };
        let places = self.compiled.code.blocks.iter();
        let all = places
            .filter_map(|place| {
                let block = *blocks.get(&place.location).filter(|at| is_user(at))?;
                Some(Body {
                    start: place.start,
                    end: place.end,
                    block,
                })
            })
            .collect();
        let instances = self.instances().iter().enumerate();
        Bodies {
            all,
            blocks,
            instances: instances
                .map(|(number, instance)| (instance.path.clone(), number))
                .collect(),
        }
    }
}
