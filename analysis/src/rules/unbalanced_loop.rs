//! `unbalanced-loop`: `<FOR>` and `<NEXT>` that do not belong together.

use super::survey::Survey;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity, When};
use crate::networks::BlockAt;
use crate::networks::control_flow::ControlFlow;
use crate::program::DEEPEST_LOOP;
use ladder_instructions::{Op, Profile};
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
    let mut open: Vec<TextRange> = Vec::new();
    for index in 0..context.networks.len() {
        if index == 0 || context.bodies[index] != context.bodies[index - 1] {
            out.extend(open.drain(..).map(no_next));
        }
        if !survey.control_flow(index).has(loops) {
            continue;
        }
        let network = context.networks.at(index);
        // A loop begins after the network of its FOR and ends with that of its NEXT.
        let of = |op| {
            let own = network.blocks().filter(move |bound| bound.op() == Some(op));
            own.map(BlockAt::range).enumerate()
        };
        for (number, at) in of(Op::Next) {
            match open.pop() {
                None => out.push(no_for(at)),
                Some(_) if number > 0 => out.push(second(at, "<NEXT>")),
                Some(_) => {}
            }
        }
        for (number, at) in of(Op::For) {
            if number > 0 {
                out.push(second(at, "<FOR>"));
            } else if let Some(&outer) = open.last() {
                if context.profile == Profile::Click {
                    out.push(not_there(at, outer));
                } else if open.len() == DEEPEST_LOOP {
                    out.push(too_deep(at, open[0]));
                }
            }
            open.push(at);
        }
    }
    out.extend(open.into_iter().map(no_next));
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

fn second(at: TextRange, which: &str) -> Diagnostic {
    Diagnostic::new(RULE, at, format!("this is the second {which} of its network"))
        .help("a network begins one loop and ends one: put it onto a network of its own")
}

fn not_there(at: TextRange, outer: TextRange) -> Diagnostic {
    Diagnostic::new(
        RULE,
        at,
        "in the profile `click` a loop cannot be in another loop",
    )
    .help("end the first loop with <NEXT>; or put the inner loop into a function and <CALL> it")
    .related(outer, "this loop has not ended")
}

fn too_deep(at: TextRange, outermost: TextRange) -> Diagnostic {
    Diagnostic::new(
        RULE,
        at,
        format!("this loop is in {DEEPEST_LOOP} others: no more can be in each other"),
    )
    .help("end an outer loop with <NEXT> first; or put the inner loop into a function and <CALL> it")
    .related(outermost, "this is the outermost of them")
}
