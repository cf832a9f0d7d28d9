//! A document of the server that is edited is the text that the editor shows, and what is found in it is what is found
//! in that text.
//!
//! The first byte chooses the unit of positions, and the rest of the first part is a text. Each other part is a change: line
//! and unit of both ends, a byte each, and what comes. With 255 as first line it is the whole text that comes.

use crate::input::{Numbers, parts, text};
use crate::model::Model;
use ladder_service::probe::{Document, Unit};
use ladder_service::{Position, Range};

/// More changes tell nothing new.
const MOST_CHANGES: usize = 12;

pub(crate) fn check(data: &[u8]) {
    let parts = parts(data);
    let mut first = Numbers(parts[0]);
    let unit = [Unit::Utf8, Unit::Utf16, Unit::Utf32][first.small() % 3];
    let text_at_first = text(first.0);
    let mut document = Document::open(&text_at_first, unit);
    let mut model = Model::new(text_at_first, unit);
    same(&document, &model, unit);
    for part in parts.iter().skip(1).take(MOST_CHANGES) {
        let mut numbers = Numbers(part);
        let range = range(&mut numbers);
        let new = text(numbers.0);
        document.change(range, &new);
        match range {
            Some(range) => model.replace(range, &new),
            None => model.text = new,
        }
        same(&document, &model, unit);
    }
}

fn range(numbers: &mut Numbers) -> Option<Range> {
    let line = numbers.small();
    if line == 255 {
        return None;
    }
    let mut unit = || match numbers.small() as u32 {
        // Far outside.
        255 => u32::MAX,
        near => near,
    };
    let start = Position {
        line: line as u32,
        character: unit(),
    };
    let end = Position {
        line: unit(),
        character: unit(),
    };
    Some(Range { start, end })
}

fn same(document: &Document, model: &Model, unit: Unit) {
    assert_eq!(document.text(), model.text);
    let found = document.findings();
    let again = Document::open(&model.text, unit).findings();
    assert_eq!(found.len(), again.len(), "findings of\n{}", model.text);
    for ((place, found), (place_again, found_again)) in found.iter().zip(&again) {
        assert_eq!(found, found_again, "in\n{}", model.text);
        assert_eq!(place, place_again, "{found:?} in\n{}", model.text);
        let start = model.position(found.range.start().into());
        let end = model.position(found.range.end().into());
        assert_eq!(*place, Range { start, end }, "{found:?} in\n{:?}", model.text);
    }
}
