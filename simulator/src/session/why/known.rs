//! Which powers of a moment are known: what was not given leaves open what it decides, and so does what was before, of which an edge
//! comes.

use super::moment::Moment;
use super::place;
use super::reasons;
use crate::simulation::Scope;
use crate::tags::Point;
use ladder_analysis::program::{Block, BlockKind, Network, Step};
use ladder_analysis::values::value::Value;
use ladder_instructions::{Edge, Group, Op, Power};
use std::collections::{BTreeMap, HashSet};

/// What leaves powers open, by network.
#[derive(Debug, Default)]
pub(super) struct Open {
    /// The names of what was given when it was found out.
    given: Option<HashSet<String>>,
    networks: BTreeMap<usize, Causes>,
}

#[derive(Debug, Default)]
struct Causes {
    /// The blocks that read what was not given.
    unread: Vec<usize>,
    /// Whether any of them looks for an edge.
    has_edges: bool,
}

impl Moment {
    /// The networks outside of bodies that read what was not given, but constants and what the system keeps.
    pub(crate) fn open_networks(&mut self) -> Vec<usize> {
        self.find_open();
        let networks = self.open.networks.iter();
        let unread = networks.filter(|(_, causes)| !causes.unread.is_empty());
        unread.map(|(network, _)| *network).collect()
    }

    /// Of each part of the drawing, in the order of [`Simulation::power`](crate::Simulation::power), whether its power is not known.
    pub(crate) fn open_elements(&mut self) -> Vec<bool> {
        self.find_open();
        let mut open = vec![false; self.simulation.elements().len()];
        let program = self.simulation.program();
        for (&network, causes) in &self.open.networks {
            let drawn = &program.networks[network];
            let slots = self.writers.slots(&self.simulation, network);
            let memory = &self.simulation.machine.memory;
            let powers: Vec<bool> = slots.into_iter().map(|slot| memory.bit(slot)).collect();
            let levels: Vec<Option<bool>> = drawn.blocks.iter().map(|block| self.level(block)).collect();
            let is_open = |block: usize, en: Option<bool>| {
                causes.unread.contains(&block) || hides_its_past(&drawn.blocks[block], en, levels[block])
            };
            let conducts = |block: usize| conducts(&drawn.blocks[block], levels[block]);
            let known = known(drawn, &powers, &is_open, &conducts);
            let first = self.writers.first_element(network);
            for (index, element) in drawn.elements.iter().enumerate() {
                open[first + index] = known[element.step].is_none();
            }
        }
        open
    }

    /// Finds what leaves powers open, unless that is known of the same names.
    fn find_open(&mut self) {
        if self.open.given.as_ref() == Some(&self.names) {
            return;
        }
        let simulation = &self.simulation;
        let scope = Scope::default();
        let is_open =
            |(point, _): &(Point, Value)| !point.is_constant() && !point.is_system() && !self.is_given(point);
        let causes = |network: &usize| {
            let blocks = simulation.program().networks[*network].blocks.iter();
            let reads_open =
                |block: &Block| place::values_read(simulation, &scope, block).iter().any(is_open);
            let causes = Causes {
                unread: blocks
                    .clone()
                    .enumerate()
                    .filter(|(_, block)| reads_open(block))
                    .map(|(number, _)| number)
                    .collect(),
                has_edges: blocks.clone().any(|block| edge_of(block).is_some()),
            };
            (causes.has_edges || !causes.unread.is_empty()).then_some((*network, causes))
        };
        let networks = self
            .networks_outside_of_bodies()
            .filter_map(|network| causes(&network));
        self.open = Open {
            networks: networks.collect(),
            given: Some(self.names.clone()),
        };
    }

    /// What a contact reads.
    fn level(&self, block: &Block) -> Option<bool> {
        let BlockKind::Instruction(row) = block.kind else {
            return None;
        };
        if !row.power.is_contact() {
            return None;
        }
        match place::values_read(&self.simulation, &Scope::default(), block).as_slice() {
            [(_, Value::Bool(high))] => Some(*high),
            _ => None,
        }
    }
}

/// What a block passes on only when it comes, if it does so.
fn edge_of(block: &Block) -> Option<Edge> {
    match block.kind {
        BlockKind::Instruction(row) => match row.power {
            Power::TagEdge(edge) | Power::EnEdge(edge) => Some(edge),
            _ => None,
        },
        BlockKind::User(_) => None,
    }
}

/// Whether what was before decides what leaves a block: it has the level that its edge leads to.
fn hides_its_past(block: &Block, en: Option<bool>, level: Option<bool>) -> bool {
    let Some(edge) = edge_of(block) else { return false };
    let of_tag = matches!(block.kind, BlockKind::Instruction(row) if row.power.is_contact());
    let before = edge == Edge::Falling;
    (if of_tag { level } else { en }) != Some(before)
}

/// Whether a contact would pass power on, if that is known without it.
fn conducts(block: &Block, level: Option<bool>) -> Option<bool> {
    match block.kind {
        BlockKind::Instruction(row) => match row.power {
            Power::Level { high } => level.map(|level| level == high),
            _ => None,
        },
        BlockKind::User(_) => None,
    }
}

/// The powers of a network's steps that are certain, whatever the blocks do that are open: a block may be, by the power that comes to
/// it. `conducts` says of a block whether it would pass power on.
pub(super) fn known(
    network: &Network,
    powers: &[bool],
    is_open: &dyn Fn(usize, Option<bool>) -> bool,
    conducts: &dyn Fn(usize) -> Option<bool>,
) -> Vec<Option<bool>> {
    let mut known: Vec<Option<bool>> = Vec::with_capacity(network.steps.len());
    for (at, step) in network.steps.iter().enumerate() {
        let power = powers[at];
        known.push(match *step {
            Step::Start { .. } => Some(power),
            Step::Join { upper, lower } => match (known[upper], known[lower]) {
                (Some(true), _) | (_, Some(true)) => Some(true),
                (Some(false), Some(false)) => Some(false),
                _ => None,
            },
            Step::Block { block, en } => {
                let is_open = is_open(block, known[en]);
                let needs_power = match network.blocks[block].kind {
                    BlockKind::Instruction(row) => {
                        row.op == Op::Ton
                            || (row.group == Group::Condition && row.power != Power::EnEdge(Edge::Falling))
                    }
                    BlockKind::User(_) => false,
                };
                match known[en] {
                    Some(_) if !is_open => Some(power),
                    Some(false) if needs_power && !reasons::inverts(network, block) => Some(false),
                    None if !is_open && conducts(block) == Some(false) && needs_power => Some(false),
                    _ => None,
                }
            }
        });
    }
    known
}
