//! `unclosed-block`: a bracket of a block has no partner on its line.

use crate::diagnostic::Diagnostic;
use crate::excerpt::shortened;
use crate::rule::Rule;
use ladder_syntax::{SyntaxKind, TextRange};

/// `text` is what stands from the opening bracket to the place where the closing one belongs, which is the
/// range. The fix takes the `blanks` behind it away: the wire goes on at the bracket.
pub(crate) fn missing(closing: SyntaxKind, text: &str, range: TextRange, blanks: TextRange) -> Diagnostic {
    let bracket = bracket(closing);
    let message = if text.is_empty() {
        format!("a `{bracket}` is missing here")
    } else {
        format!("`{}` is not closed: `{bracket}` is missing", shortened(text, 30))
    };
    // `( a )` keeps a blank inside the parentheses; the brackets of a first part have none.
    let insertion = if text.starts_with("( ") && text.trim_end() == text {
        format!(" {bracket}")
    } else {
        bracket.to_owned()
    };
    Diagnostic::new(Rule::UnclosedBlock, range, message)
        .help("a block is closed on its own line")
        .fix(format!("Insert `{bracket}`"), blanks, insertion)
}

/// `text` is the bracket of another shape that ends the first part, as in `[TON)`.
pub(crate) fn wrong(closing: SyntaxKind, text: &str, range: TextRange) -> Diagnostic {
    let bracket = bracket(closing);
    Diagnostic::new(
        Rule::UnclosedBlock,
        range,
        format!("`{text}` stands where `{bracket}` closes the block"),
    )
    .help("a block ends with the partner of the bracket that it begins with")
    .fix(format!("Replace `{text}` with `{bracket}`"), range, bracket)
}

const fn bracket(closing: SyntaxKind) -> &'static str {
    match closing {
        SyntaxKind::R_BRACKET => "]",
        SyntaxKind::R_ANGLE => ">",
        _ => ")",
    }
}
