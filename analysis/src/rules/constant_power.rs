//! `constant-power`: contacts that together never conduct, or always do.

use super::power_rules::{Table, is_condition};
use crate::boolean::power::{Question, Replacement};
use crate::boolean::space::Set;
use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::program::Step;
use ladder_syntax::TextRange;

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Wiring, "constant-power", Severity::Warning).about_types());

pub(super) fn check(table: &Table<'_>, out: &mut Vec<Diagnostic>) {
    for (index, step) in table.network.order.steps.iter().enumerate() {
        match *step {
            Step::Block { block, en } if is_condition(table.block(block)) => {
                out.extend(block_is_constant(table, block, en));
            }
            Step::Join { upper, lower } => out.extend(branches_always_conduct(table, index, upper, lower)),
            _ => {}
        }
    }
}

fn block_is_constant(table: &Table<'_>, block: usize, en: usize) -> Option<Diagnostic> {
    let bound = table.block(block);
    let powers = &table.powers.of_step;
    match table.power.constant_condition(block) {
        Some(true) => {
            return Some(
                Diagnostic::new(
                    RULE,
                    bound.range(),
                    format!("{} always conducts", table.tags.written_block(bound)),
                )
                .help("whatever its tags hold, it is true: compare with another value, or remove it")
                .fix(
                    Applicability::Unsafe,
                    "Draw a wire in its place",
                    bound.range(),
                    "--",
                ),
            );
        }
        Some(false) => {
            return Some(
                Diagnostic::new(
                    RULE,
                    bound.range(),
                    format!("{} never conducts", table.tags.written_block(bound)),
                )
                .help("whatever its tags hold, it is false: compare with another value, or remove the rung"),
            );
        }
        None => {}
    }
    if !powers[table.step_of[block]].is_empty() || powers[en].is_empty() {
        return None;
    }
    let mut found = Diagnostic::new(
        RULE,
        bound.range(),
        "no power ever comes through here: when this conducts, what is before it does not",
    )
    .help("change one of the conditions; to switch a rung off on purpose use [ ]( SYS.OFF )");
    for before in opposed(table, block, en) {
        found = found.related(before, "this is off whenever the other is on");
    }
    Some(found)
}

/// The conditions before a block whose removal would let power come through it.
fn opposed(table: &Table<'_>, block: usize, en: usize) -> Vec<TextRange> {
    let step = table.step_of[block];
    let mut before = Vec::new();
    let mut at = en;
    // Along the wire to the left, up to the first branch.
    while let Step::Block { block: left, en } = table.network.order.steps[at] {
        if is_condition(table.block(left)) {
            let question = Question {
                replaced: Some((left, Replacement::Wire)),
                ..Question::default()
            };
            if !table.power.powers(question).of_step[step].is_empty() {
                before.push(table.block(left).range());
            }
        }
        at = en;
    }
    before
}

/// Two branches that begin at one point and of which one always conducts.
fn branches_always_conduct(table: &Table<'_>, join: usize, upper: usize, lower: usize) -> Option<Diagnostic> {
    let powers = &table.powers.of_step;
    let origin = table.origin(upper, lower)?;
    if origin == upper || origin == lower {
        // A bare wire: shorted-branch.
        return None;
    }
    let is_whole = |set: &Set| powers[origin].implies(set);
    if powers[origin].is_empty()
        || !is_whole(&powers[join])
        || is_whole(&powers[upper])
        || is_whole(&powers[lower])
    {
        return None;
    }
    let last = |step: usize| match table.network.order.steps[step] {
        Step::Block { block, .. } => Some(table.block(block)),
        _ => None,
    };
    let (above, below) = (last(upper)?, last(lower)?);
    Some(
        Diagnostic::new(
            RULE,
            above.range(),
            "one of these branches always conducts: together they are a bare wire",
        )
        .help("change one of the conditions, or draw a wire instead of the branches")
        .related(below.range(), "this conducts whenever the other does not"),
    )
}
