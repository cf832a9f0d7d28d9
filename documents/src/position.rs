//! Positions as the protocol counts them, and where they lie in a text.
//!
//! Everything inside the project counts bytes. Editors count a line and a unit within it, and the unit is
//! negotiated: bytes, UTF-16 code units or Unicode scalar values. The difference hides until a comment holds
//! an `ä` or an emoji, so all conversions go through the two functions here.
//!
//! A position that lies outside of the text is clamped, as the protocol asks: past the end of a line means the
//! end of that line, past the last line the end of the text, within a character its beginning.

use ropey::Rope;
use serde::{Deserialize, Serialize};

/// The unit in which [`Position::character`] counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Encoding {
    /// Bytes.
    Utf8,
    /// UTF-16 code units, which every client understands.
    #[default]
    Utf16,
    /// Unicode scalar values.
    Utf32,
}

/// A place in a text: a line, and a unit within it, both from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Position {
    /// The line, from 0. LF, CRLF and a lone CR end a line.
    pub line: u32,
    /// The unit within the line, from 0, in the negotiated encoding: bytes, UTF-16 code units or scalar values.
    pub character: u32,
}

/// A stretch of text; `end` is the first place that does not belong to it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Range {
    /// Where the stretch begins.
    pub start: Position,
    /// Where it ends.
    pub end: Position,
}

/// How long a text is in units, line ends included.
pub fn length(text: &str, encoding: Encoding) -> u32 {
    let units = match encoding {
        Encoding::Utf8 => text.len(),
        Encoding::Utf16 => text.encode_utf16().count(),
        Encoding::Utf32 => text.chars().count(),
    };
    units as u32
}

/// The byte offset of a position, clamped into the text.
pub fn offset(text: &Rope, encoding: Encoding, position: Position) -> usize {
    text.char_to_byte(char_index(text, encoding, position))
}

/// The position of a byte offset. An offset past the end is the end of the text; one between the CR and the
/// LF of a line break is the end of its line.
pub fn position(text: &Rope, encoding: Encoding, offset: usize) -> Position {
    let char = text.byte_to_char(offset.min(text.len_bytes()));
    let line = text.char_to_line(char);
    let start = text.line_to_char(line);
    let char = char.min(line_end(text, line));
    let units = match encoding {
        Encoding::Utf8 => text.char_to_byte(char) - text.char_to_byte(start),
        Encoding::Utf16 => text.char_to_utf16_cu(char) - text.char_to_utf16_cu(start),
        Encoding::Utf32 => char - start,
    };
    Position {
        line: line as u32,
        character: units as u32,
    }
}

/// The range of a stretch of bytes.
pub fn range(text: &Rope, encoding: Encoding, bytes: std::ops::Range<usize>) -> Range {
    Range {
        start: position(text, encoding, bytes.start),
        end: position(text, encoding, bytes.end),
    }
}

/// The index of the character at a position, clamped into the text: what `ropey` edits by.
pub(crate) fn char_index(text: &Rope, encoding: Encoding, position: Position) -> usize {
    let line = position.line as usize;
    if line >= text.len_lines() {
        return text.len_chars();
    }
    let (start, end) = (text.line_to_char(line), line_end(text, line));
    let units = position.character as usize;
    match encoding {
        Encoding::Utf8 => {
            let byte = text.char_to_byte(start) + units;
            text.byte_to_char(byte.min(text.char_to_byte(end)))
        }
        Encoding::Utf16 => {
            let unit = text.char_to_utf16_cu(start) + units;
            text.utf16_cu_to_char(unit.min(text.char_to_utf16_cu(end)))
        }
        Encoding::Utf32 => (start + units).min(end),
    }
}

/// The character index where the line ends, before its line break.
fn line_end(text: &Rope, line: usize) -> usize {
    if line + 1 == text.len_lines() {
        return text.len_chars();
    }
    let (start, next) = (text.line_to_char(line), text.line_to_char(line + 1));
    let ends_with_crlf = next - start >= 2 && text.char(next - 2) == '\r' && text.char(next - 1) == '\n';
    if ends_with_crlf { next - 2 } else { next - 1 }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(line: u32, character: u32) -> Position {
        Position { line, character }
    }

    #[test]
    fn an_astral_character_counts_four_two_or_one() {
        let text = Rope::from_str("+--# 😀 #--+\n");
        let after = text.line(0).chars().take(6).map(char::len_utf8).sum::<usize>();
        assert_eq!(position(&text, Encoding::Utf8, after), at(0, 9));
        assert_eq!(position(&text, Encoding::Utf16, after), at(0, 7));
        assert_eq!(position(&text, Encoding::Utf32, after), at(0, 6));
        for encoding in [Encoding::Utf8, Encoding::Utf16, Encoding::Utf32] {
            assert_eq!(offset(&text, encoding, position(&text, encoding, after)), after);
        }
    }

    #[test]
    fn within_a_character_is_its_beginning() {
        let text = Rope::from_str("😀x");
        assert_eq!(offset(&text, Encoding::Utf16, at(0, 1)), 0);
        assert_eq!(offset(&text, Encoding::Utf8, at(0, 3)), 0);
        assert_eq!(position(&text, Encoding::Utf16, 2), at(0, 0));
    }

    #[test]
    fn out_of_range_is_clamped() {
        let text = Rope::from_str("ab\r\ncd\re");
        for encoding in [Encoding::Utf8, Encoding::Utf16, Encoding::Utf32] {
            assert_eq!(
                offset(&text, encoding, at(0, 99)),
                2,
                "past the line means its end, before the CR"
            );
            assert_eq!(offset(&text, encoding, at(1, u32::MAX)), 6);
            assert_eq!(offset(&text, encoding, at(u32::MAX, u32::MAX)), 8);
            assert_eq!(position(&text, encoding, 99), at(2, 1));
            assert_eq!(position(&text, encoding, 3), at(0, 2), "between CR and LF");
        }
    }

    #[test]
    fn only_lf_crlf_and_cr_end_a_line() {
        let text = Rope::from_str("a\u{2028}b\u{85}c\u{b}d\u{c}e\nf");
        assert_eq!(text.len_lines(), 2);
        assert_eq!(position(&text, Encoding::Utf16, text.len_bytes()), at(1, 1));
    }
}
