//! Which findings comments hide, found without asking every comment about every finding.

use super::scope::Allow;
use crate::rule::Rule;
use ladder_syntax::{TextRange, TextSize};
use std::collections::BTreeMap;

/// What comments switch off: each rule once for each stretch of the text.
pub(super) struct Switches {
    /// In the whole file; with it whether it would have found something.
    everywhere: BTreeMap<Rule, bool>,
    /// In a network, section or line, by its place. Of these none reaches into another, so that few of them are
    /// around any place.
    local: Vec<Switch>,
}

struct Switch {
    covers: TextRange,
    rule: Rule,
    used: bool,
}

impl Switch {
    fn key(covers: TextRange, rule: Rule) -> impl Ord {
        (covers.start(), covers.end(), rule)
    }
}

impl Switches {
    pub(super) fn of(allows: &[Allow]) -> Switches {
        let rules = |allow: &Allow| {
            allow
                .rules
                .iter()
                .map(|switched| switched.rule)
                .collect::<Vec<_>>()
        };
        let (file, local): (Vec<_>, Vec<_>) = allows.iter().partition(|allow| allow.whole_file);
        let everywhere = file.into_iter().flat_map(rules).map(|rule| (rule, false));
        let mut local: Vec<Switch> = local
            .into_iter()
            .flat_map(|allow| {
                rules(allow).into_iter().map(|rule| Switch {
                    covers: allow.covers,
                    rule,
                    used: false,
                })
            })
            .collect();
        local.sort_by_key(|switch| Switch::key(switch.covers, switch.rule));
        local.dedup_by_key(|switch| (switch.covers, switch.rule));
        Switches {
            everywhere: everywhere.collect(),
            local,
        }
    }

    /// Whether a finding is hidden. What hides it is noted as used.
    pub(super) fn hide(&mut self, rule: Rule, at: TextSize) -> bool {
        let mut hidden = false;
        if let Some(used) = self.everywhere.get_mut(&rule) {
            *used = true;
            hidden = true;
        }
        let end = self.local.partition_point(|switch| switch.covers.start() <= at);
        let around = self.local[..end].iter_mut().rev();
        for switch in around.take_while(|switch| switch.covers.end() >= at) {
            if switch.rule == rule {
                switch.used = true;
                hidden = true;
            }
        }
        hidden
    }

    /// Tells the comments which of their rules would have found something.
    pub(super) fn note_used(&self, allows: &mut [Allow]) {
        for allow in allows {
            for switched in &mut allow.rules {
                switched.used = if allow.whole_file {
                    self.everywhere.get(&switched.rule).copied().unwrap_or(false)
                } else {
                    let key = Switch::key(allow.covers, switched.rule);
                    let at = self
                        .local
                        .partition_point(|switch| Switch::key(switch.covers, switch.rule) < key);
                    self.local.get(at).is_some_and(|switch| switch.used)
                };
            }
        }
    }
}
