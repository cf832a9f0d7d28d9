//! `unconditional-end`: an `<END>` that every scan comes to, so that the program runs once.

use super::flow::Flow;
use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity, When};
use ladder_instructions::Op;

pub(crate) const RULE: Rule = Rule(
    &RuleFacts::new(RuleGroup::Program, "unconditional-end", Severity::Warning)
        .when(When::Whole)
        .fixed(Applicability::Unsafe),
);

pub(super) fn check(flow: &Flow<'_>, out: &mut Vec<Diagnostic>) {
    for exit in flow.exits.iter().filter(|exit| exit.always) {
        let bound = flow.block(exit);
        if bound.op() != Some(Op::End) {
            continue;
        }
        out.push(
            Diagnostic::new(
                RULE,
                bound.range(),
                "<END> stops the program for good, and no condition is before it: only one scan runs",
            )
            .help("a program needs no end; <RET> ends the scan, as END does in other controllers")
            // The program does something else then.
            .fix(
                Applicability::Unsafe,
                "End the scan only: <RET>",
                bound.head_range(),
                "<RET>",
            ),
        );
    }
}
