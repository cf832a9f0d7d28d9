//! The lexer: which token begins at a place, given what surrounds it.
//!
//! The same character means different things on a rung, in a block's first part and among operands (`/` is a
//! connector, a mnemonic or a division), so the parser says in which [`Context`] it reads.

use crate::SyntaxKind::{self, *};

/// Where a token stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Context {
    /// On a line, outside blocks.
    Rung,
    /// In a block's first part.
    Head,
    /// In an operand list or a declaration. Only here a `#` may belong to a literal (LANGUAGE §1).
    Operand,
}

/// The kind of the token at `at`, and where it ends. `(EOF, at)` at the end of the text.
pub(crate) fn token(text: &str, at: usize, context: Context) -> (SyntaxKind, usize) {
    let bytes = text.as_bytes();
    let Some(&first) = bytes.get(at) else {
        return (EOF, at);
    };
    match first {
        b' ' | b'\t' => (WHITESPACE, run(bytes, at, |b| b == b' ' || b == b'\t')),
        b'\n' => (NEWLINE, at + 1),
        b'\r' => (
            NEWLINE,
            if bytes.get(at + 1) == Some(&b'\n') {
                at + 2
            } else {
                at + 1
            },
        ),
        b'#' => (COMMENT, comment_end(bytes, at)),
        _ => match context {
            Context::Rung => rung_token(text, at, first),
            Context::Head => head_token(text, at, first),
            Context::Operand => operand_token(text, at, first),
        },
    }
}

/// Where the comment that opens at `at` ends: behind the very next `#`, or at the end of the text.
fn comment_end(bytes: &[u8], at: usize) -> usize {
    memchr::memchr(b'#', &bytes[at + 1..]).map_or(bytes.len(), |n| at + 1 + n + 1)
}

/// Whether the comment text `# .. #` has its closing `#`.
pub(crate) fn is_closed_comment(text: &str) -> bool {
    text.len() > 1 && text.ends_with('#')
}

fn rung_token(text: &str, at: usize, first: u8) -> (SyntaxKind, usize) {
    let kind = match first {
        b'-' => return (WIRE, run(text.as_bytes(), at, |b| b == b'-')),
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
        _ => return word_or_error(text, at, IDENT),
    };
    (kind, at + 1)
}

fn head_token(text: &str, at: usize, first: u8) -> (SyntaxKind, usize) {
    match first {
        b'/' => (MNEMONIC, at + 1),
        b'$' => match identifier_end(text, at + 1) {
            Some(end) => (BLOCK_NAME, end),
            None => (ERROR, at + 1),
        },
        b'-' | b'+' | b'|' | b'\\' | b'[' | b']' | b'(' | b')' | b'<' | b'>' => rung_token(text, at, first),
        _ => word_or_error(text, at, MNEMONIC),
    }
}

fn word_or_error(text: &str, at: usize, word: SyntaxKind) -> (SyntaxKind, usize) {
    match identifier_end(text, at) {
        Some(end) => (word, end),
        None => (ERROR, error_end(text, at)),
    }
}

/// A run of characters that mean nothing, as one token: one mistake, not one for each letter.
fn error_end(text: &str, at: usize) -> usize {
    let means_something = |c: char| {
        matches!(
            c,
            ' ' | '\t'
                | '\n'
                | '\r'
                | '#'
                | '-'
                | '+'
                | '|'
                | '\\'
                | '/'
                | '['
                | ']'
                | '('
                | ')'
                | '<'
                | '>'
                | ','
                | ';'
                | '$'
                | '\''
        ) || is_start(c)
            || c.is_ascii_digit()
    };
    let mut chars = text[at..].char_indices();
    chars.next();
    chars
        .find(|&(_, c)| means_something(c))
        .map_or(text.len(), |(n, _)| at + n)
}

fn operand_token(text: &str, at: usize, first: u8) -> (SyntaxKind, usize) {
    let bytes = text.as_bytes();
    let second = bytes.get(at + 1).copied();
    let (kind, len) = match (first, second) {
        (b',', _) => (COMMA, 1),
        (b';', _) => (SEMICOLON, 1),
        (b':', Some(b'=')) => (ASSIGN, 2),
        (b':', _) => (COLON, 1),
        (b'=', Some(b'>')) => (ARROW, 2),
        (b'=', _) => (EQUAL, 1),
        (b'.', Some(b'.')) => (DOT_DOT, 2),
        (b'.', _) => (DOT, 1),
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
        (b'[', _) => (L_BRACKET, 1),
        (b']', _) => (R_BRACKET, 1),
        (b'(', _) => (L_PAREN, 1),
        (b')', _) => (R_PAREN, 1),
        (b'|', _) => (RAIL, 1),
        (b'\\', _) => (DOWN, 1),
        (b'\'', _) => return (STRING, string_end(bytes, at)),
        (b'%', Some(b)) if b.is_ascii_alphabetic() => return (ADDRESS, address_end(bytes, at)),
        (b'0'..=b'9', _) => return (LITERAL, literal_end(text, at)),
        _ => return operand_word(text, at),
    };
    (kind, at + len)
}

/// A name, a word operator, TRUE or FALSE; or a literal when a `#` stands directly behind a letter or digit.
fn operand_word(text: &str, at: usize) -> (SyntaxKind, usize) {
    let Some(end) = identifier_end(text, at) else {
        return (ERROR, error_end(text, at));
    };
    let word = &text[at..end];
    let before_hash = text.as_bytes().get(end) == Some(&b'#');
    if before_hash && word.ends_with(char::is_alphanumeric) {
        return (LITERAL, literal_end(text, at));
    }
    (word_kind(word), end)
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

/// Where the string that opens at `at` ends: behind its closing quote, or before the line end.
fn string_end(bytes: &[u8], at: usize) -> usize {
    let mut i = at + 1;
    while let Some(&b) = bytes.get(i) {
        match b {
            b'\'' => return i + 1,
            b'\n' | b'\r' => return i,
            // `$'` does not end the string; a line end behind `$` still does.
            b'$' if matches!(bytes.get(i + 1), Some(b'\'' | b'$')) => i += 2,
            _ => i += 1,
        }
    }
    i
}

fn address_end(bytes: &[u8], at: usize) -> usize {
    let mut i = at + 1;
    while let Some(&b) = bytes.get(i) {
        let dotted = b == b'.' && bytes.get(i + 1).is_some_and(u8::is_ascii_digit);
        if !b.is_ascii_alphanumeric() && !dotted {
            break;
        }
        i += 1;
    }
    i
}

/// Where the literal at `at` ends. Takes in everything that a literal of LANGUAGE §3 may hold, so that a wrong
/// literal is one token and one mistake.
fn literal_end(text: &str, at: usize) -> usize {
    let bytes = text.as_bytes();
    let mut end = at;
    let mut date = false;
    let mut hexadecimal = false;
    while let Some(c) = text[end..].chars().next() {
        let previous = text[at..end].chars().next_back();
        let next = bytes.get(end + c.len_utf8()).copied();
        let takes = match c {
            '#' if previous.is_some_and(char::is_alphanumeric) => {
                let prefix = text[at..end].rsplit('#').next().unwrap_or("");
                date = is_date_prefix(prefix);
                hexadecimal = prefix == "16";
                true
            }
            '.' => {
                previous.is_some_and(|p| p.is_ascii_alphanumeric())
                    && next.is_some_and(|b| b.is_ascii_digit())
            }
            '-' | '+' if previous == Some('#') => next.is_some_and(|b| b.is_ascii_digit()),
            '-' | ':' if date => next.is_some_and(|b| b.is_ascii_digit()),
            // The sign of an exponent; in hexadecimal an E is a digit.
            '-' | '+' => {
                !hexadecimal
                    && matches!(previous, Some('e' | 'E'))
                    && next.is_some_and(|b| b.is_ascii_digit())
                    && is_mantissa(&text[at..end - 1])
            }
            _ => unicode_ident::is_xid_continue(c),
        };
        if !takes {
            break;
        }
        end += c.len_utf8();
    }
    end
}

fn is_date_prefix(prefix: &str) -> bool {
    ["D", "DATE", "TOD", "TIME_OF_DAY", "DT", "DATE_AND_TIME"]
        .iter()
        .any(|p| p.eq_ignore_ascii_case(prefix))
}

/// Whether the text before an `e` is digits with at most one point, a typed prefix aside.
fn is_mantissa(text: &str) -> bool {
    let digits = text.rsplit('#').next().unwrap_or(text);
    digits.starts_with(|c: char| c.is_ascii_digit() || c == '-' || c == '+')
        && digits
            .chars()
            .skip(1)
            .all(|c| c.is_ascii_digit() || c == '.' || c == '_')
}

fn is_start(c: char) -> bool {
    c == '_' || unicode_ident::is_xid_start(c)
}

/// Where the identifier at `at` ends (XID_Start or `_`, then XID_Continue); none if none begins there.
pub(crate) fn identifier_end(text: &str, at: usize) -> Option<usize> {
    let bytes = text.as_bytes();
    // Nearly every name is ASCII; the rest goes through the tables.
    let mut end = run(bytes, at, |b| b.is_ascii_alphanumeric() || b == b'_');
    if end == bytes.len() || bytes[end].is_ascii() {
        return (end > at && !bytes[at].is_ascii_digit()).then_some(end);
    }
    let mut chars = text[at..].chars();
    if !chars.next().is_some_and(is_start) {
        return None;
    }
    for c in text[end..].chars() {
        if !unicode_ident::is_xid_continue(c) {
            break;
        }
        end += c.len_utf8();
    }
    (end > at).then_some(end)
}

fn run(bytes: &[u8], at: usize, belongs: impl Fn(u8) -> bool) -> usize {
    at + bytes[at..]
        .iter()
        .position(|&b| !belongs(b))
        .unwrap_or(bytes.len() - at)
}
