//! `--range`: which part of a text is meant.

use ladder_syntax::{LineIndex, TextRange, TextSize};
use std::str::FromStr;

/// From one place to another, both included; lines and columns (in characters) count from 1. A place without a
/// column is the whole line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Selection {
    first: Bound,
    last: Bound,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Bound {
    line: u32,
    column: Option<u32>,
}

impl FromStr for Selection {
    type Err = String;

    fn from_str(text: &str) -> Result<Selection, String> {
        let (first, last) = text
            .split_once('-')
            .ok_or("a range is written FIRST-LAST, for example 12-20 or 12:1-20:8")?;
        let (first, last) = (place(first)?, place(last)?);
        let backwards = first.line > last.line
            || (first.line == last.line
                && first
                    .column
                    .is_some_and(|from| last.column.is_some_and(|to| from > to)));
        if backwards {
            return Err("the range ends before it begins".to_owned());
        }
        Ok(Selection { first, last })
    }
}

fn place(text: &str) -> Result<Bound, String> {
    let number = |digits: &str| match digits.parse::<u32>() {
        Ok(0) => Err("lines and columns count from 1".to_owned()),
        Ok(number) => Ok(number),
        Err(_) => Err(format!("`{digits}` is not a line or column")),
    };
    Ok(match text.split_once(':') {
        Some((line, column)) => Bound {
            line: number(line)?,
            column: Some(number(column)?),
        },
        None => Bound {
            line: number(text)?,
            column: None,
        },
    })
}

impl Selection {
    /// The bytes of the text that are meant. Places past the end of a line or of the text are brought back to it.
    pub(crate) fn range_in(self, text: &str) -> TextRange {
        let index = LineIndex::new(text);
        let line_of = |place: Bound| index.range(place.line as usize - 1);
        let start = match self.first.column {
            Some(column) => at_column(text, line_of(self.first), column - 1),
            None => line_of(self.first).start(),
        };
        let end = match self.last.column {
            // The character in that column belongs to the range.
            Some(column) => at_column(text, line_of(self.last), column),
            None => line_of(self.last).end(),
        };
        TextRange::new(start, end.max(start))
    }
}

/// After this many characters of a line.
fn at_column(text: &str, line: TextRange, characters: u32) -> TextSize {
    let bytes: usize = text[line]
        .trim_end_matches(['\r', '\n'])
        .chars()
        .take(characters as usize)
        .map(char::len_utf8)
        .sum();
    line.start() + TextSize::new(bytes as u32)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn selected(selection: &str) -> &'static str {
        let text = "one\nzwölf\r\nthree\n";
        &text[selection.parse::<Selection>().unwrap().range_in(text)]
    }

    #[test]
    fn lines_and_columns() {
        assert_eq!(selected("2-2"), "zwölf\r\n");
        assert_eq!(selected("1:2-2:3"), "ne\nzwö");
        assert_eq!(selected("2:3-2:3"), "ö");
        assert_eq!(selected("2:9-2:10"), "");
        assert_eq!(selected("3-99"), "three\n");
        assert_eq!(selected("50-99"), "");
    }

    #[test]
    fn what_is_no_range_is_refused() {
        for bad in ["", "3", "0-1", "1:0-2", "4-3", "2:5-2:4", "a-b", "1-2-3"] {
            assert!(bad.parse::<Selection>().is_err(), "{bad}");
        }
    }
}
