//! `bad-literal`: a number, duration, date or text that is not written like one.

use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use ladder_syntax::TextRange;

pub(crate) const RULE: Rule = Rule(&RuleFacts::new(RuleGroup::Text, "bad-literal", Severity::Error));

/// A text without its closing quote.
pub(crate) fn unclosed_string(range: TextRange) -> Diagnostic {
    Diagnostic::new(RULE, range, "this text is not closed: `'` is missing")
        .help("a text ends on its own line; a quote in it is written $'")
        // Where the text should end is a guess.
        .fix(
            Applicability::Unsafe,
            "Insert `'`",
            TextRange::empty(range.end()),
            "'",
        )
}
