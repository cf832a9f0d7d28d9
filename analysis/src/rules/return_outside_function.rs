//! `return-outside-function`: a `<RET>` in the main program.

use super::survey::Survey;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::names::context::Body;
use crate::networks::control_flow::ControlFlow;
use ladder_instructions::Op;

pub(crate) const RULE: Rule = Rule(&RuleFacts::new(
    RuleGroup::Program,
    "return-outside-function",
    Severity::Info,
));

pub(super) fn check(survey: &Survey<'_>, out: &mut Vec<Diagnostic>) {
    let context = survey.context;
    for network in survey.networks_with(ControlFlow::RETURN) {
        if context.bodies[network.index] != Body::Main || !survey.is_sound(network) {
            continue;
        }
        for bound in network.blocks().filter(|bound| bound.op() == Some(Op::Ret)) {
            out.push(
                Diagnostic::new(
                    RULE,
                    bound.range(),
                    "<RET> in the main program ends the scan: nothing below it runs in this scan",
                )
                .help("if that is meant, keep it; to skip some rungs only, jump over them with <JMP>"),
            );
        }
    }
}
