//! A place as it is written for other programs.

use super::source::Source;
use ladder_syntax::TextRange;
use serde::Serialize;

/// Lines and columns from 1, columns in characters; the end is after the last character.
#[derive(Serialize)]
pub(super) struct LineColumnRange {
    pub(super) line: u32,
    pub(super) column: u32,
    pub(super) end_line: u32,
    pub(super) end_column: u32,
}

pub(super) fn place(source: &Source, range: TextRange) -> LineColumnRange {
    let (start, end) = (source.place(range.start()), source.place(range.end()));
    LineColumnRange {
        line: start.line,
        column: start.column,
        end_line: end.line,
        end_column: end.column,
    }
}
