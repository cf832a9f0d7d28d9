//! Fixes of findings: each where its finding is, and all safe ones of a file at once.

use super::allow;
use super::suggestions::suggestions;
use super::{Action, ActionKind, Work};
use ladder_analysis::findings::fix;
use ladder_analysis::{Analysis, Applicability, Diagnostic, Finding};
use ladder_format::Edit;
use ladder_syntax::TextRange;

/// This many fixes back a fix is looked for that is the same.
const NEAR: usize = 16;

/// Of this many findings what a person would draw is worked out: each takes the drawing of its network.
const MOST_DRAWN: usize = 32;

/// The fixes of the findings that a range touches, the best of each first. Only a safe one is preferred: editors may
/// make it unasked.
pub fn quick_fixes(analysis: &Analysis, range: TextRange) -> Vec<Action> {
    let findings = analysis.findings().iter().enumerate();
    let touched = findings
        .filter(|(_, found)| found.range.start() <= range.end() && range.start() <= found.range.end());
    let mut fixes: Vec<Action> = Vec::new();
    let mut offer = |action: Action| {
        // One drawing can put several findings right; they are near to each other.
        let mut near = fixes.iter().rev().take(NEAR);
        if !near.any(|known| known.title == action.title && known.work == action.work) {
            fixes.push(action);
        }
    };
    for (nth, (index, found)) in touched.clone().enumerate() {
        let found = found.diagnostic();
        let drawn = if nth < MOST_DRAWN {
            suggestions(analysis, &found)
        } else {
            Vec::new()
        };
        if let Some(all) = names_of_another_system(analysis, &found) {
            offer(Action {
                finding: Some(index),
                ..all
            });
        }
        for (nth, fix) in found.fixes.into_iter().enumerate() {
            offer(Action {
                finding: Some(index),
                preferred: nth == 0 && fix.is_safe(),
                ..Action::new(ActionKind::QuickFix, fix.title, fix.edits)
            });
        }
        for suggestion in drawn {
            offer(Action {
                finding: Some(index),
                ..suggestion
            });
        }
    }
    // What is meant so comes after all that would change it.
    for (index, found) in touched.take(MOST_DRAWN) {
        allow::offer(&analysis.context, found, |action| {
            offer(Action {
                finding: Some(index),
                ..action
            });
        });
    }
    fixes
}

/// A rung that was copied from another system has the names of its instructions there: all of them in one step, where a finding is about
/// one of several in its network.
fn names_of_another_system(analysis: &Analysis, found: &Diagnostic) -> Option<Action> {
    const RULES: [&str; 2] = ["unknown-instruction", "wrong-shape"];
    let is_one = |rule: &str| RULES.contains(&rule);
    if !is_one(found.rule.name()) || found.fixes.is_empty() {
        return None;
    }
    let networks = &analysis.context.networks;
    let network = networks
        .iter()
        .find(|network| network.range.contains_range(found.range))?;
    let findings = analysis.findings().iter();
    let of_network =
        findings.filter(|other| is_one(other.rule.name()) && network.range.contains_range(other.range));
    let of_network: Vec<Diagnostic> = of_network.map(Finding::diagnostic).collect();
    let fixes = fix::together(&of_network, Applicability::Unsafe);
    if fixes.len() < 2 {
        return None;
    }
    let title = format!(
        "Replace all {} instructions that this network has wrong",
        fixes.len()
    );
    let edits = fix::combined(fixes.iter().map(|(_, fix)| *fix)).edits;
    Some(Action::new(ActionKind::QuickFix, title, edits))
}

/// The safe fixes of all findings at once, as far as they do not touch each other: the rest is for the next round.
pub fn fix_all(analysis: &Analysis) -> Option<Action> {
    let can = analysis.findings().iter().any(Finding::has_safe_fix);
    can.then(|| Action::later(ActionKind::FixAll, "Apply all safe fixes", Work::SafeFixes))
}

pub(super) fn safe_fixes(findings: &[Diagnostic]) -> Vec<Edit> {
    let fixes = fix::together(findings, Applicability::Safe);
    fix::combined(fixes.iter().map(|(_, fix)| *fix)).edits
}
