//! `duplicate-branch`: two branches side by side that conduct in the same cases.

use super::power_rules::Table;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::program::Step;

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Wiring, "duplicate-branch", Severity::Warning).about_types());

pub(super) fn check(table: &Table<'_>, out: &mut Vec<Diagnostic>) {
    let steps = &table.network.order.steps;
    for step in steps {
        let Step::Join { upper, lower } = *step else {
            continue;
        };
        let powers = &table.powers.of_step;
        if powers[upper] != powers[lower] || powers[upper].is_empty() {
            continue;
        }
        let Some(origin) = table.origin(upper, lower) else {
            continue;
        };
        let (Step::Block { block: above, .. }, Step::Block { block: below, .. }) =
            (steps[upper], steps[lower])
        else {
            continue;
        };
        if origin == upper || origin == lower || powers[origin] == powers[upper] {
            continue;
        }
        out.push(
            Diagnostic::new(
                RULE,
                table.block(below).range(),
                "this branch conducts in the same cases as the one above it: one of them is enough",
            )
            .help("remove it, or correct the tag that was meant")
            .related(table.block(above).range(), "the other branch"),
        );
    }
}
