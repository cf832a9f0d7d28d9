//! `redundant-element`: a contact that changes nothing.

use super::bypassed::Bypassed;
use super::no_output::may_act;
use super::power_rules::{Table, is_condition};
use super::wiring_walk::Walk;
use super::{constant_power, duplicate_branch, shorted_branch};
use crate::boolean::gate::Gate;
use crate::boolean::power::{Powers, Question, Replacement};
use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::networks::BlockAt;
use crate::program::Step;
use ladder_instructions::Power;
use rustc_hash::FxHashSet;

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Wiring, "redundant-element", Severity::Warning).about_types());

/// Tells of the contacts round which a wire leads, together where it joins their lines at one place; but for those
/// that shorted-branch reported.
pub(super) fn bypassed(
    walk: &Walk<'_>,
    contacts: &[Bypassed],
    reported: &FxHashSet<usize>,
    out: &mut Vec<Diagnostic>,
) {
    let mut contacts: Vec<&Bypassed> = contacts
        .iter()
        .filter(|contact| !reported.contains(&contact.block))
        .collect();
    contacts.sort_by_key(|contact| (contact.join, contact.block));
    for together in contacts.chunk_by(|a, b| a.join == b.join) {
        let first = walk.block(together[0].block);
        let message = if together.len() == 1 {
            let name = walk.tags.written_block(first);
            format!("{name} decides nothing: a wire leads round it")
        } else {
            "these contacts decide nothing: a wire leads round them".to_owned()
        };
        let mut found = Diagnostic::new(RULE, first.range(), message)
            .help("put a contact into the wire, or remove what it leads round");
        for other in &together[1..] {
            found = found.related(walk.block(other.block).range(), "this decides nothing either");
        }
        let mut elements = walk.network.order.elements.iter();
        let connector = elements.find(|element| element.2 == together[0].join);
        if let Some(&(rung, part, ..)) = connector {
            let place = walk.tags.part_range(rung, part);
            found = found.related(place, "the wire joins the line again here");
        }
        out.push(found);
    }
}

pub(super) fn check(table: &Table<'_>, out: &mut Vec<Diagnostic>) {
    // What never or always conducts, or has a wire round it, makes others redundant: it is reported once.
    let explains = |rule: Rule| {
        [
            RULE,
            constant_power::RULE,
            duplicate_branch::RULE,
            shorted_branch::RULE,
        ]
        .contains(&rule)
    };
    if out.iter().any(|found| explains(found.rule)) {
        return;
    }
    let mut asked = vec![0; table.power.gates.variables.len()];
    for gate in &table.power.gates.of_block {
        each_variable(gate, |variable| asked[variable] += 1);
    }
    for (index, bound) in table.network.blocks().enumerate() {
        let mut repeated = false;
        each_variable(&table.power.gates.of_block[index], |variable| {
            repeated |= asked[variable] > 1;
        });
        // Without power nothing decides, until the power is there that was meant to be.
        let is_dead = match table.network.order.steps[table.step_of[index]] {
            Step::Block { en, .. } => table.powers.of_step[en].is_empty(),
            _ => false,
        };
        // An edge remembers: without it another scan is a different one.
        if is_dead || !repeated || !is_condition(bound) || remembers(bound) {
            continue;
        }
        let same = |replacement| {
            let question = Question {
                replaced: Some((index, replacement)),
                ..Question::default()
            };
            same_effects(table, &table.power.powers(question))
        };
        let name = table.tags.written_block(bound);
        let found = Diagnostic::new(RULE, bound.range(), format!("{name} changes nothing here"));
        let found = if same(Replacement::Wire) {
            found
                .help("a wire in its place does the same: remove it, or correct the tag that was meant")
                .fix(
                    Applicability::Unsafe,
                    "Draw a wire in its place",
                    bound.range(),
                    "--",
                )
        } else if same(Replacement::Gap) {
            found.help(
                "without its branch everything stays the same: remove it, or correct the tag that was meant",
            )
        } else {
            continue;
        };
        out.push(found);
        // What is redundant next to it may not be once it is gone.
        return;
    }
}

fn remembers(bound: BlockAt<'_>) -> bool {
    bound
        .instruction()
        .is_some_and(|row| matches!(row.power, Power::TagEdge(_) | Power::EnEdge(_)))
}

fn each_variable(gate: &Gate, mut give: impl FnMut(usize)) {
    match gate {
        Gate::If(asks) => asks.iter().for_each(|ask| give(ask.variable)),
        Gate::IfNot(ask) | Gate::Gives(ask) => give(ask.variable),
        Gate::Coil(_, variable) => variable.iter().for_each(|&variable| give(variable)),
        Gate::Pass | Gate::Inverter => {}
    }
}

/// Whether every block that acts, or remembers, does the same.
fn same_effects(table: &Table<'_>, other: &Powers) -> bool {
    let effects = table.powers.effects.iter().zip(&other.effects).enumerate();
    effects
        .filter(|&(block, _)| may_act(table.block(block)) || remembers(table.block(block)))
        .all(|(_, (a, b))| a == b)
}
