//! What the rules are told before they look: which of them look at all, and how long a scan takes.

use crate::rule::Rule;
use std::collections::BTreeSet;

/// The scan interval unless set otherwise, in nanoseconds (LANGUAGE §6).
pub const DEFAULT_SCAN_INTERVAL: i64 = 10_000_000;

/// Settings of the rules. [`Default`] is what the table of rules says.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RuleSettings {
    on: BTreeSet<Rule>,
    /// The scan interval in nanoseconds: no timer can tell shorter times apart.
    pub scan_interval: i64,
}

impl Default for RuleSettings {
    fn default() -> RuleSettings {
        RuleSettings {
            on: Rule::ALL
                .iter()
                .copied()
                .filter(|rule| rule.on_by_default())
                .collect(),
            scan_interval: DEFAULT_SCAN_INTERVAL,
        }
    }
}

impl RuleSettings {
    /// Every rule looks, also those that are off unless set.
    pub fn everything() -> RuleSettings {
        RuleSettings {
            on: Rule::ALL.iter().copied().collect(),
            ..RuleSettings::default()
        }
    }

    /// Switches a rule on or off.
    pub fn switch(&mut self, rule: Rule, on: bool) {
        if on {
            self.on.insert(rule);
        } else {
            self.on.remove(&rule);
        }
    }

    /// Whether a rule looks for findings.
    pub fn is_on(&self, rule: Rule) -> bool {
        self.on.contains(&rule)
    }
}
