//! The cells of a table, as spreadsheets and the tools of controllers write one.

use csv::{Reader, ReaderBuilder, Trim};

/// What is between the cells: `;` or a tab where the first line holds one, else a comma.
///
/// Where it is a semicolon a comma is the point of a number, see [`with_point`].
pub(super) fn separator(text: &str) -> char {
    let first = text.lines().find(|line| !line.trim().is_empty());
    let first = first.unwrap_or_default();
    [';', '\t']
        .into_iter()
        .find(|mark| first.contains(*mark))
        .unwrap_or(',')
}

/// Reads the cells of a text, row by row, without the blanks around them. Rows may be of different lengths.
pub fn table_cells(text: &str) -> Reader<&[u8]> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .delimiter(separator(text) as u8)
        .trim(Trim::All)
        .from_reader(text.as_bytes())
}

/// A real number with a point: `3,5` is 3.5.
pub fn with_point(cell: &str) -> String {
    if cell.contains('.') {
        cell.to_owned()
    } else {
        cell.replace(',', ".")
    }
}

/// A duration as spreadsheets write one, with a point and without blanks before its units: `1,5 s` is 1.5s.
pub fn duration_with_point(cell: &str) -> String {
    let mut text = with_point(cell);
    text.retain(|c| !c.is_whitespace());
    text
}
