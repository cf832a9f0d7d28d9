//! Blocks of program flow: refactorings that move rungs keep away from them.

use ladder_analysis::context::{Body, Context};
use ladder_analysis::networks::network::BoundBlock;
use ladder_instructions::{Op, Shape};

/// Whether a block only marks a place: a label, or where a function begins.
pub(crate) fn is_mark(block: &BoundBlock) -> bool {
    matches!(block.op(), Some(Op::Lbl | Op::Fun))
}

/// Whether a block leaves its network, or calls, and does nothing else: it does the same in another network as long as
/// what it leaves behind is the same.
pub(crate) fn leaves(block: &BoundBlock) -> bool {
    matches!(block.op(), Some(Op::Jmp | Op::Ret | Op::Call | Op::End))
}

/// Whether a block is one of program flow: the instructions, and user-defined ones of their shape.
pub(crate) fn is_flow(block: &BoundBlock) -> bool {
    block.facts.shape == Shape::Function
}

/// Whether an `<MCR>` in a body may take the power from its left rails.
pub(crate) fn has_mcr(context: &Context, body: Body) -> bool {
    let networks = context.networks.iter().zip(context.bodies.iter());
    networks
        .filter(|(_, of)| **of == body)
        .any(|(network, _)| network.blocks().any(|block| block.op() == Some(Op::Mcr)))
}
