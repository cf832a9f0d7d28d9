//! `complex-network`: a network that holds more than a person can follow at once. Off unless set.

use super::form::Form;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::networks::network::BoundBlock;
use ladder_instructions::Role;

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Wiring, "complex-network", Severity::Info).off());

/// How many conditions a network may have.
const MOST_CONDITIONS: usize = 16;
/// How many lines.
const MOST_LINES: usize = 10;

pub(super) fn check(form: &Form<'_>, out: &mut Vec<Diagnostic>) {
    let network = form.network;
    let rungs = network.wiring.rungs.len();
    if network.broken || (network.blocks.len() <= MOST_CONDITIONS && rungs <= MOST_LINES) {
        return;
    }
    let is_condition = |role| role == Role::Condition;
    let rows = network.blocks.iter().filter_map(BoundBlock::instruction);
    let conditions = rows.filter(|row| is_condition(row.role)).count();
    let message = if conditions > MOST_CONDITIONS {
        format!("this network has {conditions} conditions, more than {MOST_CONDITIONS}")
    } else if rungs > MOST_LINES {
        format!("this network has {rungs} lines, more than {MOST_LINES}")
    } else {
        return;
    };
    let Some(range) = super::no_output::first_rung(form.parse, network) else {
        return;
    };
    out.push(Diagnostic::new(RULE, range, message).help(
        "give parts of it tags of their own, each on a rung above, with names that say what they mean",
    ));
}
