//! Positions of many places of a text, in whichever order.

use std::cell::Cell;

use ladder_syntax::{LineIndex, TextRange, TextSize};

use crate::position::{Encoding, Position, Range, length};

/// A text with the index of its lines. Places near to the one before cost least: findings and symbols come in order.
#[derive(Debug)]
pub struct Positions {
    text: String,
    encoding: Encoding,
    index: LineIndex,
    /// The line that was found last.
    last: Cell<usize>,
}

impl Positions {
    /// Those of a text.
    pub fn new(text: String, encoding: Encoding) -> Positions {
        Positions {
            index: LineIndex::new(&text),
            text,
            encoding,
            last: Cell::new(0),
        }
    }

    /// The position of a byte offset. An offset past the end is the end of the text, one within a line break the end of
    /// its line, one within a character its beginning.
    pub fn position(&self, offset: usize) -> Position {
        let line = self.line(offset);
        let range = self.index.range(line);
        let start = usize::from(range.start());
        let mut at = offset.min(range.end().into());
        while !self.text.is_char_boundary(at) {
            at -= 1;
        }
        let before = &self.text[start..at];
        let before = before.trim_end_matches(['\r', '\n']);
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
    pub fn range(&self, range: TextRange) -> Range {
        Range {
            start: self.position(range.start().into()),
            end: self.position(range.end().into()),
        }
    }

    fn line(&self, offset: usize) -> usize {
        let last = self.last.get();
        let holds = |line: usize| {
            let range = self.index.range(line);
            usize::from(range.start()) <= offset && offset < usize::from(range.end())
        };
        let line = if holds(last) {
            last
        } else if holds(last + 1) {
            last + 1
        } else {
            let offset = offset.min(self.text.len());
            self.index.line(TextSize::new(offset as u32))
        };
        self.last.set(line);
        line
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use ropey::Rope;

    use super::*;
    use crate::position;

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
