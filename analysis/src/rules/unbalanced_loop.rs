//! `unbalanced-loop`: `<FOR>` and `<NEXT>` that do not belong together.

use super::survey::Survey;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity, When};
use crate::networks::control_flow::ControlFlow;
use ladder_instructions::Op;
use ladder_syntax::TextRange;

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Program, "unbalanced-loop", Severity::Error).when(When::Whole));

pub(super) fn check(survey: &Survey<'_>, out: &mut Vec<Diagnostic>) {
    let context = survey.context;
    let loops = ControlFlow::FOR.with(ControlFlow::NEXT);
    // Of a loop that cannot be read, only one half may be left.
    if !survey.any.has(loops) || !survey.whole {
        return;
    }
    let mut open: Option<TextRange> = None;
    for index in 0..context.networks.len() {
        if index == 0 || context.bodies[index] != context.bodies[index - 1] {
            out.extend(open.take().map(no_next));
        }
        if !survey.control_flow(index).has(loops) {
            continue;
        }
        let network = context.networks.at(index);
        // A loop begins after the network of its FOR and ends with that of the next NEXT.
        let of = |op| network.blocks().filter(move |bound| bound.op() == Some(op));
        let mut nexts = of(Op::Next);
        if let Some(first) = nexts.next() {
            if open.take().is_none() {
                out.push(no_for(first.range()));
            }
            out.extend(nexts.map(|next| no_for(next.range())));
        }
        for bound in of(Op::For) {
            if let Some(outer) = open {
                out.push(nested(bound.range(), outer));
            }
            open = Some(bound.range());
        }
    }
    out.extend(open.map(no_next));
}

fn no_next(at: TextRange) -> Diagnostic {
    Diagnostic::new(
        RULE,
        at,
        "this <FOR> has no <NEXT>: nobody can say where the loop ends",
    )
    .help("end the loop with <NEXT> on a network of its own after the rungs that are repeated")
}

fn no_for(at: TextRange) -> Diagnostic {
    Diagnostic::new(RULE, at, "this <NEXT> ends no loop")
        .help("begin the loop with <FOR>( n ) on a network before it, or remove it")
}

fn nested(at: TextRange, outer: TextRange) -> Diagnostic {
    Diagnostic::new(RULE, at, "a loop cannot be in another loop")
        .help("end the first loop with <NEXT>; or put the inner loop into a function and <CALL> it")
        .related(outer, "this loop has not ended")
}
