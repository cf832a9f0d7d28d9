//! `--fix`: what can be fixed is fixed, and the drawing stays aligned.

use super::Checked;
use crate::findings::Source;
use ladder_analysis::findings::fix;
use ladder_analysis::{Applicability, Diagnostic, Rule, Severity};
use ladder_format::apply;
use ladder_syntax::LineColumn;
use ladder_workspace::shown;
use std::fmt;

/// A fix may bring out what another error hid; this many rounds are enough for all that was seen.
const ROUNDS: usize = 16;

/// What is fixed.
#[derive(Debug, Clone, Copy)]
pub(super) struct Task {
    /// Only safe fixes, or guesses as well.
    pub(super) most: Applicability,
    /// Whether the file is written; else what would change is shown.
    pub(super) writes: bool,
}

/// A fix that was made, with its place in the text that it was made in.
#[derive(Debug)]
pub(super) struct Applied {
    file: String,
    place: LineColumn,
    rule: Rule,
    title: String,
}

impl fmt::Display for Applied {
    /// `motor.clad:3:12 missing-wire: Insert wire`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (line, column) = (self.place.line, self.place.column);
        let (file, title) = (shown::line(&self.file), shown::line(&self.title));
        write!(f, "{file}:{line}:{column} {}: {title}", self.rule)
    }
}

/// What came of fixing a file.
#[derive(Debug, Default)]
pub(super) struct Fixed {
    /// The fixes in the order in which they were made.
    pub(super) fixes: Vec<Applied>,
    /// The text as it was, where only what would change is shown.
    pub(super) before: Option<String>,
}

/// Fixes a text. Where it came from is not written.
pub(super) fn fix(mut source: Source, task: Task) -> Checked {
    let options = source.format_options();
    let mut findings = source.findings();
    let mut fixed = Fixed {
        fixes: Vec::new(),
        before: (!task.writes).then(|| source.text.clone()),
    };
    let mut most = task.most;
    for _ in 0..ROUNDS {
        let fixes = fix::together(&findings, most);
        if fixes.is_empty() {
            break;
        }
        let whole = fix::combined(fixes.iter().map(|(_, fix)| *fix));
        let edits = fix::aligned(&source.text, &whole, &options);
        let next = source.with_text(apply(&source.text, &edits));
        let left = next.findings();
        // A fix that brings new errors is none.
        if errors(&left) > errors(&findings) {
            if most == Applicability::Safe {
                break;
            }
            most = Applicability::Safe;
            continue;
        }
        fixed.fixes.extend(fixes.iter().map(|(finding, fix)| Applied {
            file: source.file.clone(),
            place: source.place(finding.range.start()),
            rule: finding.rule,
            title: fix.title.clone(),
        }));
        (source, findings) = (next, left);
        // What was refused may go well with this.
        most = task.most;
    }
    Checked {
        source,
        findings,
        problems: Vec::new(),
        fixed,
    }
}

fn errors(findings: &[Diagnostic]) -> usize {
    findings
        .iter()
        .filter(|finding| finding.severity == Severity::Error)
        .count()
}
