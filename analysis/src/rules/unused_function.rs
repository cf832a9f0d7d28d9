//! `unused-function`: a function that nothing calls.

use super::survey::Survey;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity, When};
use crate::names::context::Body;
use crate::networks::control_flow::ControlFlow;
use ladder_instructions::Op;
use ladder_syntax::Name;
use rustc_hash::FxHashSet;

pub(crate) const RULE: Rule = Rule(
    &RuleFacts::new(RuleGroup::Program, "unused-function", Severity::Info)
        .when(When::Whole)
        .without_effect(),
);

pub(super) fn check(survey: &Survey<'_>, out: &mut Vec<Diagnostic>) {
    let context = survey.context;
    // A file without a main program holds functions for others, maybe of another workspace.
    if context.functions.is_empty() || !survey.whole || !context.bodies.contains(&Body::Main) {
        return;
    }
    // An unread part may call it.
    if context.unread.any() {
        return;
    }
    let mut called: FxHashSet<usize> = FxHashSet::default();
    for network in survey.networks_with(ControlFlow::CALL) {
        for bound in network.blocks().filter(|bound| bound.op() == Some(Op::Call)) {
            if let Some((name, _)) = bound.facts.first_name() {
                called.extend(context.function(&Name::new(name)));
            }
        }
    }
    for (index, function) in context.functions.iter().enumerate() {
        // A second one of the same name is another error.
        let is_called = called.contains(&index) || context.others.call(&function.key);
        if !is_called && context.function(&function.key) == Some(index) {
            let place = if context.others.have_files() {
                "no file of the workspace"
            } else {
                "nothing in this file"
            };
            out.push(
                Diagnostic::new(
                    RULE,
                    function.at,
                    format!("{place} calls the function `{}`", function.name),
                )
                .help(format!("call it with <CALL>( {} ), or remove it", function.name)),
            );
        }
    }
}
