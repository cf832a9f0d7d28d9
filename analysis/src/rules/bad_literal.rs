//! `bad-literal`: a number, duration, date or text that is not written like one.

use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::findings::rule::Rule;
use ladder_syntax::TextRange;

/// A text without its closing quote.
pub(crate) fn unclosed_string(range: TextRange) -> Diagnostic {
    Diagnostic::new(Rule::BadLiteral, range, "this text is not closed: `'` is missing")
        .help("a text ends on its own line; a quote in it is written $'")
        // Where the text should end is a guess.
        .fix(
            Applicability::Unsafe,
            "Insert `'`",
            TextRange::empty(range.end()),
            "'",
        )
}
