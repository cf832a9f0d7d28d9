//! The inside of the server, as the tests of other packages see it. No part of the interface.

use std::sync::Arc;

use ladder_analysis::Diagnostic;

use crate::document::edit::Change;
use crate::document::position::Encoding;
use crate::document::position::{Position, Range};
use crate::document::{Documents, Kind, Revision};

const URI: &str = "untitled:main.clad";

/// The unit in which positions count.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unit {
    /// Bytes.
    Utf8,
    /// UTF-16 code units.
    Utf16,
    /// Unicode scalar values.
    Utf32,
}

/// An open document.
#[derive(Debug)]
pub struct Document {
    documents: Documents,
    revision: Arc<Revision>,
}

impl Document {
    /// Opens it.
    pub fn open(text: &str, unit: Unit) -> Document {
        let encoding = match unit {
            Unit::Utf8 => Encoding::Utf8,
            Unit::Utf16 => Encoding::Utf16,
            Unit::Utf32 => Encoding::Utf32,
        };
        let documents = Documents::default();
        let revision = documents.open_at(URI, Kind::Program, 0, encoding, text, None);
        Document { documents, revision }
    }

    /// Changes a stretch, or the whole text, as an editor does.
    ///
    /// # Panics
    /// The document refuses the change, though its version is newer.
    pub fn change(&mut self, range: Option<Range>, text: &str) {
        let text = text.to_owned();
        let change = match range {
            Some(range) => Change::Part { range, text },
            None => Change::Whole(text),
        };
        let version = self.revision.version + 1;
        self.revision = self
            .documents
            .change(URI, version, &[change])
            .unwrap_or_else(|refused| panic!("{refused}"));
    }

    /// What it says now.
    pub fn text(&self) -> String {
        self.revision.text()
    }

    /// What is found in it, with the places as the editor gets them.
    pub fn findings(&self) -> Vec<(Range, Diagnostic)> {
        let Some(analysis) = self.revision.analysis() else {
            return Vec::new();
        };
        let found = analysis.findings().iter();
        let placed = found.map(|found| (self.revision.range(found.range), found.diagnostic()));
        placed.collect()
    }

    /// The byte of a position.
    pub fn offset(&self, position: Position) -> usize {
        self.revision.offset(position).into()
    }
}
