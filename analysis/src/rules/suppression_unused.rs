//! `suppression-unused`: a comment switches a rule off where it finds nothing. That is known once all findings are: see `checking/comments`.

use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Text, "suppression-unused", Severity::Info).about_directives());
