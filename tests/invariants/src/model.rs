//! A text as an editor sees it, kept as a plain string: the server's ropes must agree with it.

use ladder_documents::position::Encoding;
use ladder_documents::{Position, Range};

/// A text, and the unit in which its positions count.
#[derive(Debug)]
pub(crate) struct Model {
    pub(crate) text: String,
    unit: Encoding,
}

impl Model {
    pub(crate) fn new(text: String, unit: Encoding) -> Model {
        Model { text, unit }
    }

    /// Replaces a stretch. Ends that are swapped are turned round.
    pub(crate) fn replace(&mut self, range: Range, new: &str) {
        let (a, b) = (self.offset(range.start), self.offset(range.end));
        self.text.replace_range(a.min(b)..a.max(b), new);
    }

    /// The byte of a position; one outside of the text is brought into it.
    pub(crate) fn offset(&self, at: Position) -> usize {
        let mut start = 0;
        for _ in 0..at.line {
            match line_end(&self.text[start..]) {
                Some((_, next)) => start += next,
                None => return self.text.len(),
            }
        }
        let line = &self.text[start..];
        let line = &line[..line_end(line).map_or(line.len(), |(end, _)| end)];
        let mut units = 0;
        for (at_byte, c) in line.char_indices() {
            units += self.units(c);
            if units > at.character {
                return start + at_byte;
            }
        }
        start + line.len()
    }

    /// The position of a byte.
    pub(crate) fn position(&self, offset: usize) -> Position {
        let (mut line, mut start) = (0, 0);
        while let Some((_, next)) = line_end(&self.text[start..]) {
            if start + next > offset {
                break;
            }
            start += next;
            line += 1;
        }
        let end = line_end(&self.text[start..]).map_or(self.text.len(), |(end, _)| start + end);
        let before = &self.text[start..offset.min(end)];
        Position {
            line,
            character: before.chars().map(|c| self.units(c)).sum(),
        }
    }

    fn units(&self, c: char) -> u32 {
        match self.unit {
            Encoding::Utf8 => c.len_utf8() as u32,
            Encoding::Utf16 => c.len_utf16() as u32,
            Encoding::Utf32 => 1,
        }
    }
}

/// Where the first line ends, and where the next one begins; none for the last line.
fn line_end(text: &str) -> Option<(usize, usize)> {
    let at = text.find(['\n', '\r'])?;
    let long = if text[at..].starts_with("\r\n") { 2 } else { 1 };
    Some((at, at + long))
}
