//! One scan again, block by block: the last write of a tag, and the powers around it.

use super::{When, place};
use crate::machine::Until;
use crate::memory::Bit;
use crate::session::reach::Reach;
use crate::simulation::{Simulation, Stepped};
use crate::tags::Point;
use ladder_analysis::program::{Block, BlockKind, Location, ParameterKind, Step, TagId};
use ladder_analysis::value::Value;
use ladder_instructions::{Acts, Coil, Direction, Group, Op};
use std::collections::HashMap;

/// How far a scan is run again.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Limit {
    /// To its end.
    End,
    /// Up to so many blocks from its start.
    Blocks(usize),
    /// Up to where the scan that is open stands.
    Position { pc: u32, budget: u64 },
}

impl Limit {
    /// Where a simulation stands in its scan.
    pub(super) fn of(simulation: &Simulation) -> Limit {
        let open = simulation.machine.open_scan();
        Limit::Position {
            pc: open.pc(),
            budget: open.budget(),
        }
    }

    fn is_reached(self, simulation: &Simulation, blocks: usize) -> bool {
        match self {
            Limit::End => false,
            Limit::Blocks(most) => blocks >= most,
            Limit::Position { .. } => Limit::of(simulation) == self,
        }
    }
}

/// The blocks that may write a tag, outside the bodies of user-defined blocks.
#[derive(Debug)]
pub(super) struct Targets {
    /// Every block outside bodies: its network, its number there.
    all: HashMap<Location, (usize, usize)>,
    /// The tag.
    pub(super) tag: Option<TagId>,
    /// Those that may write it.
    writers: Vec<(usize, usize)>,
}

impl Targets {
    pub(super) fn of(simulation: &Simulation, point: &Point) -> Targets {
        let program = simulation.program();
        let tag = place::tag_of(simulation, point);
        let mut targets = Targets {
            all: HashMap::new(),
            tag,
            writers: Vec::new(),
        };
        for (number, network) in program.networks.iter().enumerate() {
            if program
                .blocks
                .iter()
                .any(|block| block.networks.contains(&number))
            {
                continue;
            }
            for (index, block) in network.blocks.iter().enumerate() {
                targets.all.insert(block.location, (number, index));
                let writes = block.arguments.iter().any(|bound| {
                    let written = match block.kind {
                        BlockKind::Instruction(_) => bound
                            .operand
                            .is_some_and(|operand| operand.direction != Direction::In),
                        BlockKind::User(user) => bound.parameter.is_some_and(|parameter| {
                            program.blocks[user].parameters[parameter].1 != ParameterKind::Input
                        }),
                    };
                    written && tag.is_some() && place::argument_tag(&bound.argument) == tag
                });
                if writes {
                    targets.writers.push((number, index));
                }
            }
        }
        targets
    }

    pub(super) fn is_empty(&self) -> bool {
        self.writers.is_empty()
    }
}

/// A write that was found.
#[derive(Debug)]
pub(super) struct Traced {
    pub(super) network: usize,
    pub(super) block: usize,
    /// The step that is its EN, and whether that was high.
    pub(super) en: usize,
    pub(super) power: bool,
    /// The power of each step of the network.
    pub(super) powers: Vec<bool>,
    /// Of each contact whether it would pass power on.
    pub(super) conducts: HashMap<usize, bool>,
    /// What blocks of the network looked at.
    pub(super) values: HashMap<usize, Vec<(Point, Value)>>,
    /// How many blocks had run before them.
    pub(super) counts: HashMap<usize, usize>,
}

impl Traced {
    /// When a block of the network was about to run.
    pub(super) fn moment(&self, block: usize, reach: Reach) -> When {
        When {
            reach,
            blocks: Limit::Blocks(self.counts.get(&block).copied().unwrap_or_default()),
        }
    }
}

/// A block that is about to run.
struct Next {
    network: usize,
    block: usize,
    before: Value,
}

/// Runs a scan up to a moment.
pub(super) fn run_up_to(simulation: &mut Simulation, limit: Limit) {
    let mut blocks = 0;
    simulation.begin_scan();
    while !limit.is_reached(simulation, blocks) {
        if !matches!(simulation.step(Until::BlockOrNetwork), Stepped::At(_)) {
            return;
        }
        blocks += 1;
    }
}

/// Runs a scan up to a moment; the last write of the point in it.
pub(super) fn last_write(
    simulation: &mut Simulation,
    targets: &Targets,
    point: &Point,
    limit: Limit,
) -> Option<Traced> {
    let mut found = None;
    let mut next: Option<Next> = None;
    let mut seen = Seen::default();
    let mut blocks = 0;
    simulation.begin_scan();
    while !limit.is_reached(simulation, blocks) {
        let stepped = simulation.step(Until::BlockOrNetwork);
        blocks += 1;
        let here = match stepped {
            Stepped::At(_) => simulation.next_block(),
            _ => None,
        };
        let known = here.and_then(|location| targets.all.get(&location).copied());
        // Inside a body the block that it belongs to is still running.
        if (known.is_some() || !matches!(stepped, Stepped::At(_)))
            && let Some(ran) = next.take()
        {
            let traced = seen.traced(simulation, &ran);
            if has_written(simulation, point, &ran, traced.power) {
                found = Some(traced);
            }
        }
        let Some((network, block)) = known else {
            if matches!(stepped, Stepped::At(_)) {
                continue;
            }
            break;
        };
        let concerned = targets.writers.iter().any(|&(writer, _)| writer == network);
        if concerned {
            seen.look(simulation, network, block, blocks);
        }
        if targets.writers.contains(&(network, block)) {
            next = Some(Next {
                network,
                block,
                before: simulation.value(point),
            });
        }
    }
    found
}

fn has_written(simulation: &Simulation, point: &Point, ran: &Next, power: bool) -> bool {
    let block = &simulation.program().networks[ran.network].blocks[ran.block];
    if simulation.value(point) != ran.before {
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
    conducts: HashMap<(usize, usize), bool>,
    values: HashMap<(usize, usize), Vec<(Point, Value)>>,
    counts: HashMap<(usize, usize), usize>,
    slots: HashMap<usize, Vec<Bit>>,
}

impl Seen {
    /// A block that is about to run looks at its operands.
    fn look(&mut self, simulation: &Simulation, network: usize, block: usize, count: usize) {
        let key = (network, block);
        let this = &simulation.program().networks[network].blocks[block];
        let values = place::values_read(simulation, this);
        if let BlockKind::Instruction(row) = this.kind {
            let value = match values.as_slice() {
                [(_, Value::Bool(high))] => Some(*high),
                _ => None,
            };
            match (row.op, value) {
                (Op::Contact, Some(high)) => self.conducts.insert(key, high),
                (Op::NegatedContact, Some(high)) => self.conducts.insert(key, !high),
                _ if row.group == Group::State => self.conducts.insert(key, false),
                _ => self.conducts.remove(&key),
            };
        }
        self.values.insert(key, values);
        self.counts.insert(key, count);
    }

    /// The powers of the network of a block that has run.
    fn traced(&mut self, simulation: &Simulation, ran: &Next) -> Traced {
        let network = &simulation.program().networks[ran.network];
        let slots = self
            .slots
            .entry(ran.network)
            .or_insert_with(|| place::slots(simulation, ran.network));
        let powers: Vec<bool> = slots
            .iter()
            .map(|&slot| simulation.machine.memory.bit(slot))
            .collect();
        let en = network.steps.iter().find_map(|step| match *step {
            Step::Block { block, en } if block == ran.block => Some(en),
            _ => None,
        });
        let en = en.unwrap_or_default();
        let of_network = |key: &(usize, usize)| key.0 == ran.network;
        Traced {
            network: ran.network,
            block: ran.block,
            en,
            power: powers.get(en).copied().unwrap_or_default(),
            powers,
            conducts: (self.conducts.iter().filter(|(key, _)| of_network(key)))
                .map(|(key, value)| (key.1, *value))
                .collect(),
            values: (self.values.iter().filter(|(key, _)| of_network(key)))
                .map(|(key, values)| (key.1, values.clone()))
                .collect(),
            counts: (self.counts.iter().filter(|(key, _)| of_network(key)))
                .map(|(key, count)| (key.1, *count))
                .collect(),
        }
    }
}
