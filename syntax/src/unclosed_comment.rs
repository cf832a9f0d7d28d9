//! The place where a `#` without a partner is shown (LANGUAGE §7).
//!
//! One `#` too few or too many turns comments and program inside out from there on, and the last `#` is rarely
//! the wrong one. The first comment that has swallowed what looks like a rung is the better guess.

use crate::line::Line;
use crate::{NodeOrToken, SyntaxErrorKind, SyntaxKind};
use rowan::{TextRange, TextSize};

/// The `#` to show, if the last comment is not closed.
pub(crate) fn unclosed_comment(text: &str, lines: &[Line], starts: &[u32]) -> Option<TextRange> {
    let last = lines.last()?;
    let start = TextSize::new(starts[lines.len() - 1]);
    let open = last
        .errors
        .iter()
        .find(|error| error.kind == SyntaxErrorKind::UnclosedComment)?;
    let first = lines
        .iter()
        .zip(starts)
        .find_map(|(line, &start)| comment_with_drawing(text, line, start));
    Some(first.unwrap_or(open.range + start))
}

/// The opening `#` of the line's first comment that holds a line of a drawing.
fn comment_with_drawing(text: &str, line: &Line, start: u32) -> Option<TextRange> {
    let line_text = &text[start as usize..(start + line.len) as usize];
    // Nearly every line is one physical line.
    memchr::memchr2(b'\n', b'\r', line_text.trim_end_matches(['\n', '\r']).as_bytes())?;
    line.syntax()
        .descendants_with_tokens()
        .filter_map(NodeOrToken::into_token)
        .filter(|token| token.kind() == SyntaxKind::COMMENT)
        .find(|comment| holds_drawing(comment.text()))
        .map(|comment| {
            TextRange::at(
                comment.text_range().start() + TextSize::new(start),
                TextSize::new(1),
            )
        })
}

fn holds_drawing(comment: &str) -> bool {
    comment
        .split(['\n', '\r'])
        .skip(1)
        .any(|line| line.trim_start_matches([' ', '\t']).starts_with(['+', '|', '/']))
}
