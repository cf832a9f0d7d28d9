//! `rung-not-powered`: a rung does not begin with `+`, which takes power from the left rail, and no connector feeds it.

use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use ladder_syntax::TextRange;

pub(crate) const RULE: Rule = Rule(
    &RuleFacts::new(RuleGroup::Wiring, "rung-not-powered", Severity::Warning).fixed(Applicability::Unsafe),
);

/// `range` is the stretch without power, as open-wire would show it.
pub(super) fn found(range: TextRange) -> Diagnostic {
    Diagnostic::new(
        RULE,
        range,
        "this rung gets no power: it does not begin with `+`, which takes power from the left rail",
    )
    .help("begin the line with `+`; a `|` there is decoration")
}
