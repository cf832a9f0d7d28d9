//! Lines and columns of a foreign file.

use ladder_syntax::{TextRange, TextSize};
use std::fmt;

/// A place in a text: both count from 1, columns in characters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Place {
    /// The line.
    pub line: u32,
    /// The character on it.
    pub column: u32,
}

impl Place {
    /// Where a text begins.
    pub const START: Place = Place { line: 1, column: 1 };

    /// The beginning of a line, from 1.
    pub const fn line(line: u32) -> Place {
        Place { line, column: 1 }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}", self.line, self.column)
    }
}

/// Where the lines of a text begin.
#[derive(Debug, Clone)]
pub struct Lines {
    starts: Vec<usize>,
}

impl Lines {
    /// Those of a text; LF ends a line.
    pub fn of(text: &str) -> Lines {
        let behind = text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n');
        Lines {
            starts: std::iter::once(0).chain(behind.map(|(at, _)| at + 1)).collect(),
        }
    }

    /// The place of an offset in bytes, in the text that the lines are of.
    pub fn place(&self, text: &str, offset: usize) -> Place {
        let line = self.starts.partition_point(|start| *start <= offset).max(1) - 1;
        let start = self.starts[line];
        let column = text.get(start..offset).map_or(0, |before| before.chars().count());
        Place {
            line: line as u32 + 1,
            column: column as u32 + 1,
        }
    }

    /// The other way: the offset in bytes of a place, brought back into the text if it lies outside.
    pub fn offset(&self, text: &str, place: Place) -> usize {
        let line = (place.line.max(1) as usize - 1).min(self.starts.len() - 1);
        let start = self.starts[line].min(text.len());
        let line = text[start..].split('\n').next().unwrap_or_default();
        let mut characters = line.char_indices().map(|(at, _)| at);
        start
            + characters
                .nth(place.column.max(1) as usize - 1)
                .unwrap_or(line.len())
    }

    /// The first word at a place, behind blanks.
    pub fn word(&self, text: &str, place: Place) -> TextRange {
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
        let outside = |line, column| lines.offset(text, Place { line, column });
        assert_eq!((outside(0, 0), outside(9, 9), outside(2, 9)), (0, 8, 7));
    }
}
