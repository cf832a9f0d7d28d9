//! `shorted-branch`: a bare wire next to contacts, which so decide nothing.

use super::bypassed::Bypassed;
use super::power_rules::is_condition;
use super::redundant_element;
use super::wiring_walk::Walk;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::networks::BlockAt;
use crate::program::Step;
use rustc_hash::FxHashSet;

pub(crate) const RULE: Rule = Rule(&RuleFacts::new(
    RuleGroup::Wiring,
    "shorted-branch",
    Severity::Warning,
));

/// How far a branch is followed.
const LONGEST: usize = 64;

/// `bypassed` are the contacts that decide nothing, if that is known: one of a branch that leads elsewhere too does.
/// Returns the blocks that were reported.
/// Also finds the contacts of `redundant-element` round which a wire leads.
pub(super) fn check(walk: &Walk<'_>, out: &mut Vec<Diagnostic>) {
    if walk.network.wiring.points.is_empty() {
        return;
    }
    let bypassed = super::bypassed::bypassed(walk);
    let shorted = shorted(walk, bypassed.as_deref(), out);
    redundant_element::bypassed(walk, &bypassed.unwrap_or_default(), &shorted, out);
}

/// Returns the blocks that are reported.
fn shorted(walk: &Walk<'_>, bypassed: Option<&[Bypassed]>, out: &mut Vec<Diagnostic>) -> FxHashSet<usize> {
    let mut reported = FxHashSet::default();
    if bypassed.is_some_and(<[Bypassed]>::is_empty) {
        return reported;
    }
    let decides_nothing = |block: &usize| {
        bypassed.is_none_or(|bypassed| bypassed.iter().any(|contact| contact.block == *block))
    };
    for step in walk.steps() {
        let Step::Join { upper, lower } = *step else {
            continue;
        };
        // The wire comes from the earlier step, the branch is after it.
        let (wire, branch) = (upper.min(lower), upper.max(lower));
        let Some(mut contacts) = conditions_between(walk, wire, branch) else {
            continue;
        };
        contacts.retain(decides_nothing);
        reported.extend(&contacts);
        let contacts: Vec<BlockAt<'_>> = contacts.iter().map(|&block| walk.block(block)).collect();
        let Some((first, rest)) = contacts.split_first() else {
            continue;
        };
        let message = if rest.is_empty() {
            format!(
                "a bare wire next to {} shorts it: it decides nothing",
                walk.tags.written_block(*first)
            )
        } else {
            "a bare wire next to these contacts shorts them: they decide nothing".to_owned()
        };
        let mut found = Diagnostic::new(RULE, first.range(), message)
            .help("put a contact into the wire next to it, or remove the branch");
        for other in rest {
            found = found.related(other.range(), "this is shorted as well");
        }
        out.push(found);
    }
    reported
}

/// The conditions of a branch that comes from a step and from nowhere else, from left to right. None if it is no
/// such branch.
fn conditions_between(walk: &Walk<'_>, wire: usize, branch: usize) -> Option<Vec<usize>> {
    let mut found = Vec::new();
    let mut open = vec![branch];
    let mut seen = 0;
    while let Some(step) = open.pop() {
        seen += 1;
        if step == wire {
            continue;
        }
        if step < wire || seen > LONGEST {
            return None;
        }
        match walk.steps()[step] {
            Step::Block { block, en } if is_condition(walk.block(block)) => {
                found.push(block);
                open.push(en);
            }
            Step::Join { upper, lower } => open.extend([upper, lower]),
            Step::Start { rail: false } => {}
            _ => return None,
        }
    }
    // Blocks are numbered from left to right, top to bottom.
    found.sort_unstable();
    found.dedup();
    Some(found)
}
