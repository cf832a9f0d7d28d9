//! Byte offsets and physical lines: for people (line and column from 1) and for protocols.

use rowan::{TextRange, TextSize};
use std::fmt;

/// A place as people count it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct LineColumn {
    /// The line, from 1.
    pub line: u32,
    /// The column in characters, from 1.
    pub column: u32,
}

impl LineColumn {
    /// Where a text begins.
    pub const START: LineColumn = LineColumn { line: 1, column: 1 };

    /// The beginning of a line, from 1.
    pub const fn line(line: u32) -> LineColumn {
        LineColumn { line, column: 1 }
    }
}

impl Default for LineColumn {
    fn default() -> LineColumn {
        LineColumn::START
    }
}

impl fmt::Display for LineColumn {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}", self.line, self.column)
    }
}

/// Where each physical line starts. LF, CRLF and a lone CR end a line (LANGUAGE §1); nothing else does.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LineIndex {
    starts: Vec<u32>,
    len: u32,
    /// Lines that are so long that their columns are not counted from the beginning each time, from top to bottom.
    long: Vec<LongLine>,
}

/// A line of which some columns are known.
#[derive(Debug, Clone, PartialEq, Eq)]
struct LongLine {
    start: u32,
    /// Offsets at most [`STRIDE`] bytes apart, each with the characters of the line before it.
    columns: Vec<(u32, u32)>,
}

impl LongLine {
    fn of(text: &str, start: usize, end: usize) -> LongLine {
        let mut columns = vec![(start as u32, 0)];
        let (mut at, mut characters) = (start, 0);
        while end - at > STRIDE {
            let mut next = at + STRIDE;
            while !text.is_char_boundary(next) {
                next -= 1;
            }
            characters += characters_of(&text[at..next]);
            columns.push((next as u32, characters));
            at = next;
        }
        LongLine {
            start: start as u32,
            columns,
        }
    }
}

/// Between two known columns of a long line are this many bytes.
const STRIDE: usize = 1024;

/// Characters as people count them: a byte order mark is none.
fn characters_of(text: &str) -> u32 {
    text.chars().filter(|&c| c != '\u{feff}').count() as u32
}

/// The last byte of each line end.
pub(crate) fn line_ends(text: &[u8]) -> impl Iterator<Item = usize> + '_ {
    memchr::memchr2_iter(b'\n', b'\r', text)
        .filter(|&at| text[at] == b'\n' || text.get(at + 1) != Some(&b'\n'))
}

/// The physical line around an offset, without its line end: for one look, where an index would be read through once more
/// than the line. A place between the CR and the LF of a line end belongs to the line that they end.
pub fn line_around(text: &str, offset: TextSize) -> TextRange {
    let bytes = text.as_bytes();
    let mut at = usize::from(offset).min(bytes.len());
    if at > 0 && bytes[at - 1] == b'\r' && bytes.get(at) == Some(&b'\n') {
        at -= 1;
    }
    let start = memchr::memrchr2(b'\n', b'\r', &bytes[..at]).map_or(0, |end| end + 1);
    let end = memchr::memchr2(b'\n', b'\r', &bytes[at..]).map_or(bytes.len(), |end| at + end);
    TextRange::new(TextSize::new(start as u32), TextSize::new(end as u32))
}

impl LineIndex {
    /// The index of a text.
    pub fn new(text: &str) -> LineIndex {
        LineIndex::with_line_ends(text, line_ends(text.as_bytes()))
    }

    /// The index of a text in which LF alone ends a line.
    pub fn of_line_feeds(text: &str) -> LineIndex {
        LineIndex::with_line_ends(text, memchr::memchr_iter(b'\n', text.as_bytes()))
    }

    fn with_line_ends(text: &str, ends: impl Iterator<Item = usize>) -> LineIndex {
        let mut starts = vec![0];
        let mut long = Vec::new();
        let mut start = 0;
        for end in ends {
            if end - start > STRIDE {
                long.push(LongLine::of(text, start, end));
            }
            start = end + 1;
            starts.push(start as u32);
        }
        if text.len() - start > STRIDE {
            long.push(LongLine::of(text, start, text.len()));
        }
        LineIndex {
            starts,
            len: text.len() as u32,
            long,
        }
    }

    /// Number of physical lines; a text that ends with a line end has an empty last one.
    pub fn line_count(&self) -> usize {
        self.starts.len()
    }

    /// The line of an offset, from 0. Offsets past the end count as the end.
    pub fn line(&self, offset: TextSize) -> usize {
        self.starts.partition_point(|&start| start <= u32::from(offset)) - 1
    }

    /// The range of a line, from 0, its line end included. Past the last line: empty, at the end.
    pub fn range(&self, line: usize) -> TextRange {
        let at = |n: usize| TextSize::new(self.starts.get(n).copied().unwrap_or(self.len));
        TextRange::new(at(line), at(line + 1))
    }

    /// The range of a line, from 0, without its line end, in the text that the index was made of.
    pub fn content(&self, text: &str, line: usize) -> TextRange {
        let range = self.range(line);
        let content = text[range].trim_end_matches(['\r', '\n']);
        TextRange::at(range.start(), TextSize::of(content))
    }

    /// The place of an offset in the text that the index was made of.
    pub fn line_column(&self, text: &str, offset: TextSize) -> LineColumn {
        let offset = offset.min(TextSize::new(self.len));
        let line = self.line(offset);
        let mut end = usize::from(offset);
        while !text.is_char_boundary(end) {
            end -= 1;
        }
        let (known, before) = self.known_column(self.starts[line], end as u32);
        LineColumn {
            line: line as u32 + 1,
            column: before + characters_of(&text[known as usize..end]) + 1,
        }
    }

    /// The other way: the offset of a place, brought back into its line and into the text if it lies outside.
    pub fn offset(&self, text: &str, place: LineColumn) -> TextSize {
        let line = self.content(text, (place.line.max(1) as usize - 1).min(self.starts.len() - 1));
        let before = place.column.max(1) - 1;
        let long = self.long_line(line.start().into());
        let (known, counted) = long.map_or((line.start().into(), 0), |long| {
            let after = long.columns.partition_point(|&(_, counted)| counted <= before);
            long.columns[after - 1]
        });
        let known = TextSize::new(known).min(line.end());
        let rest = &text[TextRange::new(known, line.end())];
        let mut characters = rest.char_indices().filter(|&(_, c)| c != '\u{feff}');
        let at = characters
            .nth((before - counted) as usize)
            .map_or(rest.len(), |(at, _)| at);
        known + TextSize::new(at as u32)
    }

    /// The nearest place before an offset whose column is known, and the characters before it on its line.
    fn known_column(&self, start: u32, offset: u32) -> (u32, u32) {
        let Some(long) = self.long_line(start) else {
            return (start, 0);
        };
        let after = long.columns.partition_point(|&(known, _)| known <= offset);
        long.columns[after.max(1) - 1]
    }

    /// The line that starts there, if it is a long one.
    fn long_line(&self, start: u32) -> Option<&LongLine> {
        let long = self.long.binary_search_by_key(&start, |long| long.start).ok()?;
        self.long.get(long)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_line_ends() {
        let text = "a\nb\r\nc\rd\u{2028}e\n";
        let index = LineIndex::new(text);
        let lines: Vec<&str> = (0..index.line_count()).map(|n| &text[index.range(n)]).collect();
        assert_eq!(lines, ["a\n", "b\r\n", "c\r", "d\u{2028}e\n", ""]);
        assert!(index.range(99).is_empty());
        assert_eq!(LineIndex::new("").line_count(), 1);
    }

    /// Each offset of a text, with the line around it.
    #[test]
    fn lines_around() {
        for text in ["", "\n", "ab", "a\nbc\r\nd\re\u{2028}f\r\n", "\r\r\n\n"] {
            let index = LineIndex::new(text);
            for offset in 0..=text.len() + 1 {
                let offset = TextSize::new(offset as u32);
                let line = index.content(text, index.line(offset));
                assert_eq!(line_around(text, offset), line, "{text:?} {offset:?}");
            }
        }
    }

    /// In long lines columns are counted from the nearest known one.
    #[test]
    fn columns_of_long_lines() {
        let line = "\u{feff}aä温😀".repeat(900);
        let text = format!("x\n{line}\r\n\n{line}");
        let index = LineIndex::new(&text);
        assert_eq!(index.long.len(), 2);
        for start in [2, 2 + line.len() + 3] {
            let mut characters = 0;
            for (at, c) in line.char_indices() {
                let place = index.line_column(&text, TextSize::new((start + at) as u32));
                assert_eq!(place.column, characters + 1, "{start} {at}");
                if c != '\u{feff}' {
                    assert_eq!(usize::from(index.offset(&text, place)), start + at);
                }
                characters += u32::from(c != '\u{feff}');
            }
        }
        // No column is far from a known one, and no line holds more of them than it needs.
        for long in &index.long {
            assert!(long.columns.is_sorted());
            assert!(long.columns.len() <= line.len() / (STRIDE - 4) + 1);
            let gaps = long.columns.windows(2).map(|pair| pair[1].0 - pair[0].0);
            assert!(gaps.max().unwrap() <= STRIDE as u32);
        }
    }

    /// Columns count characters, whatever their bytes, and a byte order mark is none. Places inside a character or
    /// after the end are moved to the nearest that exists.
    #[test]
    fn columns() {
        let text = "\u{feff}ab\näö温x\r\n";
        let index = LineIndex::new(text);
        for (offset, line, column) in [
            (0, 1, 1),
            (3, 1, 1),
            (5, 1, 3),
            (6, 2, 1),
            (7, 2, 1),
            (8, 2, 2),
            (13, 2, 4),
            (14, 2, 5),
            (15, 2, 6),
            (16, 3, 1),
            (99, 3, 1),
        ] {
            let place = index.line_column(text, TextSize::new(offset));
            assert_eq!(place, LineColumn { line, column }, "{offset}");
        }
    }
}
