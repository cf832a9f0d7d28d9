//! Where a bracket that was never closed ends.
//!
//! An error must not take the rest of the rung with it: an operand list without its `)` ends where the drawing
//! goes on. But `-`, `+`, `[` and `/` also are in expressions, so these guesses are made only where the
//! parentheses of the line do not pair: in text without errors nothing is ever guessed.

use super::Parser;
use crate::builder::Builder;
use crate::conflict::OpenConflicts;
use crate::kind::SyntaxKind;
use crate::lexer;

/// The operand list that is being read.
#[derive(Default)]
pub(super) struct OpenList {
    /// Its opening parenthesis.
    start: usize,
    /// Whether it lacks its closing one, once that was asked.
    unclosed: Option<bool>,
    /// The opening parentheses of the line without a partner, from the first list on that asked. One pass for
    /// a line, however many of its lists are not closed.
    unmatched: Option<Vec<usize>>,
}

impl OpenList {
    /// Begins another list.
    pub(super) fn begin(&mut self, start: usize) {
        self.start = start;
        self.unclosed = None;
    }
}

impl<B: Builder> Parser<'_, '_, B> {
    /// Whether the operand list that is being read lacks its closing parenthesis.
    pub(super) fn list_is_unclosed(&mut self) -> bool {
        if self.free_form {
            return false;
        }
        let (text, list) = (self.text, &mut self.list);
        *list.unclosed.get_or_insert_with(|| {
            let unmatched = list
                .unmatched
                .get_or_insert_with(|| unmatched_parentheses(text, list.start));
            unmatched.binary_search(&list.start).is_ok()
        })
    }

    /// Whether the operands end at the token ahead without their closing bracket: at the line's end, or where
    /// an unclosed list meets the drawing.
    pub(super) fn drawing_goes_on(&mut self) -> bool {
        match self.ahead.kind {
            SyntaxKind::EOF | SyntaxKind::NEWLINE => true,
            SyntaxKind::RAIL | SyntaxKind::DOWN => self.list_is_unclosed(),
            SyntaxKind::MINUS => begins_wire(self.text, self.ahead.start) && self.list_is_unclosed(),
            SyntaxKind::PLUS => ends_line(self.text, self.ahead.end) && self.list_is_unclosed(),
            SyntaxKind::L_BRACKET => {
                (self.ahead.start > self.at || begins_block(self.text, self.ahead.start))
                    && self.list_is_unclosed()
            }
            SyntaxKind::L_PAREN => begins_block(self.text, self.ahead.start) && self.list_is_unclosed(),
            _ => false,
        }
    }
}

/// The opening parentheses without a partner on the line, from `at` (on a rung) on.
fn unmatched_parentheses(text: &str, at: usize) -> Vec<usize> {
    let bytes = text.as_bytes();
    let mut open = Vec::new();
    let mut at = at;
    while let Some(&byte) = bytes.get(at) {
        match byte {
            b'\n' | b'\r' => break,
            b'(' => open.push(at),
            b')' => {
                open.pop();
            }
            b'\'' if !open.is_empty() => {
                at = lexer::string_end(bytes, at);
                continue;
            }
            // Inside parentheses a `#` may belong to a literal.
            b'#' if open.is_empty() || !lexer::takes_hash(text, word_start(text, at), at) => {
                let end = lexer::comment_end(bytes, at, OpenConflicts::default());
                // After a comment over lines this may be another line: nothing is known, and nothing guessed.
                if memchr::memchr2(b'\n', b'\r', &bytes[at..end]).is_some() {
                    return Vec::new();
                }
                at = end;
                continue;
            }
            _ => {}
        }
        at += 1;
    }
    open
}

/// Where the word or literal begins that ends at a place, with at most one `#` in it.
fn word_start(text: &str, at: usize) -> usize {
    let is_inside = |c: char| c.is_alphanumeric() || matches!(c, '_' | '.' | ':' | '-' | '+');
    let last = text[..at].trim_end_matches(is_inside);
    let before = last.strip_suffix('#').unwrap_or(last);
    before.trim_end_matches(is_inside).len()
}

/// Whether the dashes at `at`, in a list that is not closed, are wire and not a sign.
fn begins_wire(text: &str, at: usize) -> bool {
    let bytes = text.as_bytes();
    match bytes.get(at + 1) {
        Some(b'-' | b'[' | b'\\' | b'|' | b'+' | b'/' | b'<') => true,
        Some(b'(') => begins_block(text, at + 1),
        _ => ends_line(text, at + 1),
    }
}

/// Whether nothing but blanks and rails is between `at` and the line's end.
fn ends_line(text: &str, at: usize) -> bool {
    let rest = text[at..].trim_start_matches([' ', '\t', '|']);
    rest.is_empty() || rest.starts_with(['\n', '\r'])
}

/// Whether the bracket at `at` begins a block with an operand list: at most one word in the first part, and a
/// parenthesis after it.
fn begins_block(text: &str, at: usize) -> bool {
    let bytes = text.as_bytes();
    let close = match bytes.get(at) {
        Some(b'[') => b']',
        _ => b')',
    };
    let inside = lexer::blanks_end(bytes, at + 1);
    let word = match lexer::in_head(text, inside, OpenConflicts::default()) {
        (SyntaxKind::MNEMONIC | SyntaxKind::BLOCK_NAME, end) => end,
        _ => inside,
    };
    let closing = lexer::blanks_end(bytes, word);
    bytes.get(closing) == Some(&close) && bytes.get(lexer::blanks_end(bytes, closing + 1)) == Some(&b'(')
}

/// How far a first part or an index is searched for its closing bracket.
const REACH: usize = 64;

/// Where the closing bracket is, if what is before it on the line is not drawing or another list. Then
/// that is no lack of a bracket, but characters that mean nothing.
pub(super) fn closing_after_junk(text: &str, at: usize, closing: u8) -> Option<usize> {
    let end = text.len().min(at + REACH);
    let found = text.as_bytes()[at..end].iter().position(|&b| {
        b == closing
            || matches!(
                b,
                b'(' | b')' | b'[' | b'\\' | b'|' | b'#' | b'\'' | b'\n' | b'\r'
            )
    })?;
    (text.as_bytes()[at + found] == closing).then_some(at + found)
}
