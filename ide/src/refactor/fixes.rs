//! Fixes of findings: each where its finding is, and all of a file at once.

use super::{Action, ActionKind, Work};
use ladder_analysis::{Analysis, Diagnostic};
use ladder_format::Edit;
use ladder_syntax::{TextRange, TextSize};
use std::collections::BTreeMap;

/// The fixes of the findings that a range touches, the best of each first.
pub fn quick_fixes(analysis: &Analysis, range: TextRange) -> Vec<Action> {
    let findings = analysis.diagnostics.iter().enumerate();
    let touched = findings
        .filter(|(_, found)| found.range.start() <= range.end() && range.start() <= found.range.end());
    touched
        .flat_map(|(index, found)| {
            found.fixes.iter().enumerate().map(move |(nth, fix)| Action {
                finding: Some(index),
                preferred: nth == 0,
                ..Action::new(ActionKind::QuickFix, fix.title.clone(), fix.edits.clone())
            })
        })
        .collect()
}

/// The first fix of every finding at once, as far as they do not touch each other: the rest is for the next round.
pub fn fix_all(analysis: &Analysis) -> Option<Action> {
    let can = analysis.diagnostics.iter().any(|found| !found.fixes.is_empty());
    can.then(|| Action::later(ActionKind::FixAll, "Apply all fixes", Work::AllFixes))
}

pub(super) fn first_fixes(findings: &[Diagnostic]) -> Vec<Edit> {
    let mut edits: BTreeMap<TextSize, Edit> = BTreeMap::new();
    for fix in findings.iter().filter_map(|found| found.fixes.first()) {
        // Those taken do not touch each other, so only the last one that begins before the end can touch.
        let touches = |new: &Edit| {
            let before = edits.range(..=new.range.end()).next_back();
            before.is_some_and(|(_, old)| new.range.start() <= old.range.end())
        };
        if !fix.edits.iter().any(touches) {
            edits.extend(fix.edits.iter().map(|edit| (edit.range.start(), edit.clone())));
        }
    }
    edits.into_values().collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use ladder_analysis::Rule;

    /// The texts that "Apply all fixes" puts in for findings with these fixes, each an edit.
    fn all_fixes(fixes: &[(u32, u32, &str)]) -> Vec<String> {
        let finding = |&(start, end, text): &(u32, u32, &str)| {
            let range = TextRange::new(start.into(), end.into());
            Diagnostic::new(Rule::MissingWire, range, "").fix("", range, text)
        };
        let findings: Vec<_> = fixes.iter().map(finding).collect();
        first_fixes(&findings).into_iter().map(|edit| edit.text).collect()
    }

    #[test]
    fn fixes_that_touch_each_other_are_not_made_together() {
        assert_eq!(
            all_fixes(&[(0, 2, "first"), (4, 6, "second")]),
            ["first", "second"]
        );
        assert_eq!(
            all_fixes(&[(4, 6, "second"), (0, 2, "first")]),
            ["first", "second"],
            "in the order of the text"
        );
        assert_eq!(
            all_fixes(&[(0, 4, "first"), (2, 6, "across"), (8, 9, "third")]),
            ["first", "third"]
        );
        assert_eq!(all_fixes(&[(3, 3, "first"), (3, 3, "same place")]), ["first"]);
        assert_eq!(all_fixes(&[(0, 3, "first"), (3, 5, "right behind")]), ["first"]);
        assert_eq!(all_fixes(&[]), Vec::<String>::new());
    }
}
