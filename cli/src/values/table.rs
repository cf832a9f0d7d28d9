//! A table of tag values, as the tools of a controller write it: a name and a value a row.

use csv::StringRecord;

/// A longer table is none of a controller.
const MOST_ROWS: usize = 200_000;

/// What the columns of names and of values are called, in any case.
const NAMES: [&str; 6] = ["name", "tag", "tag name", "tagname", "symbol", "variable"];
const VALUES: [&str; 6] = [
    "value",
    "val",
    "monitor value",
    "actual value",
    "current value",
    "online value",
];

/// A row.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Row {
    /// Its line in the file, from 1.
    pub(super) line: u64,
    /// The name of a tag, without quotes.
    pub(super) name: String,
    /// Its value, as it is written.
    pub(super) value: String,
}

/// What is wrong with a table, with the line.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Broken {
    pub(super) line: u64,
    pub(super) message: String,
}

/// Reads a table: `,`, `;` or tabs between the cells, with or without a header. What has no value is left out.
///
/// # Errors
/// A row has no second cell, the header has no column of values, or it is not a table.
pub(super) fn parse(text: &str) -> Result<Vec<Row>, Broken> {
    let mut reader = ladder_simulator::table_cells(text);
    let mut columns = None;
    let mut rows = Vec::new();
    let mut record = StringRecord::new();
    loop {
        let line = reader.position().line();
        match reader.read_record(&mut record) {
            Ok(true) => {}
            Ok(false) => break,
            Err(error) => {
                let message = error.to_string();
                return Err(Broken { line, message });
            }
        }
        // Blank lines in front of it are passed by.
        let line = record.position().map_or(line, csv::Position::line);
        if record.iter().all(str::is_empty) {
            continue;
        }
        let (name, value) = match columns {
            Some(columns) => columns,
            None => {
                let (found, is_header) = header(&record, line)?;
                columns = Some(found);
                if is_header {
                    continue;
                }
                found
            }
        };
        let name = record.get(name).unwrap_or_default().replace('"', "");
        let name = name.trim().trim_start_matches('#').to_owned();
        let Some(value) = record.get(value) else {
            let message = format!("`{name}` has no value; a row is a name and a value, as in `start,1`");
            return Err(Broken { line, message });
        };
        if rows.len() == MOST_ROWS {
            let message = format!("the table has more than {MOST_ROWS} rows");
            return Err(Broken { line, message });
        }
        if !name.is_empty() && !value.is_empty() {
            let value = value.to_owned();
            rows.push(Row { line, name, value });
        }
    }
    Ok(rows)
}

/// The columns of names and values, and whether the first row says so.
fn header(record: &StringRecord, line: u64) -> Result<((usize, usize), bool), Broken> {
    let column = |names: &[&str]| {
        let is_one = |cell: &str| names.iter().any(|name| cell.eq_ignore_ascii_case(name));
        record.iter().position(is_one)
    };
    match (column(&NAMES), column(&VALUES)) {
        (Some(name), Some(value)) => Ok(((name, value), true)),
        (Some(_), None) if record.len() != 2 => Err(Broken {
            line,
            message: "the header has no column of values; call it `value`".to_owned(),
        }),
        _ => Ok(((0, 1), false)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use expect_test::{Expect, expect};

    fn check(text: &str, expected: Expect) {
        let shown = match parse(text) {
            Ok(rows) => {
                let rows = rows.iter();
                let rows: Vec<String> = rows
                    .map(|row| format!("{}: {} = {}\n", row.line, row.name, row.value))
                    .collect();
                rows.concat()
            }
            Err(broken) => format!("line {}: {}\n", broken.line, broken.message),
        };
        expected.assert_eq(&shown);
    }

    #[test]
    fn a_name_and_a_value_a_row() {
        check(
            "\u{feff}start,1\r\n\r\n \"t1.ACC\" , 300 \nempty,\n",
            expect![[r#"
                1: start = 1
                1: t1.ACC = 300
            "#]],
        );
    }

    #[test]
    fn columns_by_their_header() {
        check(
            "Name;Address;Display format;Monitor value\n\"\"\"Motor_DB\"\".run\";%DB1.DBX0.0;Bool;TRUE\nspeed;%MD4;;3,5\n",
            expect![[r#"
                2: Motor_DB.run = TRUE
                3: speed = 3,5
            "#]],
        );
        check(
            "scope\ttag name\tVALUE\nmain\trun\t0\n",
            expect![[r#"
                2: run = 0
            "#]],
        );
    }

    #[test]
    fn what_is_no_table_is_said_with_its_line() {
        check(
            "TYPE,SCOPE,NAME,DESCRIPTION\nTAG,,run,x\n",
            expect![[r#"
                line 1: the header has no column of values; call it `value`
            "#]],
        );
        check(
            "a,1\n\nb\n",
            expect![[r#"
                line 2: `b` has no value; a row is a name and a value, as in `start,1`
            "#]],
        );
    }
}
