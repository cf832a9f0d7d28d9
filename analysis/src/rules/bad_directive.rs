//! `bad-directive`: a comment speaks to the tools, and they do not understand it. Comments are read by `checking/comments`.

use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Text, "bad-directive", Severity::Warning).about_directives());
