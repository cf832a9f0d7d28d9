//! `literal-out-of-range`: a number does not fit the type of its place. Found while operands are resolved.

use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Blocks, "literal-out-of-range", Severity::Error).about_types());
