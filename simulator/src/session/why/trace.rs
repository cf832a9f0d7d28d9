//! One scan again: the last write of a tag, and the powers around it. The scan runs through but for the networks that
//! may write the tag: there it halts in front of each block and after it.

use super::place;
use super::reasons::{self, Blocker};
use super::writers::Writers;
use crate::code::{Code, stop};
use crate::machine::Until;
use crate::memory::Bit;
use crate::places::BlockAt;
use crate::simulation::{Simulation, Stepped};
use crate::tags::Point;
use ladder_analysis::program::{Block, BlockKind, Network, Step};
use ladder_analysis::values::value::Value;
use ladder_instructions::{Acts, Coil, Group, Op, Power};
use std::collections::HashMap;

/// How far a scan is run again.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Limit {
    /// To its end.
    End,
    /// Up to where a scan was: the instruction that came next, and how many blocks it might still evaluate, which tells
    /// the rounds of a loop apart.
    Position { pc: u32, budget: u64 },
}

impl Limit {
    /// Where a simulation is in its scan.
    pub(super) fn of(simulation: &Simulation) -> Limit {
        let open = simulation.machine.open_scan();
        Limit::Position {
            pc: open.pc(),
            budget: open.budget(),
        }
    }
}

/// A write that was found.
#[derive(Debug)]
pub(super) struct Traced {
    pub(super) at: BlockAt,
    /// The step that is its EN, and whether that was high.
    pub(super) en: usize,
    pub(super) power: bool,
    /// The power of each step of the network.
    pub(super) powers: Vec<bool>,
    /// Of each contact whether it would pass power on.
    pub(super) conducts: HashMap<usize, bool>,
    /// What blocks of the network read, with the values that they left behind.
    pub(super) values: HashMap<usize, Vec<(Point, Value)>>,
    /// Where the scan was after them.
    pub(super) positions: HashMap<usize, Limit>,
}

impl Traced {
    /// With power the blocks that it came through; without it what is missing, in each way.
    pub(super) fn ways(&self, network: &Network) -> Vec<Vec<Blocker>> {
        if self.power {
            vec![reasons::passed(network, self.en, &self.powers)]
        } else {
            reasons::missing(network, self.en, &self.powers, &self.conducts)
        }
    }
}

/// A block that is about to run.
struct Next {
    at: BlockAt,
    /// What the point in question held, if the block may write it.
    before: Option<Value>,
}

/// Runs the scan at whose start a simulation is, up to a limit; the last write of the point in it.
pub(super) fn last_write(
    simulation: &mut Simulation,
    writers: &Writers,
    blocks: &[BlockAt],
    point: &Point,
    limit: Limit,
) -> Option<Traced> {
    let mut last = None;
    let found = &mut |_: &Simulation, traced, has_written| {
        if has_written {
            last = Some(traced);
        }
    };
    let halts = Halts::of(simulation, blocks, limit);
    let asked = Asked {
        writers,
        blocks,
        point,
        limit,
    };
    run(simulation, halts, &asked, &mut |_, _| {}, found);
    last
}

/// Runs a whole scan, with a halt at these instructions as well; every block that may write the point, and whether it did.
pub(super) fn all_writes(
    simulation: &mut Simulation,
    writers: &Writers,
    (blocks, point): (&[BlockAt], &Point),
    also: &[u32],
    halted: &mut dyn FnMut(&mut Simulation, u32),
    found: &mut dyn FnMut(&Simulation, Traced, bool),
) {
    let mut halts = Halts::of(simulation, blocks, Limit::End);
    halts.all.extend(also);
    let asked = Asked {
        writers,
        blocks,
        point,
        limit: Limit::End,
    };
    run(simulation, halts, &asked, halted, found);
}

/// Whose writes are looked for in a scan, and how far.
struct Asked<'a> {
    writers: &'a Writers,
    blocks: &'a [BlockAt],
    point: &'a Point,
    limit: Limit,
}

fn run(
    simulation: &mut Simulation,
    halts: Halts,
    &Asked {
        writers,
        blocks,
        point,
        limit,
    }: &Asked<'_>,
    halted: &mut dyn FnMut(&mut Simulation, u32),
    found: &mut dyn FnMut(&Simulation, Traced, bool),
) {
    halts.mark(&mut simulation.compiled.code, true);
    let mut next: Option<Next> = None;
    let mut seen = Seen::default();
    simulation.begin_scan();
    while Limit::of(simulation) != limit {
        let stepped = simulation.step(Until::Marked);
        if let Some(ran) = next.take() {
            let position = match stepped {
                Stepped::At(_) => Limit::of(simulation),
                _ => Limit::End,
            };
            seen.look_after(simulation, ran.at, position);
            if let Some(before) = ran.before {
                let traced = seen.traced(simulation, writers, ran.at);
                let has_written = has_written(simulation, point, (ran.at, before), traced.power);
                found(simulation, traced, has_written);
            }
        }
        let Stepped::At(_) = stepped else { break };
        let pc = simulation.machine.open_scan().pc();
        halted(simulation, pc);
        let Some(&at) = halts.blocks.get(&pc) else {
            continue;
        };
        seen.look_before(simulation, at);
        let is_writer = blocks.contains(&at);
        next = Some(Next {
            at,
            before: is_writer.then(|| simulation.value(point)),
        });
    }
    halts.mark(&mut simulation.compiled.code, false);
}

/// Where the scan halts.
struct Halts {
    /// The first instruction of each block of the networks in question.
    blocks: HashMap<u32, BlockAt>,
    /// All instructions to halt at.
    all: Vec<u32>,
}

impl Halts {
    fn of(simulation: &Simulation, writers: &[BlockAt], limit: Limit) -> Halts {
        let compiled = &simulation.compiled;
        let mut halts = Halts {
            blocks: HashMap::new(),
            all: Vec::new(),
        };
        if let Limit::Position { pc, .. } = limit {
            halts.all.push(pc);
        }
        let mut networks: Vec<usize> = writers.iter().map(|at| at.network).collect();
        networks.dedup();
        for network in networks {
            let blocks = &simulation.program().networks[network].blocks;
            let stretch = &compiled.stretches[network];
            let first = compiled
                .code
                .blocks
                .partition_point(|place| place.start < stretch.start);
            let places = compiled.code.blocks[first..].iter();
            for place in places.take_while(|place| place.start < stretch.end) {
                if place.start == place.end {
                    continue;
                }
                // Those of bodies in between are not drawn here.
                let drawn = blocks.iter().position(|block| block.location == place.location);
                if let Some(block) = drawn {
                    halts.blocks.insert(place.start, BlockAt { network, block });
                    halts.all.extend([place.start, place.end]);
                }
            }
        }
        halts
    }

    fn mark(&self, code: &mut Code, on: bool) {
        for &pc in &self.all {
            // The last block of a program has nothing after it.
            if let Some(stops) = code.stops.get_mut(pc as usize) {
                *stops = if on {
                    *stops | stop::MARK
                } else {
                    *stops & !stop::MARK
                };
            }
        }
    }
}

fn has_written(simulation: &Simulation, point: &Point, (at, before): (BlockAt, Value), power: bool) -> bool {
    let block = &simulation.program().networks[at.network].blocks[at.block];
    if simulation.value(point) != before {
        return true;
    }
    let acts = match block.kind {
        BlockKind::User(_) => true,
        BlockKind::Instruction(row) => match row.coil {
            Some(Coil::Sets | Coil::Resets) => power,
            _ if row.op == Op::Res => power,
            _ => row.acts == Acts::Always || power,
        },
    };
    acts && writes_all_of(simulation, point, block)
}

/// Whether a block writes just this point whenever it writes: not perhaps another element or bit of the tag.
fn writes_all_of(simulation: &Simulation, point: &Point, block: &Block) -> bool {
    block.arguments.iter().any(|bound| {
        let names = place::written_name(simulation, &bound.argument);
        names.is_some_and(|name| {
            let whole = point.name.strip_prefix(&name);
            whole.is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
        })
    })
}

/// What was seen of the networks with writers.
#[derive(Default)]
struct Seen {
    networks: HashMap<usize, SeenNetwork>,
}

#[derive(Default)]
struct SeenNetwork {
    conducts: HashMap<usize, bool>,
    values: HashMap<usize, Vec<(Point, Value)>>,
    positions: HashMap<usize, Limit>,
    slots: Vec<Bit>,
}

impl Seen {
    /// A block that is about to run reads its operands.
    fn look_before(&mut self, simulation: &Simulation, at: BlockAt) {
        let seen = self.networks.entry(at.network).or_default();
        let key = at.block;
        let this = &simulation.program().networks[at.network].blocks[at.block];
        let values = place::values_read(simulation, this);
        if let BlockKind::Instruction(row) = this.kind {
            let value = match values.as_slice() {
                [(_, Value::Bool(high))] => Some(*high),
                _ => None,
            };
            match (row.power, value) {
                (Power::Level { high: wanted }, Some(high)) => seen.conducts.insert(key, high == wanted),
                _ if row.group == Group::State => seen.conducts.insert(key, false),
                _ => seen.conducts.remove(&key),
            };
        }
        seen.values.insert(key, values);
    }

    /// A block has run: what it read is told as it is now, since a timer passes power on for what it has come to, not
    /// for what it was. Which element of an array it was has been settled before: the block may write the index too.
    fn look_after(&mut self, simulation: &Simulation, at: BlockAt, position: Limit) {
        let seen = self.networks.entry(at.network).or_default();
        for (point, value) in seen.values.entry(at.block).or_default() {
            *value = simulation.value(point);
        }
        seen.positions.insert(at.block, position);
    }

    /// The powers of the network of a block that has run.
    fn traced(&mut self, simulation: &Simulation, writers: &Writers, at: BlockAt) -> Traced {
        let network = &simulation.program().networks[at.network];
        let seen = self.networks.entry(at.network).or_default();
        if seen.slots.is_empty() {
            seen.slots = place::slots(simulation, at.network, writers.elements(at.network));
        }
        let powers: Vec<bool> = seen
            .slots
            .iter()
            .map(|&slot| simulation.machine.memory.bit(slot))
            .collect();
        let en = en_of(network, at.block).unwrap_or_default();
        Traced {
            at,
            en,
            power: powers.get(en).copied().unwrap_or_default(),
            powers,
            conducts: seen.conducts.clone(),
            values: seen.values.clone(),
            positions: seen.positions.clone(),
        }
    }
}

/// The step whose power is a block's EN.
pub(super) fn en_of(network: &Network, block: usize) -> Option<usize> {
    network.steps.iter().find_map(|step| match *step {
        Step::Block { block: this, en } if this == block => Some(en),
        _ => None,
    })
}
