//! One walk over each network's steps, shared by the rules about what is behind what on a wire.

use super::{bypassed, contact_after_coil, dead_end, latched_power, redundant_element, shorted_branch};
use crate::context::Context;
use crate::findings::diagnostic::Diagnostic;
use crate::networks::control_flow::ControlFlow;
use crate::networks::{BlockAt, NetworkAt};
use crate::program::Step;

/// A network and what the rules ask of each of its steps.
pub(super) struct Walk<'c> {
    pub(super) context: &'c Context,
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

/// Looks at a network that is drawn without an error.
pub(super) fn check(context: &Context, network: NetworkAt<'_>, out: &mut Vec<Diagnostic>) {
    // What does nothing at all is no-output.
    if !network.blocks().any(super::no_output::may_act) {
        return;
    }
    let walk = &Walk {
        context,
        network,
        useful: useful(network),
    };
    dead_end::check(walk, out);
    if !network.wiring.points.is_empty() {
        let bypassed = bypassed::bypassed(walk);
        let shorted = shorted_branch::check(walk, bypassed.as_deref(), out);
        redundant_element::bypassed(walk, &bypassed.unwrap_or_default(), &shorted, out);
    }
    let control_flow = network.control_flow;
    let coils = ControlFlow::COIL.with(ControlFlow::SET).with(ControlFlow::RESET);
    if control_flow.has(coils) && network.blocks.len() > 1 {
        contact_after_coil::check(walk, out);
    }
    if control_flow.has(ControlFlow::SET) && network.blocks.len() > 1 {
        latched_power::check(walk, out);
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
