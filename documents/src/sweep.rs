//! Positions of many places of a text in their order, in one pass over it: a line with thousands of tokens, whose columns
//! [`Positions`](super::positions::Positions) counts from its beginning each time, costs no more than as many short ones.

use crate::position::{Encoding, Position};

/// A pass over a text. Places are asked for in their order.
#[derive(Debug)]
pub struct Sweep<'t> {
    text: &'t [u8],
    encoding: Encoding,
    at: usize,
    position: Position,
}

impl<'t> Sweep<'t> {
    /// A pass over a text that begins at the start of this line.
    pub fn new(text: &'t str, encoding: Encoding, line: u32) -> Sweep<'t> {
        Sweep {
            text: text.as_bytes(),
            encoding,
            at: 0,
            position: Position { line, character: 0 },
        }
    }

    /// The position of a byte that is not before the one asked for last. One between the CR and the LF of a line
    /// break is the start of the next line.
    pub fn position(&mut self, offset: usize) -> Position {
        let Position {
            mut line,
            mut character,
        } = self.position;
        for index in self.at..offset.min(self.text.len()) {
            let byte = self.text[index];
            match byte {
                b'\n' if index > 0 && self.text[index - 1] == b'\r' => character = 0,
                b'\n' | b'\r' => {
                    line += 1;
                    character = 0;
                }
                _ => character += units(self.encoding, byte),
            }
        }
        self.at = offset;
        self.position = Position { line, character };
        self.position
    }
}

/// How many units the character that begins with a byte has; a byte that begins none has none.
const fn units(encoding: Encoding, byte: u8) -> u32 {
    let begins = byte & 0xC0 != 0x80;
    match encoding {
        Encoding::Utf8 => 1,
        Encoding::Utf16 => begins as u32 + (byte >= 0xF0) as u32,
        Encoding::Utf32 => begins as u32,
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
        fn agrees_with_the_rope(pieces in prop::collection::vec(prop_oneof![
            Just("\r\n"), Just("\r"), Just("\n"), Just("😀"), Just("é"), Just("\u{2028}"), Just("# x #"), Just("--"),
        ], 0..40)) {
            let text = pieces.concat();
            let rope = Rope::from_str(&text);
            for encoding in [Encoding::Utf8, Encoding::Utf16, Encoding::Utf32] {
                let mut sweep = Sweep::new(&text, encoding, 0);
                for (at, _) in text.char_indices().chain([(text.len(), ' ')]) {
                    let found = sweep.position(at);
                    if !(text[..at].ends_with('\r') && text[at..].starts_with('\n')) {
                        prop_assert_eq!(found, position::position(&rope, encoding, at));
                    }
                }
            }
        }
    }
}
