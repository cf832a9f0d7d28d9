//! What the rules are given before they look: which of them look at all, and how long a scan takes.

use crate::findings::rule::{Rule, Severity};
use std::collections::BTreeMap;

/// The scan interval unless set otherwise, in nanoseconds (LANGUAGE §6).
pub const DEFAULT_SCAN_INTERVAL: i64 = 10_000_000;

/// What a rule's findings count as.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Level {
    /// They are shown with this severity.
    Shown(Severity),
    /// They are not shown.
    Off,
}

/// Settings of the rules. [`Default`] is what the table of rules says.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct RuleSettings {
    /// What is set otherwise than the rule itself has it.
    pub levels: BTreeMap<Rule, Level>,
    /// The scan interval in nanoseconds, where it is set: no timer can tell shorter times apart.
    pub scan_interval: Option<i64>,
}

impl RuleSettings {
    /// Sets what a rule's findings count as.
    pub fn set(&mut self, rule: Rule, level: Level) {
        self.levels.insert(rule, level);
    }

    /// What a rule's findings count as; none: as the rule itself has it.
    pub fn level(&self, rule: Rule) -> Option<Level> {
        let own = (!rule.on_by_default()).then_some(Level::Off);
        self.levels.get(&rule).copied().or(own)
    }

    /// The severity that a finding of a rule has; none if it is not shown.
    pub(crate) fn severity_of(&self, rule: Rule, severity: Severity) -> Option<Severity> {
        match self.level(rule) {
            None => Some(severity),
            Some(Level::Shown(severity)) => Some(severity),
            // A rule that is off unless set may still have errors to report.
            Some(Level::Off) => None,
        }
    }

    /// Whether a rule looks for findings.
    pub fn is_on(&self, rule: Rule) -> bool {
        self.level(rule) != Some(Level::Off)
    }
}
