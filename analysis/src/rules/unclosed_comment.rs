//! `unclosed-comment`: a `#` has no partner.
//!
//! The `#` that is left over at the end is seldom the wrong one: where one is missing, everything after it
//! is read the other way round, comments as drawing and drawing as comments. So the finding is at the
//! first comment that holds a line of drawing, and what is found after it is not shown.

use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use ladder_syntax::{Parse, SyntaxErrorKind, TextRange};

pub(crate) const RULE: Rule = Rule(&RuleFacts::new(
    RuleGroup::Text,
    "unclosed-comment",
    Severity::Error,
));

/// `range` is the `#` at which the parser puts it.
pub(crate) fn unclosed(parse: &Parse, range: TextRange) -> Diagnostic {
    match left_over(parse) {
        Some(last) if last != range => Diagnostic::new(
            RULE,
            range,
            "this comment holds lines of drawing: its closing `#` is probably missing",
        )
        .help("close it after its text; until then nothing after this place is checked")
        .related(last, "this `#` is left without a partner"),
        _ => Diagnostic::new(
            RULE,
            range,
            "this comment is never closed: all that follows is read as comment",
        )
        .help(match typed_value(&parse.to_string(), range) {
            Some((ty, value)) => {
                format!("close it with a second `#`; the value of an enumeration is written {ty}.{value}")
            }
            None => "close it with a second `#`".to_owned(),
        }),
    }
}

/// What other systems write as `Phase#IDLE`: the type and the value, if that is what is around a `#`.
fn typed_value(text: &str, mark: TextRange) -> Option<(&str, &str)> {
    let is_name = |c: char| c.is_alphanumeric() || c == '_';
    let (before, after) = (&text[..mark.start().into()], &text[mark.start().into()..]);
    let after = after.strip_prefix('#')?;
    let ty = &before[before.trim_end_matches(is_name).len()..];
    let rest = after.trim_start_matches(is_name);
    let value = &after[..after.len() - rest.len()];
    let begins = |name: &str| name.starts_with(|c: char| c.is_alphabetic() || c == '_');
    (begins(ty) && begins(value) && rest.trim_start().starts_with([')', ','])).then_some((ty, value))
}

/// The `#` that opens a comment up to the end of the text.
fn left_over(parse: &Parse) -> Option<TextRange> {
    let last = parse.lines().len().checked_sub(1)?;
    let open = parse.lines()[last]
        .errors
        .iter()
        .find(|error| error.kind == SyntaxErrorKind::UnclosedComment)?;
    Some(open.range + parse.line_start(last))
}

/// Drops what a comment that is not closed has made of the text after it.
pub(crate) fn hide_what_follows(parse: &Parse, diagnostics: &mut Vec<Diagnostic>) {
    let Some(place) = parse.unclosed_comment().map(TextRange::start) else {
        return;
    };
    diagnostics.retain(|d| {
        // What a name stands for may be after the place.
        let needs_the_rest = matches!(
            d.rule,
            super::undeclared_tag::RULE
                | super::unknown_label::RULE
                | super::unknown_function::RULE
                | super::unknown_block::RULE
        );
        d.rule == RULE || (d.range.start() < place && !needs_the_rest)
    });
    for diagnostic in diagnostics {
        if diagnostic.rule != RULE {
            diagnostic
                .related
                .retain(|related| related.file.is_some() || related.range.start() < place);
        }
    }
}
