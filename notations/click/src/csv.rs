//! Comma-separated values, with the place of each field.

use ::csv::{ReaderBuilder, StringRecord};
use ladder_notation::{LineColumn, Lines, ReadError};

/// A larger file is not read.
const MOST_BYTES: usize = 4 << 20;

/// A field without its quotes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Field {
    pub(super) text: String,
    pub(super) place: LineColumn,
}

/// A line, or several if a quoted field goes over its end.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Record {
    pub(super) place: LineColumn,
    pub(super) fields: Vec<Field>,
}

/// The records of a file; blank lines are none. Lines are counted on from `before`.
///
/// # Errors
///
/// If the file is large, or not UTF-8.
pub(super) fn records(bytes: &[u8], before: u32) -> Result<Vec<Record>, ReadError> {
    if bytes.len() > MOST_BYTES {
        return Err(ReadError::whole(format!(
            "the file is larger than {} MiB; programs are not",
            MOST_BYTES >> 20
        )));
    }
    let text = ladder_notation::text_of(bytes)?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let lines = Lines::of(text);
    let mut reader = ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .from_reader(text.as_bytes());
    let mut record = StringRecord::new();
    let mut out = Vec::new();
    loop {
        match reader.read_record(&mut record) {
            Ok(true) => {}
            Ok(false) => return Ok(out),
            Err(error) => return Err(ReadError::whole(format!("the file cannot be read: {error}"))),
        }
        let start = record.position().map_or(0, |position| position.byte() as usize);
        // The reader says where a record begins before it passes blank lines.
        let blank = text[start..].len() - text[start..].trim_start_matches(['\r', '\n']).len();
        let place = |at: usize| {
            let place = lines.place(text, at.min(text.len()));
            LineColumn {
                line: place.line + before,
                ..place
            }
        };
        out.push(with_places(&record, text, start + blank, &place));
    }
}

fn with_places(
    record: &StringRecord,
    text: &str,
    start: usize,
    place: &dyn Fn(usize) -> LineColumn,
) -> Record {
    let mut at = start;
    let field = |field: &str| {
        let place = place(at);
        let is_quoted = text.get(at..).is_some_and(|rest| rest.starts_with('"'));
        let quotes = if is_quoted {
            2 + field.matches('"').count()
        } else {
            0
        };
        at += field.len() + quotes + 1;
        let text = field.to_owned();
        Field { text, place }
    };
    Record {
        place: place(start),
        fields: record.iter().map(field).collect(),
    }
}

/// A field as it is written, in quotes where it needs them.
pub(super) fn field(text: &str) -> String {
    if !text.contains([',', '"', '\r', '\n']) {
        return text.to_owned();
    }
    format!("\"{}\"", text.replace('"', "\"\""))
}
