//! One walk over all networks, shared by the rules that look at blocks one by one and by those that look at the
//! whole program.

use super::{
    alternative_mnemonic, ambiguous_sign, division_by_zero, real_equality, result_arrow, short_preset,
};
use crate::context::Context;
use crate::control_flow::ControlFlow;
use crate::diagnostic::Diagnostic;
use crate::network::Meaning;
use crate::networks::{BlockAt, NetworkAt};
use crate::rule::{Rule, Severity};
use crate::rule_settings::RuleSettings;
use crate::verdict::{self, Pass};
use ladder_instructions::Op;
use ladder_syntax::{Part, TextSize};
use rustc_hash::FxHasher;
use std::hash::{Hash, Hasher};

/// What the walk found.
pub(super) struct Survey {
    /// Everything could be read, every block is known and nothing is an error: what the text does not hold is not
    /// there. Rules about the whole program are silent otherwise.
    pub(super) whole: bool,
    /// No tag is undeclared that should not be: a slip in a name is told once.
    pub(super) names_known: bool,
    /// For each network whether it is drawn and written without errors. Rules about its power are silent otherwise.
    pub(super) sound: Vec<bool>,
    /// For each network what it has of program flow.
    pub(super) control_flow: Vec<ControlFlow>,
    /// All of them together.
    pub(super) any: ControlFlow,
}

/// What a rule about single blocks is asked with.
pub(super) struct SurveyedBlock<'c> {
    pub(super) context: &'c Context,
    pub(super) network: NetworkAt<'c>,
    pub(super) bound: BlockAt<'c>,
    pub(super) settings: &'c RuleSettings,
}

/// Walks over all networks and asks the rules about single blocks. `stamps` are those of the networks' tags.
pub(super) fn survey(
    context: &Context,
    stamps: &[u64],
    settings: &RuleSettings,
    out: &mut Vec<Diagnostic>,
) -> Survey {
    let is_error = |found: &&Diagnostic| found.severity == Severity::Error;
    let mut errors: Vec<TextSize> = out
        .iter()
        .filter(is_error)
        .map(|found| found.range.start())
        .collect();
    errors.sort_unstable();
    let mut survey = Survey {
        whole: errors.is_empty()
            && context
                .parse
                .lines()
                .of_parts_that(Part::is_faulty)
                .all(|(_, line)| line.errors.is_empty()),
        names_known: out.iter().all(|found| found.rule != Rule::UndeclaredTag),
        sound: Vec::with_capacity(context.networks.len()),
        control_flow: Vec::with_capacity(context.networks.len()),
        any: ControlFlow::default(),
    };
    let spelling = settings.is_on(Rule::AlternativeMnemonic);
    for network in &context.networks {
        survey.whole &= !network.broken && network.known;
        let look = |out: &mut Vec<Diagnostic>| blocks(context, network, settings, spelling, out);
        if network.names_tags_only {
            let mut hasher = FxHasher::default();
            (
                stamps[network.index],
                settings.scan_interval,
                context.cycle,
                spelling,
            )
                .hash(&mut hasher);
            verdict::once(Pass::Blocks, hasher.finish(), network, out, look);
        } else {
            look(out);
        }
        let next = errors.partition_point(|&at| at < network.range.start());
        let has_error = errors.get(next).is_some_and(|&at| at < network.range.end());
        survey.sound.push(!network.broken && !has_error);
        survey.any = survey.any.with(network.control_flow);
        survey.control_flow.push(network.control_flow);
    }
    survey
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
