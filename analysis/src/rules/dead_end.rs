//! `dead-end`: power that goes nowhere.

use super::no_output::may_act;
use super::wiring_walk::Walk;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::program::Step;
use ladder_syntax::wiring::PartKind;

pub(crate) const RULE: Rule = Rule(&RuleFacts::new(RuleGroup::Wiring, "dead-end", Severity::Warning));

pub(super) fn check(walk: &Walk<'_>, out: &mut Vec<Diagnostic>) {
    let steps = walk.steps();
    for (index, step) in steps.iter().enumerate() {
        let Step::Block { block, en } = *step else {
            continue;
        };
        // The first of a row is enough.
        if is_dead(walk, index) && !is_dead(walk, en) {
            let bound = walk.block(block);
            out.push(
                Diagnostic::new(
                    RULE,
                    bound.range(),
                    format!("the power of {} goes nowhere: nothing that acts is after it", walk.tags.written_block(bound)),
                )
                .help("put a coil or another block after it, join the line to another with \\ and /, or remove it"),
            );
        }
    }
    loose_wires(walk, out);
}

/// A condition whose power nobody uses.
fn is_dead(walk: &Walk<'_>, step: usize) -> bool {
    match walk.steps()[step] {
        Step::Block { block, .. } => !walk.useful[step] && !may_act(walk.block(block)),
        _ => false,
    }
}

/// Wires that end at nothing: no block, no connector, no rail.
fn loose_wires(walk: &Walk<'_>, out: &mut Vec<Diagnostic>) {
    let network = walk.network;
    let mut loose: Vec<(usize, usize)> = Vec::new();
    for (rung, drawing) in network.wiring.rungs.iter().enumerate() {
        let ends = drawing.segments.iter().map(|segment| segment.parts.end - 1);
        let wires = ends.filter(|&last| drawing.parts[last].kind == PartKind::Wire);
        loose.extend(wires.map(|last| (rung, last)));
    }
    if loose.is_empty() {
        return;
    }
    for &(rung, part, step, _) in &network.order.elements {
        // After a block that acts it only lacks the rail; after a condition that is reported already; and where no
        // power comes the line has another error.
        if loose.binary_search(&(rung, part)).is_err() || comes_from_block(walk, step) || !is_live(walk, step)
        {
            continue;
        }
        out.push(
            Diagnostic::new(
                RULE,
                walk.tags.part_range(rung, part),
                "this wire ends at nothing",
            )
            .help("draw it on to a connector or a block, or remove it"),
        );
    }
}

fn comes_from_block(walk: &Walk<'_>, step: usize) -> bool {
    match walk.steps()[step] {
        Step::Block { .. } => true,
        Step::Join { upper, lower } => {
            let acts = |step: usize| match walk.steps()[step] {
                Step::Block { block, .. } => may_act(walk.block(block)),
                Step::Join { .. } => !walk.useful[step],
                Step::Start { .. } => false,
            };
            acts(upper) || acts(lower)
        }
        Step::Start { .. } => false,
    }
}

fn is_live(walk: &Walk<'_>, step: usize) -> bool {
    !matches!(walk.steps()[step], Step::Start { rail: false })
}
