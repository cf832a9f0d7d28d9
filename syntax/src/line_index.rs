//! Byte offsets and physical lines: for people (line and column from 1) and for protocols.

use rowan::{TextRange, TextSize};

/// A place as people count it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct LineColumn {
    /// The line, from 1.
    pub line: u32,
    /// The column in characters, from 1.
    pub column: u32,
}

/// Where each physical line starts. LF, CRLF and a lone CR end a line (LANGUAGE §1); nothing else does.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LineIndex {
    starts: Vec<u32>,
    len: u32,
}

/// The last byte of each line end.
pub(crate) fn line_ends(text: &[u8]) -> impl Iterator<Item = usize> + '_ {
    memchr::memchr2_iter(b'\n', b'\r', text)
        .filter(|&at| text[at] == b'\n' || text.get(at + 1) != Some(&b'\n'))
}

impl LineIndex {
    /// The index of a text.
    pub fn new(text: &str) -> LineIndex {
        let mut starts = vec![0];
        starts.extend(line_ends(text.as_bytes()).map(|at| at as u32 + 1));
        LineIndex {
            starts,
            len: text.len() as u32,
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

    /// The place of an offset in the text that the index was made of.
    pub fn line_column(&self, text: &str, offset: TextSize) -> LineColumn {
        let offset = offset.min(TextSize::new(self.len));
        let line = self.line(offset);
        let start = self.starts[line] as usize;
        let mut end = usize::from(offset);
        while !text.is_char_boundary(end) {
            end -= 1;
        }
        let column = text[start..end].chars().filter(|&c| c != '\u{feff}').count();
        LineColumn {
            line: line as u32 + 1,
            column: column as u32 + 1,
        }
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

    /// Columns count characters, whatever their bytes, and a byte order mark is none. Places inside a character or
    /// behind the end are moved to the nearest that exists.
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
