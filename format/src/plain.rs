//! Plain blocks, which come without entries for what they hold (see [`ladder_syntax::Builder::plain_block`]): a first
//! part with at most a mnemonic in capitals, then at most a list of words parted by commas. They are read off the
//! text, where the general walk ([`crate::pieces`]) would cost many times as much; both have the same pieces.

use crate::pieces::Piece;
use ladder_syntax::SyntaxKind::{self, *};
use std::ops::Range;

/// The mnemonic; none where the first part is blank.
pub(crate) fn head(text: &str, place: Range<usize>) -> Option<&str> {
    let bytes = text.as_bytes();
    let start = blanks_end(bytes, place.start + 1);
    let end = word_end(bytes, start);
    (end > start).then(|| &text[start..end])
}

/// The number of operands; none without a list.
pub(crate) fn operands(text: &str, place: Range<usize>) -> Option<usize> {
    let block = &text.as_bytes()[place];
    // A first part holds no parentheses but a coil's own.
    let list = block.iter().skip(1).position(|&b| b == b'(')? + 2;
    let is_empty = block[list..block.len() - 1].iter().all(|&b| is_blank(b));
    Some(if is_empty {
        0
    } else {
        block[list..].split(|&b| b == b',').count()
    })
}

/// Hands out the pieces.
pub(crate) fn pieces(text: &str, place: Range<usize>, mut give: impl FnMut(Piece)) {
    let bytes = text.as_bytes();
    let mut piece = |kind, start, end, blanks| {
        give(Piece {
            kind,
            start,
            end,
            blanks,
            capitals: false,
        });
        blanks_end(bytes, end)
    };
    let opening = place.start;
    let at = piece(bracket(bytes[opening]), opening, opening + 1, 0);
    let word = word_end(bytes, at);
    let at = if word > at {
        let closing = piece(MNEMONIC, at, word, 0);
        piece(bracket(bytes[closing]), closing, closing + 1, 0)
    } else {
        piece(bracket(bytes[at]), at, at + 1, 1)
    };
    if at >= place.end {
        return;
    }
    let mut at = piece(L_PAREN, at, at + 1, 0);
    while at < place.end {
        at = match bytes[at] {
            b',' => piece(COMMA, at, at + 1, 0),
            b')' => piece(R_PAREN, at, at + 1, 1),
            _ => piece(IDENT, at, word_end(bytes, at), 1),
        };
    }
}

/// Whether all pieces are where they belong.
pub(crate) fn is_canonical(block: &[u8]) -> bool {
    let byte = |at: usize| block.get(at).copied().unwrap_or(0);
    let closing = match byte(1) {
        b' ' => 2,
        _ => word_end(block, 1),
    };
    if closing + 1 == block.len() {
        return closing > 1;
    }
    if is_blank(byte(closing)) || byte(closing + 1) != b'(' || byte(closing + 2) != b' ' {
        return false;
    }
    if closing == 1 {
        return false;
    }
    let mut at = closing + 3;
    if byte(at) == b')' {
        return true;
    }
    loop {
        let end = word_end(block, at);
        match (end > at, byte(end), byte(end + 1)) {
            (true, b',', b' ') => at = end + 2,
            (true, b' ', b')') => return true,
            _ => return false,
        }
    }
}

fn bracket(byte: u8) -> SyntaxKind {
    match byte {
        b'[' => L_BRACKET,
        b']' => R_BRACKET,
        b'(' => L_PAREN,
        b')' => R_PAREN,
        b'<' => L_ANGLE,
        _ => R_ANGLE,
    }
}

fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t')
}

fn blanks_end(bytes: &[u8], at: usize) -> usize {
    let rest = &bytes[at..];
    at + rest.iter().position(|&b| !is_blank(b)).unwrap_or(rest.len())
}

/// Where the word ends that begins at `at`: before blanks, a comma or a bracket.
fn word_end(bytes: &[u8], at: usize) -> usize {
    let is_end = |b: u8| matches!(b, b' ' | b'\t' | b',' | b'(' | b')' | b'[' | b']' | b'<' | b'>');
    let rest = &bytes[at..];
    at + rest.iter().position(|&b| is_end(b)).unwrap_or(rest.len())
}
