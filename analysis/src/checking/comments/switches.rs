//! Which findings comments hide, found without asking every comment about every finding.

use super::scope::Allow;
use crate::findings::rule::Rule;
use crate::names::context::Context;
use std::collections::BTreeMap;
use std::ops::Range;

/// What comments switch off: each rule once for each stretch of the text.
#[derive(Default)]
pub(super) struct Switches {
    /// In the whole file; with it whether it would have found something.
    everywhere: BTreeMap<Rule, bool>,
    /// In a network, section or line, by its place. Of these none reaches into another, so that few of them are
    /// around any place.
    local: Vec<Switch>,
}

struct Switch {
    /// Lines.
    covers: Range<usize>,
    rule: Rule,
    used: bool,
}

impl Switch {
    fn key(covers: &Range<usize>, rule: Rule) -> impl Ord + use<> {
        (covers.start, covers.end, rule)
    }
}

impl Switches {
    pub(super) fn of(context: &Context, allows: &[Allow]) -> Switches {
        let mut switches = Switches::default();
        for allow in allows {
            let covers = allow.covers.lines(context);
            for &rule in &allow.rules {
                let used = false;
                match covers.clone() {
                    Some(covers) => switches.local.push(Switch { covers, rule, used }),
                    None => _ = switches.everywhere.insert(rule, used),
                }
            }
        }
        let local = &mut switches.local;
        local.sort_by_key(|switch| Switch::key(&switch.covers, switch.rule));
        local.dedup_by_key(|switch| Switch::key(&switch.covers, switch.rule));
        switches
    }

    /// Whether a finding that begins on a line is hidden. What hides it is noted as used.
    pub(super) fn hide(&mut self, rule: Rule, line: usize) -> bool {
        let mut hidden = false;
        if let Some(used) = self.everywhere.get_mut(&rule) {
            *used = true;
            hidden = true;
        }
        let end = self.local.partition_point(|switch| switch.covers.start <= line);
        let around = self.local[..end].iter_mut().rev();
        for switch in around.take_while(|switch| switch.covers.contains(&line)) {
            if switch.rule == rule {
                switch.used = true;
                hidden = true;
            }
        }
        hidden
    }

    /// Whether a rule that a comment switches off there has found something.
    pub(super) fn is_used(&self, covers: Option<&Range<usize>>, rule: Rule) -> bool {
        let Some(covers) = covers else {
            return self.everywhere.get(&rule).copied().unwrap_or_default();
        };
        let key = Switch::key(covers, rule);
        let at = self
            .local
            .partition_point(|switch| Switch::key(&switch.covers, switch.rule) < key);
        self.local.get(at).is_some_and(|switch| switch.used)
    }
}
