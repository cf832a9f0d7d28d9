//! Lines and columns of a foreign file.

use ladder_syntax::{LineColumn, LineIndex, TextRange, TextSize};

/// Where the lines of a text begin.
#[derive(Debug, Clone)]
pub struct Lines(LineIndex);

impl Lines {
    /// Those of a text; LF ends a line.
    pub fn of(text: &str) -> Lines {
        Lines(LineIndex::of_line_feeds(text))
    }

    /// The place of an offset in bytes, in the text that the lines are of.
    pub fn place(&self, text: &str, offset: usize) -> LineColumn {
        self.0.line_column(text, TextSize::new(offset as u32))
    }

    /// The other way: the offset in bytes of a place, brought back into the text if it lies outside.
    pub fn offset(&self, text: &str, place: LineColumn) -> usize {
        self.0.offset(text, place).into()
    }

    /// The first word at a place, after blanks.
    pub fn word(&self, text: &str, place: LineColumn) -> TextRange {
        let start = self.offset(text, place);
        let rest = text[start..].trim_start_matches([' ', '\t', '\u{feff}']);
        let start = text.len() - rest.len();
        let ends = |c: char| c.is_whitespace() || ",;(){}<>".contains(c);
        let length = rest.find(ends).unwrap_or(rest.len());
        TextRange::at(TextSize::new(start as u32), TextSize::new(length as u32))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_count_characters_from_one() {
        let text = "ä b\r\nc\n";
        let lines = Lines::of(text);
        let place = |offset| lines.place(text, offset).to_string();
        assert_eq!(place(0), "1:1");
        assert_eq!(place(text.find('b').unwrap()), "1:3");
        assert_eq!(place(text.find('c').unwrap()), "2:1");
        assert_eq!(place(text.len()), "3:1");
    }

    #[test]
    fn places_lead_back_to_offsets() {
        let text = "ä b\r\nc\n";
        let lines = Lines::of(text);
        for at in [0, 3, 4, 6, 7, 8] {
            assert_eq!(lines.offset(text, lines.place(text, at)), at);
        }
        let outside = |line, column| lines.offset(text, LineColumn { line, column });
        assert_eq!((outside(0, 0), outside(9, 9), outside(2, 9)), (0, 8, 7));
    }
}
