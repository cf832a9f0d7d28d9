//! How many blocks a program has when the bodies of its user-defined blocks are compiled in place: counted before any is, for
//! blocks inside blocks multiply.

use super::user_block::DEEPEST;
use super::{Result, too_large};
use crate::places::networks_of_bodies;
use ladder_analysis::program::{Block, BlockKind, Program};

/// More blocks than this in bodies are refused: code for them takes some hundred MB.
const MOST_BLOCKS: u64 = 1 << 20;

/// Refuses a program whose bodies hold more blocks than the simulator has memory for.
pub(super) fn check(program: &Program) -> Result<()> {
    let mut known = vec![None; program.blocks.len()];
    let mut all = 0_u64;
    let outside = program
        .networks
        .iter()
        .zip(networks_of_bodies(program))
        .filter(|(_, is_body)| !is_body);
    for block in outside.flat_map(|(network, _)| &network.blocks) {
        all = all.saturating_add(in_body_of(block, program, &mut known, 0));
        if all > MOST_BLOCKS {
            return Err(too_large(block.location));
        }
    }
    Ok(())
}

/// How many blocks the body of a block has, with those in the bodies of these. One that is nested too deep has none: it is refused
/// when it is compiled.
fn in_body_of(block: &Block, program: &Program, known: &mut [Option<u64>], depth: usize) -> u64 {
    let BlockKind::User(index) = block.kind else {
        return 0;
    };
    if let Some(count) = known[index] {
        return count;
    }
    if depth > DEEPEST {
        return 0;
    }
    let networks = &program.networks[program.blocks[index].networks.clone()];
    let count = networks
        .iter()
        .flat_map(|network| &network.blocks)
        .fold(0, |count: u64, inner| {
            let inside = in_body_of(inner, program, known, depth + 1);
            count.saturating_add(inside).saturating_add(1)
        });
    known[index] = Some(count);
    count
}
