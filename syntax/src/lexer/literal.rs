//! Where literals, strings and addresses end (LANGUAGE §3).
//!
//! Each takes in everything that a literal of its form may hold, so that a wrong literal is one token and one
//! error. What it means is for the analysis to say.

use super::word_end;

/// Where the literal ends that has begun at `at`, with a digit or a word.
pub(super) fn literal_end(text: &str, at: usize) -> usize {
    let bytes = text.as_bytes();
    let mut end = at;
    // Where the part after the last `#` begins, and what the parts before it say of it.
    let mut part = at;
    let mut date = false;
    let mut hexadecimal = false;
    loop {
        end = word_end(text, end);
        let digit_after = bytes.get(end + 1).is_some_and(u8::is_ascii_digit);
        let before = if end > at { bytes[end - 1] } else { b' ' };
        match bytes.get(end) {
            Some(b'#') if takes_hash(text, at, end) => {
                let prefix = &text[part..end];
                date = is_date_prefix(prefix);
                hexadecimal = prefix == "16";
                end += 1;
                part = end;
                // `STRING#'text'`; a text without its end is a token of its own.
                if bytes.get(end) == Some(&b'\'') && prefix.eq_ignore_ascii_case("STRING") {
                    let string = string_end(bytes, end);
                    return if is_closed_string(&text[end..string]) {
                        string
                    } else {
                        end
                    };
                }
                // `INT#-5`
                if matches!(bytes.get(end), Some(b'-' | b'+'))
                    && bytes.get(end + 1).is_some_and(u8::is_ascii_digit)
                {
                    end += 1;
                }
            }
            Some(b'.') if digit_after && before.is_ascii_alphanumeric() => end += 1,
            Some(b'-' | b':') if digit_after && date => end += 1,
            // The sign of an exponent; in hexadecimal an E is a digit.
            Some(b'-' | b'+')
                if digit_after
                    && !hexadecimal
                    && matches!(before, b'e' | b'E')
                    && is_mantissa(&text[part..end - 1]) =>
            {
                end += 1;
            }
            _ => return end,
        }
    }
}

/// The words that begin a typed literal (LANGUAGE §1): those of durations and dates, and the other elementary types.
const TIMES: [&str; 9] = [
    "T",
    "TIME",
    "LTIME",
    "D",
    "DATE",
    "TOD",
    "TIME_OF_DAY",
    "DT",
    "DATE_AND_TIME",
];
const TYPES: [&str; 16] = [
    "BOOL", "BYTE", "WORD", "DWORD", "LWORD", "SINT", "INT", "DINT", "LINT", "USINT", "UINT", "UDINT",
    "ULINT", "REAL", "LREAL", "STRING",
];

fn is_one_of(words: &[&str], word: &str) -> bool {
    words.iter().any(|known| known.eq_ignore_ascii_case(word))
}

/// Whether the `#` at `at` belongs to a literal, which would have begun at `start`: it is directly after a whole number or a
/// word that begins a typed literal, which come after no point, and has no other before it. Two has only `WORD#16#00FF`.
/// Any other `#` opens a comment, also directly after a tag.
pub(crate) fn takes_hash(text: &str, start: usize, at: usize) -> bool {
    let (before, word) = split_word(&text[start..at]);
    if word.starts_with(|c: char| !c.is_ascii_digit()) {
        let is_typed = is_one_of(&TIMES, word) || is_one_of(&TYPES, word);
        return is_typed && before.is_empty() && !is_after_point(&text[..start]);
    }
    if word.is_empty() || !word.bytes().all(|b| b.is_ascii_digit() || b == b'_') || before.ends_with('.') {
        return false;
    }
    let Some((prefix, sign)) = before.split_once('#') else {
        return !is_after_point(&text[..start]);
    };
    let has_digits = text.as_bytes().get(at + 1).is_some_and(u8::is_ascii_hexdigit);
    let is_base = matches!(sign, "" | "-" | "+") && matches!(word, "2" | "8" | "16");
    is_base && has_digits && is_one_of(&TYPES, prefix)
}

/// Whether a `.` is last in a text, and not the `..` of a range.
fn is_after_point(text: &str) -> bool {
    let text = text.trim_end_matches([' ', '\t']);
    text.ends_with('.') && !text.ends_with("..")
}

/// The letters and digits at the end of a text, and what is before them.
fn split_word(text: &str) -> (&str, &str) {
    let before = text.trim_end_matches(|c: char| c == '_' || unicode_ident::is_xid_continue(c));
    (before, &text[before.len()..])
}

fn is_date_prefix(prefix: &str) -> bool {
    ["D", "DATE", "TOD", "TIME_OF_DAY", "DT", "DATE_AND_TIME"]
        .iter()
        .any(|p| p.eq_ignore_ascii_case(prefix))
}

/// Whether the text before an `e` is digits with at most one sign before them.
fn is_mantissa(text: &str) -> bool {
    let digits = text.strip_prefix(['-', '+']).unwrap_or(text);
    digits.starts_with(|c: char| c.is_ascii_digit())
        && digits
            .bytes()
            .all(|b| b.is_ascii_digit() || b == b'.' || b == b'_')
}

/// Where the address at `at` ends.
pub(super) fn address_end(text: &str, at: usize) -> usize {
    let bytes = text.as_bytes();
    let mut end = at + 1;
    while let Some(&b) = bytes.get(end) {
        let dotted = b == b'.' && bytes.get(end + 1).is_some_and(u8::is_ascii_digit);
        if !b.is_ascii_alphanumeric() && !dotted {
            break;
        }
        end += 1;
    }
    end
}

/// Where the string that opens at `at` ends: after its closing quote, or before the line end.
pub(crate) fn string_end(bytes: &[u8], at: usize) -> usize {
    let mut end = at + 1;
    while let Some(&b) = bytes.get(end) {
        match b {
            b'\'' => return end + 1,
            b'\n' | b'\r' => return end,
            // `$'` does not end the string; a line end after `$` still does.
            b'$' if matches!(bytes.get(end + 1), Some(b'\'' | b'$')) => end += 2,
            _ => end += 1,
        }
    }
    end
}

/// Whether the text of a string token ends with its closing quote.
pub(crate) fn is_closed_string(text: &str) -> bool {
    // The lexer ends a string at its first quote that `$` does not escape, so only the end needs a look.
    let Some(inside) = text.strip_prefix('\'').and_then(|t| t.strip_suffix('\'')) else {
        return false;
    };
    let dollars = inside.bytes().rev().take_while(|&b| b == b'$').count();
    dollars % 2 == 0
}
