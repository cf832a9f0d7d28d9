//! `contact-after-coil`: a contact is after a coil on its wire.

use super::power_rules::is_condition;
use super::wiring_walk::Walk;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::networks::BlockAt;
use crate::networks::control_flow::ControlFlow;
use crate::program::Step;
use ladder_instructions::{Op, Shape};

pub(crate) const RULE: Rule = Rule(&RuleFacts::new(
    RuleGroup::Wiring,
    "contact-after-coil",
    Severity::Warning,
));

pub(super) fn check(walk: &Walk<'_>, out: &mut Vec<Diagnostic>) {
    let coils = ControlFlow::COIL.with(ControlFlow::SET).with(ControlFlow::RESET);
    let has_coils = walk.network.control_flow.has(coils) && walk.network.blocks.len() > 1;
    if !has_coils || !is_after(walk) {
        return;
    }
    // For each step the coil that its power has passed.
    let mut passed: Vec<Option<usize>> = Vec::with_capacity(walk.steps().len());
    let mut reported = vec![false; walk.network.blocks.len()];
    for (index, step) in walk.steps().iter().enumerate() {
        passed.push(match *step {
            Step::Start { .. } => None,
            Step::Join { upper, lower } => passed[upper].or(passed[lower]),
            Step::Block { block, en } => {
                let bound = walk.block(block);
                match passed[en] {
                    Some(coil) if is_condition(bound) && walk.useful[index] && !reported[coil] => {
                        reported[coil] = true;
                        out.push(found(walk, coil, block));
                    }
                    _ => {}
                }
                // The first coil of a row stands for all.
                passed[en].or(is_coil(bound).then_some(block))
            }
        });
    }
}

fn is_coil(bound: BlockAt<'_>) -> bool {
    bound.facts.shape == Shape::Coil && bound.op().is_some_and(|op| op != Op::Res)
}

/// Whether a condition is evaluated after a coil at all; on most networks none is.
fn is_after(walk: &Walk<'_>) -> bool {
    let mut coils = false;
    walk.steps().iter().any(|step| match *step {
        Step::Block { block, .. } => {
            let bound = walk.block(block);
            coils |= is_coil(bound);
            coils && is_condition(bound)
        }
        _ => false,
    })
}

fn found(walk: &Walk<'_>, coil: usize, contact: usize) -> Diagnostic {
    let (coil, contact) = (walk.block(coil), walk.block(contact));
    Diagnostic::new(
        RULE,
        contact.range(),
        format!(
            "{} is after a coil: readers look for it left of the coils",
            walk.tags.written_block(contact)
        ),
    )
    .help(
        "draw a branch before the coil: the coil on one line, this contact and what it leads to on the other",
    )
    .related(coil.range(), "this is the coil")
}
