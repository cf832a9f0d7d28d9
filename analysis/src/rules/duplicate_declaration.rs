//! `duplicate-declaration`: one name is declared twice, otherwise. Found while names are joined, and with `one_address`.

use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};

pub(crate) const RULE: Rule = Rule(&RuleFacts::new(
    RuleGroup::Names,
    "duplicate-declaration",
    Severity::Error,
));
