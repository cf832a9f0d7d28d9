//! `reset-without-set`: a tag that is reset and nothing sets. Found together with `set-without-reset`.

use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity, When};

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Program, "reset-without-set", Severity::Info).when(When::Whole));
