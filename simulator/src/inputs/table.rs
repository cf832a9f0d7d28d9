//! A CSV file with a header: names, and rows of cells below them.

use super::InputsError;
use super::cells::{separator, table_cells};
use csv::{ErrorKind, StringRecord};
use ladder_syntax::{LineIndex, Name, TextSize};

/// The file's content. Every row has as many cells as the header; rows count from 0.
#[derive(Debug, Default)]
pub(super) struct Table {
    /// The file as it was named, for messages.
    pub(super) file: String,
    /// What is between its cells.
    pub(super) separator: char,
    /// The header.
    pub(super) names: Vec<String>,
    /// The rows below it. A blank line is a row of empty cells.
    pub(super) rows: Vec<Row>,
}

/// One row of cells.
#[derive(Debug)]
pub(super) struct Row {
    /// Its line in the file, from 1.
    line: u64,
    cells: StringRecord,
}

impl Table {
    /// Reads the text of a file.
    ///
    /// # Errors
    /// It has no header, a name appears twice in the header, or a row has another number of cells.
    pub(super) fn parse(file: &str, text: &str) -> Result<Table, InputsError> {
        // A second mark would be passed over by the reader, which does not count it.
        let text = text.trim_start_matches('\u{feff}');
        // Cells are counted here, so that a blank line can be distinguished from a short row.
        let mut reader = table_cells(text);
        let mut table = Table {
            file: file.to_owned(),
            separator: separator(text),
            ..Table::default()
        };
        let lines = LineIndex::new(text);
        let mut record = StringRecord::new();
        let mut next_line = 1;
        loop {
            let before = reader.position().byte() as usize;
            match reader.read_record(&mut record) {
                Ok(true) => {}
                Ok(false) => break,
                Err(error) => return Err(table.failure(&broken(&error))),
            }
            let line = lines.line(after_line_ends(text, before)) as u64 + 1;
            if table.names.is_empty() {
                table.names = record.iter().map(str::to_owned).collect();
                table.check_header()?;
            } else {
                // The reader passes over blank lines; here each is a scan without assignments.
                for blank in next_line..line {
                    table.push(blank, StringRecord::from(vec![""; table.names.len()]))?;
                }
                // A line of blanks is blank, too.
                let is_blank = record.len() == 1 && record.iter().all(str::is_empty);
                let row = if is_blank {
                    StringRecord::from(vec![""; table.names.len()])
                } else {
                    std::mem::take(&mut record)
                };
                table.push(line, row)?;
            }
            let last = reader.position().byte() as usize;
            next_line = lines.line(TextSize::new(last as u32 - 1)) as u64 + 2;
        }
        if table.names.is_empty() {
            return Err(table.failure("the file is empty; its first line names the tags"));
        }
        Ok(table)
    }

    fn check_header(&self) -> Result<(), InputsError> {
        for (index, name) in self.names.iter().enumerate() {
            let column = index + 1;
            if name.is_empty() {
                return Err(self.failure(&format!("the header has no name in column {column}")));
            }
            let same = |other: &String| Name::new(other) == Name::new(name);
            if let Some(first) = self.names[..index].iter().position(same) {
                return Err(self.failure(&format!(
                    "the header has `{name}` in columns {} and {column}",
                    first + 1
                )));
            }
        }
        Ok(())
    }

    fn push(&mut self, line: u64, cells: StringRecord) -> Result<(), InputsError> {
        let (there, wanted) = (cells.len(), self.names.len());
        if there != wanted {
            let row = self.rows.len();
            let problem = if there < wanted {
                format!("the cell for column `{}` is missing", self.names[there])
            } else {
                format!("column {} has no name in the header", wanted + 1)
            };
            return Err(self.failure(&format!(
                "row {row} (line {line}): {problem}; the row has {there} of {wanted} cells"
            )));
        }
        self.rows.push(Row { line, cells });
        Ok(())
    }

    /// The cells of a row.
    pub(super) fn cells(&self, row: usize) -> impl Iterator<Item = &str> {
        self.rows[row].cells.iter()
    }

    /// A failure that names the file.
    pub(super) fn failure(&self, problem: &str) -> InputsError {
        InputsError(format!("{}: {problem}", self.file))
    }

    /// A failure that names the file and a column of the header.
    pub(super) fn column_failure(&self, column: usize, problem: &str) -> InputsError {
        let name = &self.names[column];
        self.failure(&format!("header, column {} (`{name}`): {problem}", column + 1))
    }

    /// A failure that names the file, the row and the column of a cell.
    pub(super) fn cell_failure(&self, row: usize, column: usize, problem: &str) -> InputsError {
        let (line, name) = (self.rows[row].line, &self.names[column]);
        self.failure(&format!("row {row} (line {line}), column `{name}`: {problem}"))
    }
}

/// The first place from `at` on where no line ends.
fn after_line_ends(text: &str, at: usize) -> TextSize {
    let rest = text[at..].trim_start_matches(['\r', '\n']);
    TextSize::new((text.len() - rest.len()) as u32)
}

fn broken(error: &csv::Error) -> String {
    match (error.kind(), error.position()) {
        (ErrorKind::Io(cause), _) => format!("cannot be read: {cause}"),
        (_, Some(position)) => format!("line {}: {error}", position.line()),
        _ => error.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use expect_test::{Expect, expect};
    use proptest::prelude::*;

    fn check(text: &str, expected: Expect) {
        let shown = match Table::parse("in.csv", text) {
            Ok(table) => {
                let mut shown = format!("{}\n", table.names.join(" "));
                for row in 0..table.rows.len() {
                    let cells: Vec<&str> = table.cells(row).collect();
                    shown.push_str(&format!("{}: {cells:?}\n", table.rows[row].line));
                }
                shown
            }
            Err(failure) => format!("{failure}\n"),
        };
        expected.assert_eq(&shown);
    }

    #[test]
    fn marks_of_the_byte_order_count_for_nothing() {
        check(
            "\u{feff}\u{feff}a,b\n\u{feff},1\n",
            expect![[r#"
                a b
                2: ["\u{feff}", "1"]
            "#]],
        );
    }

    #[test]
    fn rows_and_their_lines() {
        check(
            "\u{feff}start, stop\r\n1,0\r\n\"0\", \r\n",
            expect![[r#"
                start stop
                2: ["1", "0"]
                3: ["0", ""]
            "#]],
        );
    }

    #[test]
    fn a_blank_line_is_a_scan_without_assignments() {
        for text in [
            "\nstart\n1\n\n\n0\n\n",
            "\r\nstart\r\n1\r\n\r\n\r\n0\r\n\r\n",
            "\rstart\r1\r\r\r0\r\r",
        ] {
            check(
                text,
                expect![[r#"
                    start
                    3: ["1"]
                    4: [""]
                    5: [""]
                    6: ["0"]
                "#]],
            );
        }
    }

    #[test]
    fn a_line_of_blanks_is_a_blank_one() {
        check(
            "start,stop\n1,0\n  \n\t\n0,1\n",
            expect![[r#"
            start stop
            2: ["1", "0"]
            3: ["", ""]
            4: ["", ""]
            5: ["0", "1"]
        "#]],
        );
    }

    #[test]
    fn what_is_broken_is_named() {
        check(
            "",
            expect![[r#"
            in.csv: the file is empty; its first line names the tags
        "#]],
        );
        check(
            "a,,b\n",
            expect![[r#"
            in.csv: the header has no name in column 2
        "#]],
        );
        check(
            "a,b,a\n",
            expect![[r#"
                in.csv: the header has `a` in columns 1 and 3
            "#]],
        );
        check(
            "a,b\n1,1\n1\n",
            expect![[r#"
            in.csv: row 1 (line 3): the cell for column `b` is missing; the row has 1 of 2 cells
        "#]],
        );
        check(
            "a,b\n1,1,1\n",
            expect![[r#"
            in.csv: row 0 (line 2): column 3 has no name in the header; the row has 3 of 2 cells
        "#]],
        );
    }

    /// Pieces of which files of inputs are made, right and wrong.
    fn files() -> impl Strategy<Value = String> {
        let piece = prop_oneof![
            Just(","),
            Just("\n"),
            Just("\r\n"),
            Just("\r"),
            Just("\""),
            Just("\"\""),
            Just(" "),
            Just("\u{feff}"),
            Just("a"),
            Just("b"),
            Just("A"),
            Just("1"),
            Just("-1.5"),
            Just("ä"),
            Just("\0"),
            Just("\t"),
        ];
        proptest::collection::vec(piece, 0..40).prop_map(|pieces| pieces.concat())
    }

    proptest! {
        #[test]
        fn any_file_is_a_table_of_full_rows_or_says_why_not(text in files()) {
            match Table::parse("in.csv", &text) {
                Ok(table) => for row in 0..table.rows.len() {
                    prop_assert_eq!(table.cells(row).count(), table.names.len());
                    let lines = text.split(['\n', '\r']).count() as u64;
                    prop_assert!((2..=lines).contains(&table.rows[row].line));
                },
                Err(failure) => prop_assert!(failure.to_string().starts_with("in.csv: ")),
            }
        }
    }
}
