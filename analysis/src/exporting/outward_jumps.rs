//! Jumps out of the bodies of `<$B>` blocks, to labels around their places.

use crate::names::context::Context;
use ladder_instructions::{Op, Shape};
use ladder_syntax::{Name, TextRange};
use std::sync::Arc;

/// A jump in the body of a `<$B>` to a label that the body does not have.
#[derive(Clone)]
pub(crate) struct Jump {
    /// The block whose places must have the label.
    pub(crate) block: usize,
    pub(crate) key: Name,
    pub(crate) name: Box<str>,
    /// Where the jump is.
    pub(crate) at: TextRange,
    /// The file of the jump, if it is another one.
    pub(crate) file: Option<Arc<str>>,
}

/// The jumps of a file out of the bodies of its blocks.
pub(crate) fn outward_jumps(context: &Context) -> Vec<Jump> {
    let mut jumps = Vec::new();
    for (network, block) in context.networks_of_blocks() {
        if context.user_blocks[block].shape != Shape::Function {
            continue;
        }
        for bound in network
            .blocks()
            .filter(|bound| bound.op() == Some(Op::Jmp) && !bound.faulty)
        {
            let Some((name, range)) = bound.facts.first_name() else {
                continue;
            };
            let key = Name::new(name);
            if context.jump_target(network.index, &key).is_none() {
                jumps.push(Jump {
                    block,
                    key,
                    name: name.as_str().into(),
                    at: bound.absolute(range),
                    file: None,
                });
            }
        }
    }
    jumps
}
