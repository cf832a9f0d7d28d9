//! The place where a `#` without a partner is shown (LANGUAGE §7).
//!
//! One `#` too few or too many turns comments and program inside out from there on, and the last `#` is rarely
//! the wrong one. The first comment that has swallowed what looks like a rung is the better guess.

use crate::builder::Builder;
use crate::error::SyntaxErrorKind;
use crate::grammar::{self, Entry};
use crate::kind::SyntaxKind;
use crate::lines::{LineList, entry_after};
use rowan::{TextRange, TextSize};
use std::ops::Range;

/// The `#` to show, if the last comment is not closed. The text is asked for in that case only.
pub(crate) fn unclosed_comment<T: AsRef<str>, L: LineList>(
    text: impl FnOnce() -> T,
    lines: &L,
) -> Option<TextRange> {
    let last = lines.count().checked_sub(1)?;
    let start = TextSize::new(lines.start(last));
    let open = lines
        .line(last)
        .errors
        .iter()
        .find(|error| error.kind == SyntaxErrorKind::UnclosedComment)?;
    let text = text();
    let first = (0..lines.count()).find_map(|line| comment_with_drawing(text.as_ref(), lines, line));
    Some(first.unwrap_or(open.range + start))
}

/// The opening `#` of the line's first comment that holds a line of a drawing.
fn comment_with_drawing<L: LineList>(text: &str, lines: &L, line: usize) -> Option<TextRange> {
    let start = lines.start(line);
    let line_text = &text[start as usize..(start + lines.line(line).len) as usize];
    // Nearly every line is one physical line.
    memchr::memchr2(b'\n', b'\r', line_text.trim_end_matches(['\n', '\r']).as_bytes())?;
    let entry = line
        .checked_sub(1)
        .map_or(Entry::START, |before| entry_after(lines.line(before)));
    let mut comments = Comments { with_drawing: None };
    grammar::line(text, start as usize, entry, &mut comments);
    comments
        .with_drawing
        .map(|comment| TextRange::at(TextSize::new(comment), TextSize::new(1)))
}

/// Looks for a comment that holds a line of a drawing.
struct Comments {
    /// Where the first such comment begins.
    with_drawing: Option<u32>,
}

impl Builder for Comments {
    type Line = ();
    type Checkpoint = ();

    fn token(&mut self, kind: SyntaxKind, text: &str, place: Range<usize>) {
        let start = place.start;
        if self.with_drawing.is_none() && kind == SyntaxKind::COMMENT && holds_drawing(&text[place]) {
            self.with_drawing = Some(start as u32);
        }
    }

    fn start_node(&mut self, _: SyntaxKind) {}

    fn checkpoint(&self) {}

    fn start_node_at(&mut self, (): (), _: SyntaxKind) {}

    fn finish_node(&mut self) {}

    fn finish_line(&mut self, _: SyntaxKind) {}
}

fn holds_drawing(comment: &str) -> bool {
    comment
        .split(['\n', '\r'])
        .skip(1)
        .any(|line| line.trim_start_matches([' ', '\t']).starts_with(['+', '|', '/']))
}
