//! What the rules about power and the whole program need to know of the file, and the walk over blocks that the rules about
//! single blocks share.

use super::{
    alternative_mnemonic, ambiguous_sign, complex_network, division_by_zero, real_equality, result_arrow,
    short_preset,
};
use crate::context::Context;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::Rule;
use crate::findings::rule_settings::RuleSettings;
use crate::networks::control_flow::ControlFlow;
use crate::networks::network::Meaning;
use crate::networks::{BlockAt, NetworkAt};
use ladder_instructions::Op;

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

/// What a rule about single blocks is asked with.
pub(super) struct SurveyedBlock<'c> {
    pub(super) context: &'c Context,
    pub(super) network: NetworkAt<'c>,
    pub(super) bound: BlockAt<'c>,
    pub(super) settings: &'c RuleSettings,
}

/// Asks the rules about single blocks of a network.
pub(crate) fn of_network(
    context: &Context,
    network: NetworkAt<'_>,
    settings: &RuleSettings,
    out: &mut Vec<Diagnostic>,
) {
    blocks(
        context,
        network,
        settings,
        settings.is_on(Rule::AlternativeMnemonic),
        out,
    );
    if settings.is_on(Rule::ComplexNetwork) {
        complex_network::check(context, network, out);
    }
}

/// Asks the rules about single blocks.
fn blocks(
    context: &Context,
    network: NetworkAt<'_>,
    settings: &RuleSettings,
    spelling: bool,
    out: &mut Vec<Diagnostic>,
) {
    for bound in network.blocks() {
        let Meaning::Instruction(row) = bound.meaning else {
            result_arrow::check(context, bound, out);
            continue;
        };
        if bound.faulty {
            continue;
        }
        let place = SurveyedBlock {
            context,
            network,
            bound,
            settings,
        };
        match row.op {
            _ if row.is_timer() => short_preset::check(&place, out),
            Op::Eq | Op::Ne => real_equality::check(&place, out),
            Op::Div | Op::Mod => division_by_zero::check(&place, out),
            Op::Calc => {
                ambiguous_sign::check(&place, out);
                real_equality::in_expression(&place, out);
                division_by_zero::in_expression(&place, out);
            }
            _ => {}
        }
        if bound.facts.operands.len() > 1 {
            result_arrow::check(context, bound, out);
        }
        if spelling {
            alternative_mnemonic::check(row, bound, out);
        }
    }
}
