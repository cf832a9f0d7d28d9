//! `return-outside-function`: a `<RET>` in the main program.

use super::survey::Survey;
use crate::context::{Body, Context};
use crate::control_flow::ControlFlow;
use crate::diagnostic::Diagnostic;
use crate::rule::Rule;
use ladder_instructions::Op;

pub(super) fn check(context: &Context, survey: &Survey<'_>, out: &mut Vec<Diagnostic>) {
    if !survey.any.has(ControlFlow::RETURN) {
        return;
    }
    for (index, network) in context.networks.iter().enumerate() {
        if context.bodies[index] != Body::Main
            || !survey.is_sound(network)
            || !survey.control_flow(index).has(ControlFlow::RETURN)
        {
            continue;
        }
        for bound in network.blocks().filter(|bound| bound.op() == Some(Op::Ret)) {
            out.push(
                Diagnostic::new(
                    Rule::ReturnOutsideFunction,
                    bound.range(),
                    "<RET> in the main program ends the scan: nothing below it runs in this scan",
                )
                .help("if that is meant, keep it; to skip some rungs only, jump over them with <JMP>"),
            );
        }
    }
}
