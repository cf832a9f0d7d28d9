//! One walk over each network's steps, shared by the rules about what stands behind what on a wire.

use super::control_flow::ControlFlow;
use super::survey::Survey;
use super::{bypassed, contact_after_coil, dead_end, latched_power, redundant_element, shorted_branch};
use crate::context::Context;
use crate::diagnostic::Diagnostic;
use crate::network::{BoundBlock, NetworkFacts};
use crate::program::Step;

/// A network and what the rules ask of each of its steps.
pub(super) struct Walk<'c> {
    pub(super) context: &'c Context,
    pub(super) network: &'c NetworkFacts,
    /// Whether a block that acts uses the power that a step gives, directly or by way of conditions.
    pub(super) useful: Vec<bool>,
}

impl<'c> Walk<'c> {
    pub(super) fn block(&self, block: usize) -> &'c BoundBlock {
        &self.network.blocks[block]
    }

    pub(super) fn steps(&self) -> &'c [Step] {
        &self.network.order.steps
    }
}

/// Walks over all networks that are drawn without a mistake.
pub(super) fn check(context: &Context, survey: &Survey, out: &mut Vec<Diagnostic>) {
    let mut walk = None;
    for (index, network) in context.networks.iter().enumerate() {
        let control_flow = survey.control_flow[index];
        let by_itself = network.names_tags_only;
        if by_itself && network.verdict.is_well_wired() {
            continue;
        }
        // What does nothing at all is no-output.
        if !survey.sound[index] || !network.blocks.iter().any(super::no_output::may_act) {
            continue;
        }
        let walk = walk.get_or_insert_with(|| Walk {
            context,
            network,
            useful: Vec::new(),
        });
        walk.network = network;
        find_useful(network, &mut walk.useful);
        let found = out.len();
        dead_end::check(walk, out);
        if !network.wiring.points.is_empty() {
            let bypassed = bypassed::bypassed(walk);
            let shorted = shorted_branch::check(walk, bypassed.as_deref(), out);
            redundant_element::bypassed(walk, &bypassed.unwrap_or_default(), &shorted, out);
        }
        let coils = ControlFlow::COIL.with(ControlFlow::SET).with(ControlFlow::RESET);
        if control_flow.has(coils) && network.blocks.len() > 1 {
            contact_after_coil::check(walk, out);
        }
        if control_flow.has(ControlFlow::SET) && network.blocks.len() > 1 {
            latched_power::check(walk, out);
        }
        if by_itself && out.len() == found {
            network.verdict.well_wired();
        }
    }
}

fn find_useful(network: &NetworkFacts, useful: &mut Vec<bool>) {
    let steps = &network.order.steps;
    useful.clear();
    useful.resize(steps.len(), false);
    for (index, step) in steps.iter().enumerate().rev() {
        match *step {
            Step::Start { .. } => {}
            Step::Block { block, en } => {
                let used = useful[index] || super::no_output::may_act(&network.blocks[block]);
                useful[en] |= used;
            }
            Step::Join { upper, lower } => {
                let used = useful[index];
                useful[upper] |= used;
                useful[lower] |= used;
            }
        }
    }
}
