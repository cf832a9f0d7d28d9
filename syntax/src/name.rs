//! Names: two spellings that mean one thing.

use smol_str::SmolStr;
use std::borrow::Cow;
use unicode_normalization::{UnicodeNormalization, is_nfc_quick};

/// A name as it is compared: NFC, then simple case folding (LANGUAGE §1); the numbers of a direct address without the
/// zeros before them, so that `%QX00.0` is `%QX0.0`. How a person wrote it is kept elsewhere.
#[derive(Debug, Clone, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Name(SmolStr);

impl Name {
    /// The name that `text` spells.
    pub fn new(text: &str) -> Name {
        if text.is_ascii() {
            return Name(lower(&without_leading_zeros(text)));
        }
        let normal = if is_nfc_quick(text.chars()) == unicode_normalization::IsNormalized::Yes {
            text.to_owned()
        } else {
            text.nfc().collect()
        };
        let folded: String = normal.chars().map(fold).collect();
        Name(folded.into())
    }

    /// The folded text. Not for display.
    pub fn as_str(&self) -> &str {
        &self.0
    }
}

/// An address whose numbers have no zeros before them; any other name as it is.
fn without_leading_zeros(text: &str) -> Cow<'_, str> {
    let is_superfluous = |pair: &[u8]| pair[0] == b'0' && pair[1].is_ascii_digit();
    if !text.starts_with('%') || !text.as_bytes().windows(2).any(is_superfluous) {
        return Cow::Borrowed(text);
    }
    let mut short = String::with_capacity(text.len());
    let mut letters = text.chars().peekable();
    while let Some(letter) = letters.next() {
        let begins_number = !short.ends_with(|last: char| last.is_ascii_digit());
        let goes_on = letters.peek().is_some_and(char::is_ascii_digit);
        if !(letter == '0' && begins_number && goes_on) {
            short.push(letter);
        }
    }
    Cow::Owned(short)
}

/// The longest text that a `SmolStr` holds in itself.
const INLINE: usize = 23;

/// An ASCII text in small letters. Names are made at every operand of every check: the usual short one is written
/// without a detour over characters.
fn lower(text: &str) -> SmolStr {
    let mut buffer = [0; INLINE];
    let Some(short) = buffer.get_mut(..text.len()) else {
        return text.to_ascii_lowercase().into();
    };
    short.copy_from_slice(text.as_bytes());
    short.make_ascii_lowercase();
    std::str::from_utf8(short).map_or_else(|_| text.to_ascii_lowercase().into(), SmolStr::new)
}

/// Simple case folding: one character to one, by Unicode's table.
fn fold(c: char) -> char {
    unicode_case_mapping::case_folded(c)
        .and_then(|folded| char::from_u32(folded.get()))
        .unwrap_or(c)
}

impl std::borrow::Borrow<str> for Name {
    fn borrow(&self) -> &str {
        &self.0
    }
}

const RESERVED: [&str; 11] = [
    "TRUE", "FALSE", "SYS", "AND", "OR", "XOR", "NOT", "MOD", "SHL", "SHR", "PI",
];

const LONGEST_RESERVED: usize = longest(&RESERVED);

/// The length of the longest word, in bytes.
pub(crate) const fn longest(words: &[&str]) -> usize {
    let (mut longest, mut word) = (0, 0);
    while word < words.len() {
        if words[word].len() > longest {
            longest = words[word].len();
        }
        word += 1;
    }
    longest
}

/// Whether the word may not name a tag anywhere (LANGUAGE §1). `EN` and `ENO` in a block's body, and type
/// keywords in declarations, are the analysis' business.
pub fn is_reserved(word: &str) -> bool {
    word.len() <= LONGEST_RESERVED && RESERVED.iter().any(|r| r.eq_ignore_ascii_case(word))
}

/// Whether the text is one identifier.
pub fn is_identifier(text: &str) -> bool {
    crate::lexer::identifier_end(text, 0) == Some(text.len()) && !text.is_empty()
}

/// Whether a text is the name of a user-defined block, without its `$`: a letter, letters, digits and `_`, which is neither last nor
/// twice in a row.
pub fn is_block_name(text: &str) -> bool {
    is_identifier(text) && !text.starts_with('_') && !text.ends_with('_') && !text.contains("__")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spellings_that_are_one_name() {
        for (a, b) in [
            ("Run", "rUN"),
            ("ÄB", "äb"),
            ("A\u{308}", "ä"),
            ("ΣΑΣ", "σας"),
            ("µm", "ΜM"),
            ("ẞ", "ß"),
            ("%QX00.0", "%qx0.00"),
            ("%MW007", "%MW7"),
        ] {
            assert_eq!(Name::new(a), Name::new(b), "{a} {b}");
        }
        for (a, b) in [
            ("ß", "ss"),
            ("i", "ı"),
            ("a", "á"),
            ("%QX10.0", "%QX1.0"),
            ("%MW100", "%MW10"),
            ("a01", "a1"),
        ] {
            assert_ne!(Name::new(a), Name::new(b), "{a} {b}");
        }
    }

    #[test]
    fn identifiers() {
        for good in ["a", "_1", "Öl", "tank_3", "温度"] {
            assert!(is_identifier(good), "{good}");
        }
        for bad in ["", "1a", "a b", "a-b", "€", "a.b"] {
            assert!(!is_identifier(bad), "{bad}");
        }
    }
}
