//! What the rules about power and the whole program need to know of the file, and a block for those about blocks.

use super::tags_shown::TagsShown;
use crate::names::context::Context;
use crate::networks::control_flow::ControlFlow;
use crate::networks::{BlockAt, NetworkAt};
use ladder_instructions::{Instruction, Op};

/// What is known of the file as a whole.
pub(crate) struct Survey<'c> {
    pub(crate) context: &'c Context,
    /// Everything could be read, every block is known and nothing is an error: what the text does not hold is not
    /// there. Rules about the whole program are silent otherwise.
    pub(crate) whole: bool,
    /// What the networks together have of program flow.
    pub(crate) any: ControlFlow,
    /// For each network whether there is an error in it.
    pub(crate) unsound: &'c [bool],
}

impl<'c> Survey<'c> {
    /// What a network has of program flow.
    pub(super) fn control_flow(&self, network: usize) -> ControlFlow {
        self.context.networks.at(network).control_flow
    }

    /// The networks that have something of program flow.
    pub(super) fn networks_with(&self, flow: ControlFlow) -> impl Iterator<Item = NetworkAt<'c>> {
        let networks = self.any.has(flow).then(|| self.context.networks.iter());
        let networks = networks.into_iter().flatten();
        networks.filter(move |network| network.control_flow.has(flow))
    }

    /// Whether a network is drawn and written without errors. Rules about its power are silent otherwise.
    pub(crate) fn is_sound(&self, network: NetworkAt<'_>) -> bool {
        !network.broken && !self.unsound[network.index]
    }

    /// Whether an `<MCR>` somewhere may take the power from the left rail of a network.
    pub(crate) fn rail_varies(&self, network: NetworkAt<'_>) -> bool {
        self.any.has(ControlFlow::MCR) && !network.control_flow.has(ControlFlow::MCR)
    }
}

/// A block, for the rules about blocks.
pub(super) struct SurveyedBlock<'c> {
    pub(super) tags: TagsShown<'c>,
    pub(super) bound: BlockAt<'c>,
    /// The instruction, if it is one that could be read.
    pub(super) row: Option<&'static Instruction>,
    /// The time from one scan to the next that the program is made for, in nanoseconds.
    pub(super) scan: Option<i64>,
}

impl SurveyedBlock<'_> {
    /// Which instruction it is, if it is one that could be read.
    pub(super) fn op(&self) -> Option<Op> {
        self.row.map(|row| row.op)
    }
}
