//! How much was found.

use ladder_analysis::{Diagnostic, Fix, Rule, Severity};
use ladder_syntax::numeral::counted;
use std::collections::BTreeMap;
use std::fmt;

/// How many findings of each kind there are.
#[derive(Debug, Clone, Default)]
pub(super) struct Tally {
    files: usize,
    pub(super) errors: usize,
    pub(super) warnings: usize,
    infos: usize,
    pub(super) fixed: usize,
    /// Nothing was written: what was fixed is what would be.
    only_shown: bool,
    rules: BTreeMap<Rule, Found>,
}

/// What a rule found.
#[derive(Debug, Clone, Copy, Default)]
struct Found {
    times: usize,
    /// How many of them have a safe fix.
    fixes: usize,
}

impl Tally {
    /// Counts a finding.
    pub(super) fn count(&mut self, finding: &Diagnostic) {
        let found = self.rules.entry(finding.rule).or_default();
        found.times += 1;
        found.fixes += usize::from(finding.fixes.iter().any(Fix::is_safe));
        self.count_severity(finding.severity);
    }

    /// Counts what no rule found.
    pub(super) fn count_severity(&mut self, severity: Severity) {
        match severity {
            Severity::Error => self.errors += 1,
            Severity::Warning => self.warnings += 1,
            Severity::Info => self.infos += 1,
        }
    }

    /// Counts a file, with this many fixed findings.
    pub(super) fn file(&mut self, fixed: usize) {
        self.files += 1;
        self.fixed += fixed;
    }

    /// Counts a file of which only what would be fixed was shown, with what would be left.
    pub(super) fn file_to_fix(&mut self, left: &[Diagnostic], fixed: usize) {
        self.file(fixed);
        self.only_shown = true;
        for finding in left {
            self.count(finding);
        }
    }

    /// Whether no file was checked.
    pub(super) fn is_empty(&self) -> bool {
        self.files == 0
    }

    /// How many findings there are.
    pub(super) fn findings(&self) -> usize {
        self.errors + self.warnings + self.infos
    }

    /// A line for each rule, the most frequent first. A `*` marks those of which some can be fixed
    /// safely.
    pub(super) fn statistics(&self) -> String {
        let mut rules: Vec<(&Rule, &Found)> = self.rules.iter().collect();
        rules.sort_by_key(|(rule, found)| (std::cmp::Reverse(found.times), *rule));
        let lines = rules.into_iter().map(|(rule, found)| {
            let mark = if found.fixes > 0 { "*" } else { " " };
            format!("{:>6} {mark} {rule}\n", found.times)
        });
        lines.collect()
    }
}

impl fmt::Display for Tally {
    /// `Checked 5 files: 2 errors, 1 warning.`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let found: Vec<String> = [
            (self.errors, "error"),
            (self.warnings, "warning"),
            (self.infos, "info"),
        ]
        .into_iter()
        .filter(|(count, _)| *count > 0)
        .map(|(count, one)| counted(count, one))
        .collect();
        let found = if found.is_empty() {
            "no errors found".to_owned()
        } else {
            found.join(", ")
        };
        write!(f, "Checked {}: {found}.", counted(self.files, "file"))?;
        match self.fixed {
            0 => Ok(()),
            fixed if self.only_shown => write!(f, " {} would be fixed.", counted(fixed, "finding")),
            fixed => write!(f, " Fixed {}.", counted(fixed, "finding")),
        }
    }
}
