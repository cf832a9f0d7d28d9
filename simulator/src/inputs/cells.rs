//! The cells of a table, as spreadsheets and the tools of controllers write one.

use csv::{Reader, ReaderBuilder, Trim};
use ladder_analysis::values::types::Scalar;

/// What is between the cells: `;` or a tab where the first line holds one, else a comma.
///
/// It decides what a comma in a cell is, see [`with_point`].
pub fn separator(text: &str) -> char {
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

/// A cell that is to be read as a value of a type, with a point where spreadsheets write a comma: `3,5` is 3.5. Three digits after
/// a comma could be those after thousands, and stay as they are unless cells are separated by semicolons, as they are where commas
/// are points. A duration has no blank before its units: `1,5 s` is 1.5s.
pub fn with_point(cell: &str, ty: Scalar, separator: char) -> String {
    let is_duration = ty == Scalar::Time;
    let mut text = cell.to_owned();
    if let Some((whole, fraction)) = cell.split_once(',')
        && (ty.is_real() || is_duration)
        && !cell.contains('.')
        && (separator == ';' || digits(fraction) != 3)
    {
        text = format!("{whole}.{fraction}");
    }
    if is_duration {
        text.retain(|c| !c.is_whitespace());
    }
    text
}

/// With how many digits a text begins.
fn digits(text: &str) -> usize {
    text.bytes().take_while(u8::is_ascii_digit).count()
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
            for separator in [';', ',', '\t'] {
                assert_eq!(with_point(cell, ty, separator), text);
            }
        }
    }

    #[test]
    fn three_digits_after_a_comma_could_be_those_after_thousands() {
        for (cell, ty, text) in [
            ("1,500", Scalar::Real, "1.500"),
            ("1,250s", Scalar::Time, "1.250s"),
        ] {
            assert_eq!(with_point(cell, ty, ';'), text);
            assert_eq!(with_point(cell, ty, ','), cell);
        }
    }
}
