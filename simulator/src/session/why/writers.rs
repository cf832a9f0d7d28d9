//! Which blocks outside of bodies may write which tag, themselves or in the bodies that they run; and where a network runs.

use super::{held::Held, place};
use crate::memory::Bit;
use crate::places::{BlockAt, networks_of_bodies};
use crate::simulation::Simulation;
use crate::tags::Point;
use ladder_analysis::program::{Argument, Block, BlockKind, ParameterKind, Program, Step, TagId};
use ladder_instructions::{Direction, Op};
use std::collections::HashMap;

/// What is known of a program for all questions: made once.
#[derive(Debug)]
pub(in crate::session) struct Writers {
    held: Held,
    of_tags: HashMap<TagId, Vec<BlockAt>>,
    /// Of each network its first instruction: in a body one for each place of the block.
    starts: Vec<Vec<u32>>,
    /// Of each network the first of its elements in the compiled program: those of the first place.
    elements: Vec<usize>,
    /// How many blocks call each function.
    calls: Vec<usize>,
}

impl Writers {
    pub(in crate::session) fn of(simulation: &Simulation) -> Writers {
        let program = simulation.program();
        let is_of_body = networks_of_bodies(program);
        let mut of_bodies = vec![None; program.blocks.len()];
        let mut of_tags: HashMap<TagId, Vec<BlockAt>> = HashMap::new();
        let mut calls = vec![0; program.functions.len()];
        for (network, drawn) in program.networks.iter().enumerate() {
            for (index, block) in drawn.blocks.iter().enumerate() {
                for called in called_by(block) {
                    calls[called] += 1;
                }
                if is_of_body[network] {
                    continue;
                }
                let at = BlockAt {
                    network,
                    block: index,
                };
                let mut written = written_by(program, block);
                if let BlockKind::User(user) = block.kind {
                    written.extend(written_in(program, user, &mut of_bodies));
                }
                for tag in written {
                    let writers = of_tags.entry(tag).or_default();
                    if writers.last() != Some(&at) {
                        writers.push(at);
                    }
                }
            }
        }
        let mut starts = vec![Vec::new(); program.networks.len()];
        for place in &simulation.compiled.code.networks {
            starts[place.network as usize].push(place.start);
        }
        let mut elements = vec![0; program.networks.len()];
        for (index, element) in simulation.compiled.elements.iter().enumerate().rev() {
            elements[element.network as usize] = index;
        }
        Writers {
            held: Held::of(&simulation.compiled.homes, program),
            of_tags,
            starts,
            elements,
            calls,
        }
    }

    /// The tag that a point is, or is a part of. None for system tags and ports.
    pub(super) fn tag_of(&self, point: &Point) -> Option<TagId> {
        self.held.tag_of(point)
    }

    /// The blocks outside of bodies that may write a tag.
    pub(super) fn of_tag(&self, tag: Option<TagId>) -> &[BlockAt] {
        tag.and_then(|tag| self.of_tags.get(&tag))
            .map_or(&[], Vec::as_slice)
    }

    /// The blocks outside of bodies that may write a point, themselves or in their bodies.
    pub(in crate::session) fn of_point(&self, simulation: &Simulation, point: &Point) -> Vec<BlockAt> {
        let mut blocks = self.of_tag(self.tag_of(point)).to_vec();
        blocks.extend(self.of_tag(self.held.holder_of(point)));
        if point.name.starts_with('$') {
            let mut instances = simulation.instances().iter();
            let holds = |name: &str| {
                point
                    .name
                    .strip_prefix(name)
                    .is_some_and(|rest| rest.starts_with('.'))
            };
            let instance = instances.find(|instance| holds(&instance.name));
            blocks.extend(instance.and_then(|instance| instance.path.first()));
        }
        blocks.sort_unstable();
        blocks.dedup();
        blocks
    }

    /// In which of the places where a network is an instruction of it is.
    pub(super) fn place_at(&self, network: usize, pc: u32) -> usize {
        self.starts[network]
            .partition_point(|start| *start <= pc)
            .saturating_sub(1)
    }

    /// The slot of each step's power in a network, in the first place where it is; where nothing is drawn there is no power.
    pub(super) fn slots(&self, simulation: &Simulation, network: usize) -> Vec<Bit> {
        let drawn = &simulation.program().networks[network];
        let start = |step: &Step| match step {
            Step::Start { rail: true } => Bit::HIGH,
            _ => Bit::LOW,
        };
        let mut slots: Vec<Bit> = drawn.steps.iter().map(start).collect();
        let elements = &simulation.compiled.elements[self.elements[network]..];
        for element in &elements[..drawn.elements.len()] {
            slots[element.step as usize] = element.power;
        }
        slots
    }

    /// The number of a network's first part among all of the drawing.
    pub(super) fn first_element(&self, network: usize) -> usize {
        self.elements[network]
    }

    /// Whether several blocks call a function.
    pub(super) fn is_called_from_several(&self, function: usize) -> bool {
        self.calls[function] > 1
    }
}

/// The functions that a block calls.
pub(super) fn called_by(block: &Block) -> impl Iterator<Item = usize> {
    let is_call = matches!(block.kind, BlockKind::Instruction(row) if row.op == Op::Call);
    let arguments = block.arguments.iter().filter(move |_| is_call);
    arguments.filter_map(|bound| match bound.argument {
        Argument::Function(function) => Some(function),
        _ => None,
    })
}

/// The tags that a block may write.
fn written_by(program: &Program, block: &Block) -> Vec<TagId> {
    let written = block.arguments.iter().filter(|bound| match block.kind {
        BlockKind::Instruction(_) => bound
            .operand
            .is_some_and(|operand| operand.direction != Direction::In),
        BlockKind::User(user) => bound
            .parameter
            // Without a parameter it is the tag that has the block's state.
            .is_none_or(|parameter| program.blocks[user].parameters[parameter].1 != ParameterKind::Input),
    });
    written
        .flat_map(|bound| place::argument_tags(&bound.argument))
        .collect()
}

/// The tags outside of bodies that the body of a block may write.
fn written_in(program: &Program, user: usize, known: &mut Vec<Option<Vec<TagId>>>) -> Vec<TagId> {
    if let Some(known) = &known[user] {
        return known.clone();
    }
    // A block never runs itself.
    known[user] = Some(Vec::new());
    let mut written = Vec::new();
    let networks = &program.networks[program.blocks[user].networks.clone()];
    for block in networks.iter().flat_map(|network| &network.blocks) {
        written.extend(written_by(program, block));
        if let BlockKind::User(inner) = block.kind {
            written.extend(written_in(program, inner, known));
        }
    }
    written.retain(|tag| program.tags[tag.0 as usize].block.is_none());
    written.sort_unstable();
    written.dedup();
    known[user] = Some(written.clone());
    written
}
