//! `unreachable`: rungs that no scan comes to.

use super::flow::{Exit, Flow};
use super::no_output::first_rung;
use crate::boolean::written::written_block;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity, When};
use crate::program::Step;
use ladder_instructions::Op;

pub(crate) const RULE: Rule = Rule(
    &RuleFacts::new(RuleGroup::Program, "unreachable", Severity::Warning)
        .when(When::Whole)
        .without_effect(),
);

pub(super) fn check(flow: &Flow<'_>, out: &mut Vec<Diagnostic>) {
    let reached = flow.reached();
    for exit in flow.exits.iter().filter(|exit| exit.always && reached[exit.from]) {
        out.extend(after_in_network(flow, exit));
    }
    let mut exits = flow.exits.iter().peekable();
    let mut always = None;
    for at in 0..reached.len() {
        while let Some(exit) = exits.next_if(|exit| exit.from < at) {
            always = Some(exit).filter(|exit| exit.always).or(always);
        }
        // The first of a row is enough.
        if reached[at] || at.checked_sub(1).is_some_and(|before| !reached[before]) {
            continue;
        }
        let network = flow.context.networks.at(flow.networks[at]);
        let Some(range) = first_rung(&flow.context.parse, network) else {
            continue;
        };
        let more = (at + 1..reached.len()).take_while(|&at| !reached[at]).count();
        let message = if more == 0 {
            "no scan ever comes to this rung".to_owned()
        } else {
            let and = if more == 1 { "the network" } else { "the networks" };
            format!("no scan ever comes to this rung, nor to {more} of {and} after it")
        };
        let message = message.replace("nor to 1 of the network after it", "nor to the network after it");
        let mut found = Diagnostic::new(RULE, range, message)
            .help("put a condition before what leaves above it, mark it with a <LBL> that is jumped to, or remove it");
        if let Some(exit) = always {
            found = found.related(flow.block(exit).range(), always_leaves(flow, exit));
        }
        out.push(found);
    }
}

fn always_leaves(flow: &Flow<'_>, exit: &Exit) -> &'static str {
    match flow.block(exit).op() {
        Some(Op::Jmp) => "this always jumps away",
        Some(Op::End) => "this always ends the program",
        _ => "this always returns",
    }
}

/// What is after such a block in its own network.
fn after_in_network(flow: &Flow<'_>, exit: &Exit) -> Option<Diagnostic> {
    let network = flow.context.networks.at(flow.networks[exit.from]);
    let after = network.order.steps[exit.step + 1..]
        .iter()
        .find_map(|step| match *step {
            Step::Block { block, .. } => Some(network.block(block)),
            _ => None,
        })?;
    Some(
        Diagnostic::new(
            RULE,
            after.range(),
            format!(
                "{} never runs: the network is left before it",
                written_block(flow.context, network.scope, after)
            ),
        )
        .help("put it before the block that leaves, or onto a rung of its own above")
        .related(flow.block(exit).range(), always_leaves(flow, exit)),
    )
}
