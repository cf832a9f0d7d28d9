//! Which blocks may write which tag, outside the bodies of user-defined blocks.

use super::place;
use crate::places::BlockAt;
use crate::simulation::Simulation;
use ladder_analysis::program::{Block, BlockKind, ParameterKind, Program, TagId};
use ladder_instructions::Direction;
use std::collections::HashMap;
use std::ops::Range;

/// What is known of a program for all questions: made once.
#[derive(Debug)]
pub(in crate::session) struct Writers {
    of_tags: HashMap<TagId, Vec<BlockAt>>,
    /// Of each network its elements in the compiled program.
    elements: Vec<Range<usize>>,
}

impl Writers {
    pub(in crate::session) fn of(simulation: &Simulation) -> Writers {
        let program = simulation.program();
        let mut is_of_body = vec![false; program.networks.len()];
        for block in &program.blocks {
            is_of_body[block.networks.clone()].fill(true);
        }
        let mut of_tags: HashMap<TagId, Vec<BlockAt>> = HashMap::new();
        let networks = program.networks.iter().enumerate();
        for (number, network) in networks.filter(|(number, _)| !is_of_body[*number]) {
            for (index, block) in network.blocks.iter().enumerate() {
                let at = BlockAt {
                    network: number,
                    block: index,
                };
                for tag in written_by(program, block) {
                    let writers = of_tags.entry(tag).or_default();
                    if writers.last() != Some(&at) {
                        writers.push(at);
                    }
                }
            }
        }
        let mut elements = vec![0..0; program.networks.len()];
        for (index, element) in simulation.compiled.elements.iter().enumerate() {
            let range = &mut elements[element.network as usize];
            if range.end == 0 {
                range.start = index;
            }
            range.end = index + 1;
        }
        Writers { of_tags, elements }
    }

    /// The blocks that may write a tag.
    pub(super) fn of_tag(&self, tag: Option<TagId>) -> &[BlockAt] {
        tag.and_then(|tag| self.of_tags.get(&tag))
            .map_or(&[], Vec::as_slice)
    }

    /// The elements of a network, as indices into those of the compiled program.
    pub(super) fn elements(&self, network: usize) -> Range<usize> {
        self.elements[network].clone()
    }
}

/// The tags that a block may write.
fn written_by<'p>(program: &'p Program, block: &'p Block) -> impl Iterator<Item = TagId> + 'p {
    let written = block.arguments.iter().filter(|bound| match block.kind {
        BlockKind::Instruction(_) => bound
            .operand
            .is_some_and(|operand| operand.direction != Direction::In),
        BlockKind::User(user) => bound
            .parameter
            // Without a parameter it is the tag that has the block's state.
            .is_none_or(|parameter| program.blocks[user].parameters[parameter].1 != ParameterKind::Input),
    });
    written.flat_map(|bound| place::argument_tags(&bound.argument))
}
