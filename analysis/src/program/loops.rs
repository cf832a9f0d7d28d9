//! Which `<FOR>` and `<NEXT>` belong together (LANGUAGE §5.5).

use super::{BlockKind, Network, Program};
use ladder_instructions::Op;
use std::ops::Range;

/// How deep loops nest.
pub const DEEPEST_LOOP: usize = 8;

/// What a network of a body has of loops.
#[derive(Debug, Clone, Copy)]
pub struct LoopEnds {
    /// The network.
    pub network: usize,
    /// A loop begins after it.
    pub begins: bool,
    /// A loop ends with it. One that does both ends a loop before the other begins.
    pub ends: bool,
}

/// The loops of a body, given its networks from top to bottom: the network of each `<FOR>`, and that of its `<NEXT>`. They pair as
/// brackets do. In the order of the `<NEXT>`: what is in a loop comes before it.
pub fn loops(networks: impl IntoIterator<Item = LoopEnds>) -> Vec<(usize, usize)> {
    let (mut open, mut loops) = (Vec::new(), Vec::new());
    for LoopEnds {
        network,
        begins,
        ends,
    } in networks
    {
        if ends && let Some(first) = open.pop() {
            loops.push((first, network));
        }
        if begins {
            open.push(network);
        }
    }
    loops
}

impl Program {
    /// The loops of a stretch of networks: see [`loops`].
    pub fn loops(&self, networks: Range<usize>) -> Vec<(usize, usize)> {
        let holds = |network: &Network, op: Op| {
            let mut kinds = network.blocks.iter().map(|block| block.kind);
            kinds.any(|kind| matches!(kind, BlockKind::Instruction(row) if row.op == op))
        };
        loops(networks.map(|network| LoopEnds {
            network,
            begins: holds(&self.networks[network], Op::For),
            ends: holds(&self.networks[network], Op::Next),
        }))
    }
}
