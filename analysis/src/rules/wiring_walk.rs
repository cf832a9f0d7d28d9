//! One walk over each network's steps, shared by the rules about what is after what on a wire.

use super::tags_shown::TagsShown;
use crate::names::context::Context;
use crate::networks::{BlockAt, NetworkAt};
use crate::program::Step;

/// A network and what the rules ask of each of its steps.
pub(super) struct Walk<'c> {
    pub(super) tags: TagsShown<'c>,
    pub(super) network: NetworkAt<'c>,
    /// Whether a block that acts uses the power that a step gives, directly or by way of conditions.
    pub(super) useful: Vec<bool>,
}

impl<'c> Walk<'c> {
    pub(super) fn block(&self, block: usize) -> BlockAt<'c> {
        self.network.block(block)
    }

    pub(super) fn steps(&self) -> &'c [Step] {
        &self.network.facts().order.steps
    }
}

impl<'c> Walk<'c> {
    /// None: the network does nothing at all, which is no-output.
    pub(super) fn new(context: &'c Context, network: NetworkAt<'c>) -> Option<Walk<'c>> {
        let acts = network.blocks().any(super::no_output::may_act);
        acts.then(|| Walk {
            tags: TagsShown::of(context, network),
            network,
            useful: useful(network),
        })
    }
}

/// For each step whether a block that acts uses its power.
fn useful(network: NetworkAt<'_>) -> Vec<bool> {
    let steps = &network.order.steps;
    let mut useful = vec![false; steps.len()];
    for (index, step) in steps.iter().enumerate().rev() {
        match *step {
            Step::Start { .. } => {}
            Step::Block { block, en } => {
                let used = useful[index] || super::no_output::may_act(network.block(block));
                useful[en] |= used;
            }
            Step::Join { upper, lower } => {
                let used = useful[index];
                useful[upper] |= used;
                useful[lower] |= used;
            }
        }
    }
    useful
}
