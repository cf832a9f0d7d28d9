//! `unclosed-block`: a bracket of a block has no partner on its line.

use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::findings::excerpt::shortened;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use ladder_syntax::{SyntaxKind, TextRange, TextSize};

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Text, "unclosed-block", Severity::Error).fixed(Applicability::Safe));

/// `text` is what is from the opening bracket to the place where the closing one belongs, which is the
/// range. The fix takes the `blanks` after it away: the wire goes on at the bracket.
/// `of_list`: the bracket is that of a list of operands, after a block's first part.
pub(crate) fn missing(
    closing: SyntaxKind,
    text: &str,
    range: TextRange,
    blanks: TextRange,
    of_list: bool,
) -> Diagnostic {
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
    Diagnostic::new(RULE, range, message)
        .help("a block is closed on its own line")
        .fix(
            applicability(text, blanks, of_list),
            format!("Insert `{bracket}`"),
            blanks,
            insertion,
        )
}

/// What is between brackets as people draw it with wire, such as `[|]`: no bracket is missing, the sign is another one.
/// `text` is the opening bracket, and `rest` what is on the line after it.
pub(crate) fn drawn(text: &str, rest: &str, range: TextRange) -> Option<Diagnostic> {
    let (sign, _) = rest.split_once(']').filter(|_| text == "[")?;
    let is_wire = |c: char| matches!(c, '|' | '\\' | '-' | '+');
    let mark = sign.trim();
    if mark.is_empty() || sign.len() > MOST_DRAWN || !mark.chars().all(is_wire) {
        return None;
    }
    let end = range.end() + TextSize::of(sign) + TextSize::of(']');
    let whole = TextRange::new(range.start(), end);
    let message = format!("`[{sign}]` is no block");
    let found = Diagnostic::new(RULE, whole, message);
    Some(if mark == "\\" {
        // That is how a closed contact is drawn, the other way round.
        found
            .help("a contact that lets power through while its tag is low is [/]")
            .fix(Applicability::Unsafe, "Write `[/]`".to_owned(), whole, "[/]")
    } else {
        found.help("a contact is [ ], or [/] where it lets power through while its tag is low")
    })
}

/// A longer stretch of wire is not drawn between brackets.
const MOST_DRAWN: usize = 5;

/// Where the bracket belongs is certain in a block's first part, in an index that is one word, and in a list of
/// operands without brackets in it. A wider gap after it may be one between two segments.
fn applicability(text: &str, blanks: TextRange, of_list: bool) -> Applicability {
    let inside = text.trim_start_matches(['(', '[', '<']);
    let one_bracket = text.len() - inside.len() == 1;
    let (is_clear, most_blanks) = if of_list {
        let nested = inside.contains(['(', '[', '<', ')', ']', '>', '\'']);
        (!nested, u32::from(text.starts_with("( ")))
    } else {
        let is_word = inside.chars().all(|c| c.is_alphanumeric() || "_$/".contains(c));
        (
            is_word || inside.trim().is_empty(),
            u32::from(inside.trim().is_empty()),
        )
    };
    if one_bracket && is_clear && blanks.len() <= TextSize::new(most_blanks) {
        Applicability::Safe
    } else {
        Applicability::Unsafe
    }
}

/// `text` is the bracket of another shape that ends the first part, as in `[TON)`.
pub(crate) fn wrong(closing: SyntaxKind, text: &str, range: TextRange) -> Diagnostic {
    let bracket = bracket(closing);
    Diagnostic::new(
        RULE,
        range,
        format!("`{text}` is where `{bracket}` closes the block"),
    )
    .help("a block ends with the partner of the bracket that it begins with")
    // Either of the two brackets may be the wrong one.
    .fix(
        Applicability::Unsafe,
        format!("Replace `{text}` with `{bracket}`"),
        range,
        bracket,
    )
}

const fn bracket(closing: SyntaxKind) -> &'static str {
    match closing {
        SyntaxKind::R_BRACKET => "]",
        SyntaxKind::R_ANGLE => ">",
        _ => ")",
    }
}
