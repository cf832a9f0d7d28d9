//! A change to a text, as an editor sends it.

use ropey::Rope;

use crate::byte_edit::ByteEdit;
use crate::position::{Encoding, Range, char_index};

/// One change of a `textDocument/didChange`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Change {
    /// The stretch is replaced.
    Part {
        /// What is replaced, in the text as it is after the changes before this one.
        range: Range,
        /// What is there afterwards.
        text: String,
    },
    /// The whole text is replaced.
    Whole(String),
}

/// Applies one change. Places outside of the text are clamped, and a range whose ends are swapped is turned
/// round: an editor that is wrong about a position must not bring the server down. Returns what was replaced; none if
/// that is all of it.
pub(crate) fn apply(text: &mut Rope, encoding: Encoding, change: &Change) -> Option<ByteEdit> {
    match change {
        Change::Whole(new) => {
            *text = Rope::from_str(new);
            None
        }
        Change::Part { range, text: new } => {
            let (a, b) = (
                char_index(text, encoding, range.start),
                char_index(text, encoding, range.end),
            );
            let (start, end) = (a.min(b), a.max(b));
            let old = text.char_to_byte(start)..text.char_to_byte(end);
            text.remove(start..end);
            text.insert(start, new);
            Some(ByteEdit {
                old,
                new_len: new.len(),
            })
        }
    }
}

#[cfg(test)]
mod tests {
    //! The model: a plain string, changed by a walk over its characters that knows nothing of ropes.

    use proptest::prelude::*;

    use super::*;
    use crate::position::{Position, offset, position};

    fn units(encoding: Encoding, c: char) -> u32 {
        match encoding {
            Encoding::Utf8 => c.len_utf8() as u32,
            Encoding::Utf16 => c.len_utf16() as u32,
            Encoding::Utf32 => 1,
        }
    }

    /// The byte where each line begins, and the byte where it ends before its line break.
    fn model_lines(text: &str) -> Vec<(usize, usize)> {
        let bytes = text.as_bytes();
        let (mut lines, mut start, mut i) = (Vec::new(), 0, 0);
        while i < bytes.len() {
            let width = match bytes[i] {
                b'\r' if bytes.get(i + 1) == Some(&b'\n') => 2,
                b'\r' | b'\n' => 1,
                _ => 0,
            };
            if width > 0 {
                lines.push((start, i));
                start = i + width;
            }
            i += width.max(1);
        }
        lines.push((start, text.len()));
        lines
    }

    fn model_offset(text: &str, encoding: Encoding, at: Position) -> usize {
        let lines = model_lines(text);
        let Some(&(start, end)) = lines.get(at.line as usize) else {
            return text.len();
        };
        let mut seen = 0;
        for (i, c) in text[start..end].char_indices() {
            seen += units(encoding, c);
            if seen > at.character {
                return start + i;
            }
        }
        end
    }

    fn model_position(text: &str, encoding: Encoding, offset: usize) -> Position {
        let lines = model_lines(text);
        let line = lines.iter().rposition(|&(start, _)| start <= offset).unwrap_or(0);
        let (start, end) = lines[line];
        let character = text[start..end.min(offset)]
            .chars()
            .map(|c| units(encoding, c))
            .sum();
        Position {
            line: line as u32,
            character,
        }
    }

    fn any_encoding() -> impl Strategy<Value = Encoding> {
        prop_oneof![Just(Encoding::Utf8), Just(Encoding::Utf16), Just(Encoding::Utf32)]
    }

    /// Text in which line breaks and wide characters meet often.
    fn any_text() -> impl Strategy<Value = String> {
        let piece = prop_oneof![
            Just("\r\n"),
            Just("\r"),
            Just("\n"),
            Just("😀"),
            Just("é"),
            Just("\u{2028}"),
            Just("\u{85}"),
            Just("+--[ ]( a )--"),
            Just("#"),
            Just("\\"),
            Just("/"),
            Just("e\u{301}"),
            Just("\0"),
            Just("x"),
        ];
        prop::collection::vec(piece, 0..40).prop_map(|pieces| pieces.concat())
    }

    fn any_position() -> impl Strategy<Value = Position> {
        (0u32..14, prop_oneof![0u32..30, Just(u32::MAX)])
            .prop_map(|(line, character)| Position { line, character })
    }

    fn any_change() -> impl Strategy<Value = Change> {
        prop_oneof![
            9 => (any_position(), any_position(), any_text()).prop_map(|(start, end, text)| Change::Part {
                range: Range { start, end },
                text
            }),
            1 => any_text().prop_map(Change::Whole),
        ]
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 400, ..ProptestConfig::default() })]

        #[test]
        fn changes_agree_with_a_plain_string(
            encoding in any_encoding(),
            text in any_text(),
            changes in prop::collection::vec(any_change(), 0..20),
        ) {
            let (mut rope, mut model) = (Rope::from_str(&text), text);
            for change in &changes {
                apply(&mut rope, encoding, change);
                match change {
                    Change::Whole(new) => model.clone_from(new),
                    Change::Part { range, text } => {
                        let a = model_offset(&model, encoding, range.start);
                        let b = model_offset(&model, encoding, range.end);
                        model.replace_range(a.min(b)..a.max(b), text);
                    }
                }
                prop_assert_eq!(rope.to_string(), model.clone());
            }
            for (at, _) in model.char_indices().chain([(model.len(), ' ')]) {
                let found = position(&rope, encoding, at);
                prop_assert_eq!(found, model_position(&model, encoding, at));
                let inside_crlf = at > 0 && model[..at].ends_with('\r') && model[at..].starts_with('\n');
                if !inside_crlf {
                    prop_assert_eq!(offset(&rope, encoding, found), at);
                }
            }
        }
    }
}
