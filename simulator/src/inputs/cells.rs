//! The cells of a table, as spreadsheets and the tools of controllers write one.

use csv::{Reader, ReaderBuilder, Trim};
use ladder_analysis::values::types::Scalar;

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

/// A cell that is to be read as a value of a type, with a point where spreadsheets write a comma: `3,5` is 3.5. A duration has no
/// blank before its units: `1,5 s` is 1.5s.
pub fn with_point(cell: &str, ty: Scalar) -> String {
    let is_duration = ty == Scalar::Time;
    let mut text = if (ty.is_real() || is_duration) && !cell.contains('.') {
        cell.replace(',', ".")
    } else {
        cell.to_owned()
    };
    if is_duration {
        text.retain(|c| !c.is_whitespace());
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commas_are_points_where_a_type_has_one() {
        for (cell, ty, text) in [
            ("3,5", Scalar::Real, "3.5"),
            ("3.5", Scalar::Lreal, "3.5"),
            ("1,5 s", Scalar::Time, "1.5s"),
            ("T#1,5s", Scalar::Time, "T#1.5s"),
            ("a, b", Scalar::String(80), "a, b"),
        ] {
            assert_eq!(with_point(cell, ty), text);
        }
    }
}
