//! The rules that look at blocks one by one, and what those that look at the whole program need to know of it.

use super::{
    alternative_mnemonic, ambiguous_sign, complex_network, division_by_zero, real_equality, result_arrow,
    short_preset,
};
use crate::context::Context;
use crate::control_flow::ControlFlow;
use crate::diagnostic::Diagnostic;
use crate::network::Meaning;
use crate::networks::{BlockAt, NetworkAt, Networks};
use crate::rule::Rule;
use crate::rule_settings::RuleSettings;
use crate::verdict::{self, InNetwork, Pass};
use ladder_instructions::Op;
use rustc_hash::{FxHashSet, FxHasher};
use std::hash::{Hash, Hasher};

/// What is known of the file as a whole.
pub(crate) struct Survey<'l> {
    /// Everything could be read, every block is known and nothing is an error: what the text does not hold is not
    /// there. Rules about the whole program are silent otherwise.
    pub(crate) whole: bool,
    /// What the networks together have of program flow.
    pub(crate) any: ControlFlow,
    pub(crate) networks: &'l Networks,
    /// What each network has of program flow, by its number.
    pub(crate) control_flow: &'l [ControlFlow],
    /// The numbers of networks in which there is an error.
    pub(crate) unsound: &'l FxHashSet<u32>,
}

impl Survey<'_> {
    /// What a network has of program flow.
    pub(super) fn control_flow(&self, network: usize) -> ControlFlow {
        self.control_flow[self.networks.id(network) as usize]
    }

    /// The networks that have something of program flow. Without any nothing is looked through.
    pub(super) fn networks_with(&self, flow: ControlFlow) -> impl Iterator<Item = NetworkAt<'_>> {
        let count = if self.any.has(flow) {
            self.networks.len()
        } else {
            0
        };
        let networks = (0..count).filter(move |&network| self.control_flow(network).has(flow));
        networks.map(|network| self.networks.at(network))
    }

    /// Whether a network is drawn and written without errors. Rules about its power are silent otherwise.
    pub(super) fn is_sound(&self, network: NetworkAt<'_>) -> bool {
        !network.broken && !self.unsound.contains(&self.networks.id(network.index))
    }
}

/// What a rule about single blocks is asked with.
pub(super) struct SurveyedBlock<'c> {
    pub(super) context: &'c Context,
    pub(super) network: NetworkAt<'c>,
    pub(super) bound: BlockAt<'c>,
    pub(super) settings: &'c RuleSettings,
}

/// Asks the rules about single blocks of a network. `stamp` is that of its tags.
pub(crate) fn of_network(
    context: &Context,
    network: NetworkAt<'_>,
    stamp: u64,
    settings: &RuleSettings,
) -> InNetwork {
    let spelling = settings.is_on(Rule::AlternativeMnemonic);
    let complex = settings.is_on(Rule::ComplexNetwork);
    let key = network.names_tags_only.then(|| {
        let mut hasher = FxHasher::default();
        (
            stamp,
            settings.scan_interval,
            context.cycle,
            spelling,
            complex,
            network.broken,
        )
            .hash(&mut hasher);
        hasher.finish()
    });
    verdict::once(Pass::Blocks, key, network, |out| {
        blocks(context, network, settings, spelling, out);
        if complex {
            complex_network::check(context, network, out);
        }
        true
    })
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
