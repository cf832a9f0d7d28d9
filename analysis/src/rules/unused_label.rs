//! `unused-label`: a label that nothing jumps to.

use super::survey::Survey;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity, When};
use crate::names::context::{Body, Context};
use crate::networks::BlockAt;
use crate::networks::control_flow::ControlFlow;
use crate::networks::network::Meaning;
use ladder_instructions::Op;
use ladder_syntax::Name;
use rustc_hash::FxHashSet;

pub(crate) const RULE: Rule = Rule(
    &RuleFacts::new(RuleGroup::Program, "unused-label", Severity::Info)
        .when(When::Whole)
        .without_effect(),
);

pub(super) fn check(survey: &Survey<'_>, out: &mut Vec<Diagnostic>) {
    let context = survey.context;
    if context.labels.is_empty() || !survey.whole {
        return;
    }
    let mut targets: FxHashSet<(usize, &Name)> = FxHashSet::default();
    // Labels that bodies of <$B> blocks jump to wherever such a block is.
    let mut outside: FxHashSet<Name> = FxHashSet::default();
    for network in survey.networks_with(ControlFlow::JUMP) {
        for bound in network.blocks().filter(|bound| bound.op() == Some(Op::Jmp)) {
            let Some((name, _)) = bound.facts.first_name() else {
                continue;
            };
            let name = Name::new(name);
            match context.jump_label(network.index, &name) {
                Some(target) => {
                    targets.insert(target);
                }
                None => {
                    outside.insert(name);
                }
            }
        }
    }
    // What a block of another file jumps to is looked up by unknown-label only.
    let has_foreign_block: FxHashSet<Body> = survey
        .networks_with(ControlFlow::FLOW_BLOCK)
        .filter(|network| network.blocks().any(|bound| is_foreign(context, bound)))
        .map(|network| context.bodies[network.index])
        .collect();
    let has_flow_block: FxHashSet<Body> = survey
        .networks_with(ControlFlow::FLOW_BLOCK)
        .map(|network| context.bodies[network.index])
        .collect();
    for label in &context.labels {
        let body = context.bodies[label.network];
        let from_block = has_foreign_block.contains(&body)
            || has_flow_block.contains(&body) && outside.contains(&label.key);
        if !targets.contains(&(label.network, &label.key)) && !from_block {
            out.push(
                Diagnostic::new(
                    RULE,
                    label.at,
                    format!("nothing jumps to the label `{}`", label.name),
                )
                .help("remove it, or jump to it with <JMP>"),
            );
        }
    }
}

fn is_foreign(context: &Context, bound: BlockAt<'_>) -> bool {
    matches!(bound.meaning, Meaning::User(block) if block >= context.own_blocks)
}
