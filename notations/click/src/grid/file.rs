//! The file of a grid: comma-separated values with the header `marker,A,B,..,AF`.

use super::super::csv::{self, Record};
use super::cell::{COLUMNS, Cell, Grid, GridRung, Row, Text};
use ladder_notation::{LineColumn, ReadError};

/// A rung with more rows is not read. Click itself has 32.
pub(super) const MOST_ROWS: usize = 64;

/// How many rungs are read.
const MOST_RUNGS: usize = 20_000;

/// The names of the columns in the header.
fn header() -> Vec<String> {
    let letter = |column: usize| char::from(b'A' + (column % 26) as u8);
    let name = |column: usize| match column / 26 {
        0 => letter(column).to_string(),
        _ => format!("A{}", letter(column)),
    };
    let columns = (0..=COLUMNS).map(name);
    std::iter::once("marker".to_owned()).chain(columns).collect()
}

/// Whether a file begins with the header of a grid.
pub(in super::super) fn is_grid(bytes: &[u8]) -> bool {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let first = bytes.split(|byte| matches!(byte, b'\r' | b'\n')).next();
    first.is_some_and(|line| line.trim_ascii_end() == header().join(",").as_bytes())
}

/// The rungs of a file. Lines are counted on from `before`.
pub(super) fn read(bytes: &[u8], before: u32) -> Result<Grid, ReadError> {
    let mut records = csv::records(bytes, before)?.into_iter();
    let columns = header();
    let first = records.next();
    if !first.is_some_and(|record| record.fields.iter().map(|field| &field.text).eq(&columns)) {
        let message = "a grid begins with the line `marker,A,B,C,..,AE,AF`";
        return Err(ReadError::at(LineColumn::line(before + 1), message));
    }
    let mut grid = Grid::default();
    let mut above = Vec::new();
    for record in records {
        let place = record.place;
        let Some(marker) = record.fields.first() else {
            continue;
        };
        match marker.text.trim() {
            "#" => above.push(comment(&record)),
            marker if begins_rung(marker) => {
                let comments = std::mem::take(&mut above);
                let rows = vec![row(&record)?];
                if grid.rungs.len() == MOST_RUNGS {
                    let message =
                        format!("there are more than {MOST_RUNGS} rungs: make several programs of it");
                    return Err(ReadError::at(place, message));
                }
                grid.rungs.push(GridRung { comments, rows });
            }
            "" if record.fields.iter().all(|field| field.text.is_empty()) => {}
            "" => {
                let Some(rung) = grid.rungs.last_mut().filter(|_| above.is_empty()) else {
                    let message = "a row without `R` goes on with the rung above it, and there is none: mark the first row of a rung with `R`";
                    return Err(ReadError::at(place, message));
                };
                if rung.rows.len() == MOST_ROWS {
                    let message =
                        format!("the rung has more than {MOST_ROWS} rows: make several rungs of it");
                    return Err(ReadError::at(place, message));
                }
                rung.rows.push(row(&record)?);
            }
            other => {
                let shown: String = other.chars().take(20).collect();
                let message = format!(
                    "`{shown}` is not a marker: a row begins with `R` (a rung), with nothing (the rung goes on) or with `#` (a comment)"
                );
                return Err(ReadError::at(place, message));
            }
        }
    }
    grid.end = above;
    Ok(grid)
}

/// Whether a row with this marker begins a rung: `R`, or with its number `R1`.
fn begins_rung(marker: &str) -> bool {
    let number = marker.strip_prefix('R');
    number.is_some_and(|number| number.bytes().all(|byte| byte.is_ascii_digit()))
}

/// The rows of one rung from lines as [`kept`] has them. None: they are not those of one rung.
pub(super) fn read_kept(lines: &[String]) -> Option<Vec<Row>> {
    let lines: Vec<String> = lines.iter().map(|line| whole(line)).collect::<Option<_>>()?;
    let text = format!("{}\n{}\n", header().join(","), lines.join("\n"));
    let mut grid = read(text.as_bytes(), 0).ok()?;
    let rung = grid.rungs.pop()?;
    let is_alone = grid.rungs.is_empty() && grid.end.is_empty() && rung.comments.is_empty();
    is_alone.then_some(rung.rows)
}

/// What a row has before its output when wire leads there.
const WIRE: &str = ",..,";

fn whole(line: &str) -> Option<String> {
    let (cells, fill, output) = match line.split_once(WIRE) {
        Some((cells, output)) => (cells, ",-", output),
        None => (line, ",", ""),
    };
    let missing = (COLUMNS + 1).checked_sub(cells.split(',').count())?;
    Some(format!("{cells}{},{output}", fill.repeat(missing)))
}

/// The lines of a rung, short: `..` is wire up to the output, and after what has no output nothing follows.
pub(super) fn kept(rung: &[Row]) -> Vec<String> {
    let short = |(line, row): (String, &Row)| {
        let wires = row
            .cells
            .iter()
            .rev()
            .take_while(|cell| cell.text() == "-")
            .count();
        match &row.output {
            Some(output) if wires > 0 => {
                let output = csv::field(&output.text);
                let cells = &line[..line.len() - output.len() - 1 - 2 * wires];
                format!("{cells}{WIRE}{output}")
            }
            Some(_) => line,
            None => line.trim_end_matches(',').to_owned(),
        }
    };
    rows(rung).into_iter().zip(rung).map(short).collect()
}

/// A comment row. What has commas may be there without quotes.
fn comment(record: &Record) -> Text {
    let rest: Vec<&str> = record.fields[1..]
        .iter()
        .map(|field| field.text.as_str())
        .collect();
    // A row of the grid's full width has nothing in its other cells.
    Text {
        text: rest.join(",").trim_end_matches(',').to_owned(),
        place: record.place,
    }
}

fn row(record: &Record) -> Result<Row, ReadError> {
    let [_, cells @ .., output] = &record.fields[..] else {
        return Err(wrong_width(record));
    };
    if cells.len() != COLUMNS {
        return Err(wrong_width(record));
    }
    Ok(Row {
        place: record.place,
        cells: cells
            .iter()
            .map(|cell| Cell::read(cell.text.trim(), cell.place))
            .collect(),
        output: Some(output)
            .filter(|output| !output.text.trim().is_empty())
            .map(|output| Text {
                text: output.text.trim().to_owned(),
                place: output.place,
            }),
    })
}

fn wrong_width(record: &Record) -> ReadError {
    let message = format!(
        "this row has {} fields; a row of the grid has {}: a marker, the cells A to AE, and AF",
        record.fields.len(),
        COLUMNS + 2
    );
    ReadError::at(record.place, message)
}

/// The file of a grid.
pub(super) fn write(grid: &Grid) -> String {
    let mut out = header().join(",");
    out.push('\n');
    for rung in &grid.rungs {
        comments(&rung.comments, &mut out);
        for line in rows(&rung.rows) {
            out.push_str(&line);
            out.push('\n');
        }
    }
    comments(&grid.end, &mut out);
    out
}

fn comments(comments: &[Text], out: &mut String) {
    for comment in comments {
        out.push_str(&format!("#,{}\n", csv::field(&comment.text)));
    }
}

/// The lines of a rung.
fn rows(rows: &[Row]) -> Vec<String> {
    let line = |(number, row): (usize, &Row)| {
        let marker = if number == 0 { "R" } else { "" };
        let cells = row.cells.iter().map(Cell::text);
        let output = row.output.as_ref().map(|output| output.text.clone());
        let fields = std::iter::once(marker.to_owned())
            .chain(cells)
            .chain([output.unwrap_or_default()]);
        let fields: Vec<String> = fields.map(|field| csv::field(&field)).collect();
        fields.join(",")
    };
    rows.iter().enumerate().map(line).collect()
}
