//! Positions of many places of a text, in whichever order.

use std::cell::Cell;

use ladder_syntax::TextRange;

use super::position::{Encoding, Position, Range, length};

/// A text with the starts of its lines. Places near to the one before cost least.
#[derive(Debug)]
pub(crate) struct Positions {
    text: String,
    encoding: Encoding,
    starts: Vec<usize>,
    /// The line that was found last.
    last: Cell<usize>,
}

impl Positions {
    pub(crate) fn new(text: String, encoding: Encoding) -> Positions {
        let bytes = text.as_bytes();
        let ends = memchr::memchr2_iter(b'\n', b'\r', bytes)
            .filter(|&at| bytes[at] == b'\n' || bytes.get(at + 1) != Some(&b'\n'));
        let starts = std::iter::once(0).chain(ends.map(|at| at + 1)).collect();
        Positions {
            text,
            encoding,
            starts,
            last: Cell::new(0),
        }
    }

    /// The position of a byte offset. An offset past the end is the end of the text, one within a line break the end of
    /// its line, one within a character its beginning.
    pub(crate) fn position(&self, offset: usize) -> Position {
        let line = self.line(offset);
        let start = self.starts[line];
        let end = self.starts.get(line + 1).copied().unwrap_or(self.text.len());
        let mut at = offset.min(end);
        while !self.text.is_char_boundary(at) {
            at -= 1;
        }
        let before = &self.text[start..at];
        let before = match self.starts.len() - line {
            1 => before,
            _ => before.trim_end_matches(['\r', '\n']),
        };
        Position {
            line: line as u32,
            character: if before.is_ascii() {
                before.len() as u32
            } else {
                length(before, self.encoding)
            },
        }
    }

    /// The range of a stretch.
    pub(crate) fn range(&self, range: TextRange) -> Range {
        Range {
            start: self.position(range.start().into()),
            end: self.position(range.end().into()),
        }
    }

    fn line(&self, offset: usize) -> usize {
        let last = self.last.get();
        let begins = |line: usize| self.starts.get(line).is_none_or(|&start| offset < start);
        let line = if self.starts[last] <= offset && begins(last + 1) {
            last
        } else if self.starts[last] <= offset && begins(last + 2) {
            last + 1
        } else {
            self.starts.partition_point(|&start| start <= offset) - 1
        };
        self.last.set(line);
        line
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use ropey::Rope;

    use super::super::position;
    use super::*;

    proptest! {
        #![proptest_config(ProptestConfig { cases: 300, ..ProptestConfig::default() })]

        #[test]
        fn agree_with_the_rope(pieces in prop::collection::vec(prop_oneof![
            Just("\r\n"), Just("\r"), Just("\n"), Just("😀"), Just("é"), Just("\u{2028}"), Just("# x #"), Just("--"),
        ], 0..40), places in prop::collection::vec(0..200_usize, 1..40)) {
            let text = pieces.concat();
            let rope = Rope::from_str(&text);
            for encoding in [Encoding::Utf8, Encoding::Utf16, Encoding::Utf32] {
                let positions = Positions::new(text.clone(), encoding);
                for &at in &places {
                    prop_assert_eq!(positions.position(at), position::position(&rope, encoding, at), "{}", at);
                }
            }
        }
    }
}
