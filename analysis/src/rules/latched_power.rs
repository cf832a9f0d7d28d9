//! `latched-power`: something is after a set coil, whose power is the tag and not the rung's.

use super::wiring_walk::Walk;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::networks::control_flow::ControlFlow;
use crate::program::Step;
use ladder_instructions::{Coil, SetPower};

pub(crate) const RULE: Rule = Rule(&RuleFacts::new(
    RuleGroup::Wiring,
    "latched-power",
    Severity::Info,
));

pub(super) fn check(walk: &Walk<'_>, out: &mut Vec<Diagnostic>) {
    let sets = walk.network.control_flow.has(ControlFlow::SET) && walk.network.blocks.len() > 1;
    if !sets || walk.tags.profile().semantics().set_power == SetPower::En {
        return;
    }
    // For each step the set coil whose power it carries.
    let mut latched: Vec<Option<usize>> = Vec::with_capacity(walk.steps().len());
    let mut reported = vec![false; walk.network.blocks.len()];
    for step in walk.steps() {
        latched.push(match *step {
            Step::Start { .. } => None,
            Step::Join { upper, lower } => latched[upper].or(latched[lower]),
            Step::Block { block, en } => {
                if let Some(coil) = latched[en].filter(|&coil| !reported[coil]) {
                    reported[coil] = true;
                    out.push(found(walk, coil, block));
                }
                match walk.block(block).coil() {
                    Some(Coil::Sets) => Some(block),
                    _ => latched[en],
                }
            }
        });
    }
}

fn found(walk: &Walk<'_>, coil: usize, after: usize) -> Diagnostic {
    let (coil, after) = (walk.block(coil), walk.block(after));
    let name = coil
        .facts
        .operands
        .first()
        .map_or_else(String::new, |o| walk.tags.written(&o.value));
    Diagnostic::new(
        RULE,
        after.range(),
        format!(
            "{} is after {}: its power is `{name}`, and stays on when the rung before goes off",
            walk.tags.written_block(after),
            coil.head_text()
        ),
    )
    .help("if that is meant, keep it; else draw a branch before the set coil")
    .related(coil.range(), "the set coil")
}
