//! `duplicate-counter`: a second block works on the tag of a counter. Found with `duplicate-timer`.

use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};

pub(crate) const RULE: Rule = Rule(
    &RuleFacts::new(RuleGroup::Names, "duplicate-counter", Severity::Error)
        .about_types()
        .runs_if_allowed(),
);
