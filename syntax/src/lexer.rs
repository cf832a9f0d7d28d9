//! The lexer: which token begins at a place.
//!
//! The same character means different things on a rung, in a block's first part and among operands (`/` is a
//! connector, a mnemonic or a division), so the parser asks the function of the place where it reads. All of
//! them look at each character once, and none looks past the end of its token by more than two characters.

mod literal;

pub(crate) use literal::{is_closed_string, string_end, takes_hash};

use crate::conflict::{self, OpenConflicts};
use crate::kind::SyntaxKind::{self, *};
use literal::{address_end, literal_end};

/// A token: its kind, and where it ends.
pub(crate) type Token = (SyntaxKind, usize);

/// The white space, line end or comment at `at`, if one begins there.
pub(crate) fn space(text: &str, at: usize, open: OpenConflicts) -> Option<Token> {
    let bytes = text.as_bytes();
    Some(match bytes.get(at)? {
        b' ' | b'\t' => (WHITESPACE, blanks_end(bytes, at)),
        b'\n' | b'\r' => (NEWLINE, newline_end(bytes, at)),
        b'#' => (COMMENT, comment_end(bytes, at, open)),
        _ => return None,
    })
}

/// The token at `at` on a line, outside blocks. `(EOF, at)` at the end of the text. Words, and whatever else has
/// no meaning there, are `ERROR`.
pub(crate) fn on_rung(text: &str, at: usize, open: OpenConflicts) -> Token {
    let bytes = text.as_bytes();
    let Some(&first) = bytes.get(at) else {
        return (EOF, at);
    };
    let kind = match first {
        b' ' | b'\t' => return (WHITESPACE, blanks_end(bytes, at)),
        b'-' => return (WIRE, run(bytes, at, |b| b == b'-')),
        b'\n' | b'\r' => return (NEWLINE, newline_end(bytes, at)),
        b'#' => return (COMMENT, comment_end(bytes, at, open)),
        b'+' => RAIL_CONNECTOR,
        b'|' => RAIL,
        b'\\' => DOWN,
        b'/' => UP,
        b'[' => L_BRACKET,
        b']' => R_BRACKET,
        b'(' => L_PAREN,
        b')' => R_PAREN,
        b'<' => L_ANGLE,
        b'>' => R_ANGLE,
        // One error, not one for each letter.
        _ => return (ERROR, run(bytes, at, |b| !is_drawing(b))),
    };
    (kind, at + 1)
}

/// Whether the byte means something on a rung: white space, a comment or a part of the drawing.
const fn is_drawing(byte: u8) -> bool {
    matches!(
        byte,
        b' ' | b'\t'
            | b'\n'
            | b'\r'
            | b'#'
            | b'-'
            | b'+'
            | b'|'
            | b'\\'
            | b'/'
            | b'['
            | b']'
            | b'('
            | b')'
            | b'<'
            | b'>'
    )
}

/// The token at `at` in a block's first part. Brackets, comments and white space are as on a rung.
pub(crate) fn in_head(text: &str, at: usize, open: OpenConflicts) -> Token {
    match text.as_bytes().get(at) {
        Some(b'/') => (MNEMONIC, at + 1),
        Some(b'$') => match identifier_end(text, at + 1) {
            Some(end) => (BLOCK_NAME, end),
            None => on_rung(text, at, open),
        },
        _ => match identifier_end(text, at) {
            Some(end) => (MNEMONIC, end),
            None => on_rung(text, at, open),
        },
    }
}

/// The token at `at` in an operand list or a declaration. Only here a `#` may belong to a literal (LANGUAGE §1).
pub(crate) fn in_operands(text: &str, at: usize, open: OpenConflicts) -> Token {
    let bytes = text.as_bytes();
    let Some(&first) = bytes.get(at) else {
        return (EOF, at);
    };
    let second = bytes.get(at + 1).copied();
    let (kind, len) = match (first, second) {
        (b' ' | b'\t', _) => return (WHITESPACE, blanks_end(bytes, at)),
        (b'A'..=b'Z' | b'a'..=b'z' | b'_' | 0x80.., _) => return word(text, at),
        (b'0'..=b'9', _) => return (LITERAL, literal_end(text, at)),
        (b'\n' | b'\r', _) => return (NEWLINE, newline_end(bytes, at)),
        (b'#', _) => return (COMMENT, comment_end(bytes, at, open)),
        (b',', _) => (COMMA, 1),
        (b')', _) => (R_PAREN, 1),
        (b'(', _) => (L_PAREN, 1),
        (b'[', _) => (L_BRACKET, 1),
        (b']', _) => (R_BRACKET, 1),
        (b'.', Some(b'.')) => (DOT_DOT, 2),
        (b'.', _) => (DOT, 1),
        (b':', Some(b'=')) => (ASSIGN, 2),
        (b':', _) => (COLON, 1),
        (b';', _) => (SEMICOLON, 1),
        (b'=', Some(b'>')) => (ARROW, 2),
        (b'=', _) => (EQUAL, 1),
        (b'<', Some(b'>')) => (NOT_EQUAL, 2),
        (b'<', Some(b'=')) => (LESS_EQUAL, 2),
        (b'<', _) => (LESS, 1),
        (b'>', Some(b'=')) => (GREATER_EQUAL, 2),
        (b'>', _) => (GREATER, 1),
        (b'+', _) => (PLUS, 1),
        (b'-', _) => (MINUS, 1),
        (b'*', _) => (STAR, 1),
        (b'/', _) => (SLASH, 1),
        (b'^', _) => (CARET, 1),
        (b'|', _) => (RAIL, 1),
        (b'\\', _) => (DOWN, 1),
        (b'\'', _) => return (STRING, string_end(bytes, at)),
        (b'%', Some(b)) if b.is_ascii_alphabetic() => return (ADDRESS, address_end(text, at)),
        _ => return (ERROR, junk_end(text, at)),
    };
    (kind, at + len)
}

/// Whether the text is one literal, without a sign: a number, `TRUE`, `T#5s`, `'text'`. What it means is for the analysis
/// to say.
pub fn is_literal(text: &str) -> bool {
    match in_operands(text, 0, OpenConflicts::default()) {
        (STRING, end) => end == text.len() && is_closed_string(text),
        (kind, end) => kind == LITERAL && end == text.len(),
    }
}

/// Whether the text is one direct address: `%IX0.3`.
pub fn is_address(text: &str) -> bool {
    in_operands(text, 0, OpenConflicts::default()) == (ADDRESS, text.len())
}

/// A name, a word operator, TRUE or FALSE; or a literal when a `#` that belongs to it is directly after it.
fn word(text: &str, at: usize) -> Token {
    let Some(end) = identifier_end(text, at) else {
        return (ERROR, junk_end(text, at));
    };
    if text.as_bytes().get(end) == Some(&b'#') && takes_hash(text, at, end) {
        return (LITERAL, literal_end(text, at));
    }
    (word_kind(&text[at..end]), end)
}

fn word_kind(word: &str) -> SyntaxKind {
    const OPERATORS: [&str; 7] = ["AND", "OR", "XOR", "NOT", "MOD", "SHL", "SHR"];
    match word.len() {
        2 | 3 if OPERATORS.iter().any(|o| o.eq_ignore_ascii_case(word)) => WORD_OPERATOR,
        4 if word.eq_ignore_ascii_case("TRUE") => LITERAL,
        5 if word.eq_ignore_ascii_case("FALSE") => LITERAL,
        _ => IDENT,
    }
}

/// Where a run of characters ends that mean nothing among operands: one error, not one for each letter.
fn junk_end(text: &str, at: usize) -> usize {
    let mut chars = text[at..].char_indices();
    chars.next();
    chars
        .find(|&(_, c)| {
            if c.is_ascii() {
                is_operand_character(c as u8)
            } else {
                is_start(c)
            }
        })
        .map_or(text.len(), |(n, _)| at + n)
}

/// Whether the ASCII character means something among operands.
const fn is_operand_character(byte: u8) -> bool {
    byte.is_ascii_alphanumeric()
        || matches!(
            byte,
            b'_' | b' '
                | b'\t'
                | b'\n'
                | b'\r'
                | b'#'
                | b','
                | b'('
                | b')'
                | b'['
                | b']'
                | b'.'
                | b':'
                | b';'
                | b'='
        )
        || matches!(
            byte,
            b'<' | b'>' | b'+' | b'-' | b'*' | b'/' | b'^' | b'|' | b'\\' | b'\'' | b'%'
        )
}

/// Where the comment that opens at `at` ends: after the very next `#`, or at the end of the text.
pub(crate) fn comment_end(bytes: &[u8], at: usize, open: OpenConflicts) -> usize {
    let end = memchr::memchr(b'#', &bytes[at + 1..]).map_or(bytes.len(), |n| at + 1 + n + 1);
    if spans_lines(&bytes[at..end]) {
        return conflict::comment(bytes, at, open).end;
    }
    end
}

/// Whether a line end is in a comment.
pub(crate) fn spans_lines(comment: &[u8]) -> bool {
    memchr::memchr2(b'\n', b'\r', comment).is_some()
}

/// Whether the comment text `# .. #` has its closing `#`.
pub(crate) fn is_closed_comment(text: &str) -> bool {
    text.len() > 1 && text.ends_with('#')
}

/// Where the blanks and tabs at `at` end.
pub(crate) fn blanks_end(bytes: &[u8], at: usize) -> usize {
    run(bytes, at, |b| b == b' ' || b == b'\t')
}

/// Where the line end at `at` ends: LF, CRLF, or a lone CR.
fn newline_end(bytes: &[u8], at: usize) -> usize {
    if bytes[at] == b'\r' && bytes.get(at + 1) == Some(&b'\n') {
        at + 2
    } else {
        at + 1
    }
}

fn is_start(c: char) -> bool {
    c == '_' || unicode_ident::is_xid_start(c)
}

/// Where the identifier at `at` ends (XID_Start or `_`, then XID_Continue); none if none begins there.
pub(crate) fn identifier_end(text: &str, at: usize) -> Option<usize> {
    match text.as_bytes().get(at)? {
        b'A'..=b'Z' | b'a'..=b'z' | b'_' => {}
        0x80.. if text[at..].starts_with(is_start) => {}
        _ => return None,
    }
    Some(word_end(text, at))
}

/// Where a run of characters that may be in an identifier ends.
pub(crate) fn word_end(text: &str, at: usize) -> usize {
    // Nearly every name is ASCII; the rest goes through the tables.
    let bytes = text.as_bytes();
    let mut end = ascii_word_end(bytes, at);
    if bytes.get(end).is_none_or(u8::is_ascii) {
        return end;
    }
    for c in text[end..].chars() {
        if !unicode_ident::is_xid_continue(c) {
            break;
        }
        end += c.len_utf8();
    }
    end
}

/// Where a run of ASCII letters, digits and `_` ends.
pub(crate) fn ascii_word_end(bytes: &[u8], at: usize) -> usize {
    // Most of a program is names: one look into a table for each of their letters.
    const IN_WORDS: [bool; 256] = {
        let mut table = [false; 256];
        let mut byte = 0;
        while byte < 256 {
            table[byte] = (byte as u8).is_ascii_alphanumeric() || byte as u8 == b'_';
            byte += 1;
        }
        table
    };
    run(bytes, at, |b| IN_WORDS[b as usize])
}

/// Where the run of bytes from `at` on ends that belong to it.
fn run(bytes: &[u8], at: usize, belongs: impl Fn(u8) -> bool) -> usize {
    let mut end = at;
    while end < bytes.len() && belongs(bytes[end]) {
        end += 1;
    }
    end
}
