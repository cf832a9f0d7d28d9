//! Plain blocks: nearly all blocks of a program are a mnemonic and a few names and numbers, `[TON]( t1, T#5s )`; and plain
//! declarations: `start, stop : BOOL;`. They have one reading, without errors, and their end is found without taking them
//! apart.
//!
//! Only a [`Builder`](crate::Builder) that can do without their tokens asks. What is recognized here is a part of
//! what [`block`](super::block) and [`declaration`](super::declaration) read, with the same end; in doubt it is not
//! recognized.

use super::declaration::keyword_at;
use crate::lexer::{ascii_word_end as word_end, blanks_end, takes_hash};

/// Words that are not names, or that have a meaning of their own among operands.
const SPECIAL: [&str; 13] = [
    "EN", "OR", "PI", "AND", "ENO", "MOD", "NOT", "SHL", "SHR", "SYS", "XOR", "TRUE", "FALSE",
];

/// Where the plain block ends that begins with the bracket at `at`, if one does.
pub(super) fn plain_block(text: &str, at: usize) -> Option<usize> {
    let bytes = text.as_bytes();
    let byte = |at: usize| bytes.get(at).copied().unwrap_or(0);
    let closing = match byte(at) {
        b'[' => b']',
        b'(' => b')',
        _ => b'>',
    };
    let head = blanks_end(bytes, at + 1);
    let head_end = match byte(head) {
        b'/' => head + 1,
        b'A'..=b'Z' => run_of(bytes, head, |b| {
            b.is_ascii_uppercase() || b.is_ascii_digit() || b == b'_'
        }),
        _ => head,
    };
    let close = blanks_end(bytes, head_end);
    // The operator of a search is a word of the language.
    if byte(close) != closing || &bytes[head..head_end] == b"SEARCH" {
        return None;
    }
    let end = close + 1;
    let list = blanks_end(bytes, end);
    if byte(list) != b'(' {
        return Some(end);
    }
    let mut at = blanks_end(bytes, list + 1);
    if byte(at) == b')' {
        return Some(at + 1);
    }
    loop {
        at = blanks_end(bytes, operand_end(text, at)?);
        match byte(at) {
            b',' => at = blanks_end(bytes, at + 1),
            b')' => return Some(at + 1),
            _ => return None,
        }
    }
}

/// Where the plain declaration ends that begins with the name at `at`, if one does: names and the name of a type.
pub(super) fn plain_declaration(text: &str, at: usize) -> Option<usize> {
    let bytes = text.as_bytes();
    let mut at = at;
    loop {
        let after = blanks_end(bytes, plain_name_end(text, at)?);
        at = blanks_end(bytes, after + 1);
        match bytes.get(after)? {
            b',' => {}
            b':' => break,
            _ => return None,
        }
    }
    let end = plain_name_end(text, at)?;
    // An array goes on, and so does a structure.
    if bytes[at..end].eq_ignore_ascii_case(b"ARRAY") || bytes[at..end].eq_ignore_ascii_case(b"STRUCT") {
        return None;
    }
    let semicolon = blanks_end(bytes, end);
    (bytes.get(semicolon) == Some(&b';')).then_some(semicolon + 1)
}

/// Where the name ends that begins here, if it can be declared.
fn plain_name_end(text: &str, at: usize) -> Option<usize> {
    let bytes = text.as_bytes();
    if !matches!(bytes.get(at)?, b'A'..=b'Z' | b'a'..=b'z' | b'_') {
        return None;
    }
    let end = word_end(bytes, at);
    let is_plain = !is_special(&bytes[at..end]) && keyword_at(text, at).is_none();
    is_plain.then_some(end)
}

/// Where the name, member (`t1.Q`), number (`-5`, `2.5`) or typed literal (`T#5s`) ends that begins here. What follows
/// it must be a blank, a comma or the list's end, which is for the caller to see.
fn operand_end(text: &str, at: usize) -> Option<usize> {
    let bytes = text.as_bytes();
    let byte = |at: usize| bytes.get(at).copied().unwrap_or(0);
    let mut end = word_end(bytes, at);
    match byte(at) {
        b'0'..=b'9' => end = number_end(bytes, end),
        b'-' if byte(at + 1).is_ascii_digit() => return Some(number_end(bytes, word_end(bytes, at + 1))),
        b'A'..=b'Z' | b'a'..=b'z' | b'_' if !is_special(&bytes[at..end]) => {
            while byte(end) == b'.' {
                let member = end + 1;
                end = word_end(bytes, member);
                // A number after the point may go on after another point.
                if !byte(member).is_ascii_alphabetic() || is_special(&bytes[member..end]) {
                    return None;
                }
            }
        }
        _ => return None,
    }
    if byte(end) == b'#' {
        let value = end + 1;
        let is_literal = takes_hash(text, at, end);
        end = number_end(bytes, word_end(bytes, value));
        return (is_literal && end > value).then_some(end);
    }
    Some(end)
}

/// Where a number ends whose whole part ends at `at`.
fn number_end(bytes: &[u8], at: usize) -> usize {
    let mut end = at;
    while bytes.get(end) == Some(&b'.')
        && bytes[end - 1].is_ascii_alphanumeric()
        && bytes.get(end + 1).is_some_and(u8::is_ascii_digit)
    {
        end = word_end(bytes, end + 1);
    }
    end
}

fn is_special(word: &[u8]) -> bool {
    word.len() <= 5
        && SPECIAL
            .iter()
            .any(|special| special.as_bytes().eq_ignore_ascii_case(word))
}

fn run_of(bytes: &[u8], at: usize, belongs: impl Fn(u8) -> bool) -> usize {
    let mut end = at;
    while bytes.get(end).is_some_and(|&b| belongs(b)) {
        end += 1;
    }
    end
}
