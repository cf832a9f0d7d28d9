//! Programs of other systems: a notation refuses bytes with a place that lies in them, or makes a text of them that is
//! whole and laid out, and that it can read again once it has written it.
//!
//! The input is a file.

use ladder_analysis::{Severity, analyze};
use ladder_format::{Options, format_text};
use ladder_notations::{Converted, LineColumn, NOTATIONS, Notation, Source};
use ladder_syntax::parse;
use std::ops::Range;
use std::sync::Arc;

pub(crate) fn check(data: &[u8]) {
    for notation in NOTATIONS {
        if let Some(converted) = read(*notation, data) {
            back(*notation, &converted);
        }
    }
}

/// What a notation makes of bytes, if it takes them.
fn read(notation: &dyn Notation, data: &[u8]) -> Option<Converted> {
    let source = Source::alone("program", data);
    let options = Options::default();
    let converted = match ladder_notations::convert(notation, &source, &options) {
        Ok(converted) => converted,
        Err(error) => {
            assert!(!error.message.is_empty(), "{}", notation.name());
            if let Some(place) = error.place {
                lies_in(notation, data, place);
            }
            return None;
        }
    };
    let text = &converted.written.text;
    let errors = parse(text).errors();
    assert!(
        errors.is_empty(),
        "{} wrote what cannot be read: {errors:?}\n{text}",
        notation.name()
    );
    assert_eq!(
        format_text(text, &options),
        *text,
        "{} is not laid out",
        notation.name()
    );
    for (range, origin) in &converted.written.places {
        assert!(
            text.get(Range::<usize>::from(*range)).is_some(),
            "{range:?} in:\n{text}"
        );
        lies_in(notation, data, converted.places[*origin as usize]);
    }
    for found in &converted.findings {
        lies_in(notation, data, found.place);
        assert!(!found.message.is_empty(), "{found:?}");
    }
    for entry in &converted.report.entries {
        lies_in(notation, data, entry.place);
    }
    Some(converted)
}

/// What a notation writes of a program that it has read, it can read.
fn back(notation: &dyn Notation, converted: &Converted) {
    let text = &converted.written.text;
    let analysis = analyze(&Arc::new(parse(text)), "main.clad");
    if analysis
        .diagnostics()
        .iter()
        .any(|found| found.severity == Severity::Error)
    {
        return;
    }
    let Ok(written) = notation.write(&analysis) else {
        return;
    };
    assert!(
        read(notation, &written.bytes).is_some(),
        "{} cannot read what it wrote:\n{}\nof\n{text}",
        notation.name(),
        String::from_utf8_lossy(&written.bytes)
    );
}

/// A place is one of the lines, or the one after the last.
fn lies_in(notation: &dyn Notation, data: &[u8], place: LineColumn) {
    let lines = data.split(|byte| *byte == b'\n').count();
    assert!(
        (1..=lines as u32 + 1).contains(&place.line) && place.column >= 1,
        "{}: {place} of {lines} lines",
        notation.name()
    );
}
