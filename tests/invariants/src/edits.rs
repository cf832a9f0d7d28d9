//! A document of the server that is edited is the text that the editor shows, and what is found in it is what is found
//! in that text.
//!
//! The first byte chooses the unit of positions, and the rest of the first part is a text. Each other part is a change: line
//! and unit of both ends, a byte each, and what comes. With 255 as first line it is the whole text that comes.

use crate::input::{Numbers, parts, text};
use crate::model::Model;
use ladder_analysis::Diagnostic;
use ladder_documents::edit::Change;
use ladder_documents::position::Encoding;
use ladder_documents::{Documents, Position, Range, Revision};
use std::sync::Arc;

/// More changes tell nothing new.
const MOST_CHANGES: usize = 12;

const URI: &str = "untitled:main.clad";

/// An open document.
struct Document {
    documents: Documents,
    revision: Arc<Revision>,
}

impl Document {
    fn open(text: &str, unit: Encoding) -> Document {
        let documents = Documents::default();
        let revision = documents.open(URI, 0, unit, text);
        Document { documents, revision }
    }

    /// Changes a stretch, or the whole text, as an editor does.
    fn change(&mut self, range: Option<Range>, text: &str) {
        let text = text.to_owned();
        let change = match range {
            Some(range) => Change::Part { range, text },
            None => Change::Whole(text),
        };
        let version = self.revision.version + 1;
        let changed = self.documents.change(URI, version, &[change]);
        self.revision = changed.unwrap_or_else(|refused| panic!("{refused}"));
    }

    /// What is found in it, with the places as the editor gets them.
    fn findings(&self) -> Vec<(Range, Diagnostic)> {
        let Some(analysis) = self.revision.analysis() else {
            return Vec::new();
        };
        let found = analysis.findings().iter();
        let placed = found.map(|found| (self.revision.range(found.range), found.diagnostic()));
        placed.collect()
    }
}

pub(crate) fn check(data: &[u8]) {
    let parts = parts(data);
    let mut first = Numbers(parts[0]);
    let unit = [Encoding::Utf8, Encoding::Utf16, Encoding::Utf32][first.small() % 3];
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

fn same(document: &Document, model: &Model, unit: Encoding) {
    assert_eq!(document.revision.text(), model.text);
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
