//! A line of text as columns of the screen.

use ladder_format::display_width;
use unicode_segmentation::UnicodeSegmentation;

/// Tabs reach to the next multiple of this, as terminals have it.
const TAB: usize = 8;

/// One character as a person sees it, with where it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Cell<'t> {
    /// What is shown. A tab and a control character are shown as blanks.
    pub(super) shown: &'t str,
    /// Its first byte in the line.
    pub(super) offset: usize,
    /// Its first column.
    pub(super) column: usize,
    /// How many columns it takes.
    pub(super) width: usize,
}

/// The cells of a line, from left to right.
pub(super) fn cells(line: &str) -> impl Iterator<Item = Cell<'_>> {
    let mut column = 0;
    line.grapheme_indices(true).map(move |(offset, text)| {
        let (shown, width) = match text {
            "\t" => (" ", TAB - column % TAB),
            // Escape sequences in a program are no business of the terminal's.
            text if text.contains(char::is_control) => (" ", 1),
            text => (text, display_width(text) as usize),
        };
        let cell = Cell {
            shown,
            offset,
            column,
            width,
        };
        column += width;
        cell
    })
}

/// How many columns a line takes.
pub(super) fn width(line: &str) -> usize {
    column(line, line.len())
}

/// The column where an offset in the line is.
pub(super) fn column(line: &str, offset: usize) -> usize {
    if line.is_ascii() && !line.contains('\t') {
        return offset.min(line.len());
    }
    let mut end = 0;
    for cell in cells(line) {
        if cell.offset >= offset {
            return cell.column;
        }
        end = cell.column + cell.width;
    }
    end
}

/// The offset in the line of what is in a column. None after its end.
pub(super) fn offset(line: &str, column: usize) -> Option<usize> {
    cells(line)
        .find(|cell| (cell.column..cell.column + cell.width).contains(&column))
        .map(|cell| cell.offset)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_and_offsets() {
        for (line, at, column_is) in [
            ("+--( )( y )--+", 3, 3),
            ("+--( )( y )--+", 99, 14),
            ("# 温度 #", 8, 6),
            ("# e\u{301} #", 6, 4),
            ("\t+--", 1, 8),
            ("+-\t-", 3, 8),
            ("a\u{1b}[0m", 2, 2),
            ("🙂b", 4, 2),
        ] {
            assert_eq!(column(line, at), column_is, "{line:?}");
        }
        assert_eq!(offset("# 温度 #", 3), Some(2));
        assert_eq!(offset("# 温度 #", 6), Some(8));
        assert_eq!(offset("\t+", 7), Some(0));
        assert_eq!(offset("\t+", 9), None);
        assert_eq!(width("# 温度 #"), 8);
    }

    #[test]
    fn nothing_reaches_the_terminal_that_it_would_obey() {
        let shown: String = cells("a\u{1b}]0;b\u{7}\0").map(|cell| cell.shown).collect();
        assert_eq!(shown, "a ]0;b  ");
    }
}
