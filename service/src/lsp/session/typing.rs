//! The documents in which a person types, with the change that waits in each.

use std::collections::HashMap;
use std::mem;
use std::sync::{Mutex, PoisonError};

use tower_lsp::ls_types::TextDocumentSaveReason;

use crate::document::Revision;

/// What is known of a document in which a person types.
#[derive(Debug, Default)]
struct Typing {
    /// The line of the change that waits to be checked.
    line: Option<u32>,
    /// The editor is about to save the document by itself.
    saves_itself: bool,
}

/// The documents whose client says where its cursor is.
#[derive(Debug, Default)]
pub(crate) struct Typed(Mutex<HashMap<String, Typing>>);

impl Typed {
    fn with<T>(&self, job: impl FnOnce(&mut HashMap<String, Typing>) -> T) -> T {
        job(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }

    /// A document was changed.
    pub(crate) fn changed(&self, revision: &Revision) {
        let line = revision.line_of(revision.edited());
        self.with(|typed| {
            if let Some(typing) = typed.get_mut(&*revision.uri) {
                typing.line = Some(line);
            }
        });
    }

    /// A client says where its cursor is in a document. Gives the line of the change that waits there.
    pub(crate) fn follow(&self, uri: &str) -> Option<u32> {
        self.with(|typed| typed.entry(uri.to_owned()).or_default().line)
    }

    /// The line of the change that waits.
    pub(crate) fn waiting(&self, uri: &str) -> Option<u32> {
        self.with(|typed| typed.get(uri)?.line)
    }

    /// Nothing waits any longer; whether something did.
    pub(crate) fn release(&self, uri: &str) -> bool {
        self.with(|typed| {
            typed
                .get_mut(uri)
                .is_some_and(|typing| typing.line.take().is_some())
        })
    }

    /// A document is about to be saved.
    pub(crate) fn will_save(&self, uri: &str, reason: TextDocumentSaveReason) {
        self.with(|typed| {
            if let Some(typing) = typed.get_mut(uri) {
                typing.saves_itself = reason == TextDocumentSaveReason::AFTER_DELAY;
            }
        });
    }

    /// A document was saved: whether its editor did that by itself.
    pub(crate) fn saved_itself(&self, uri: &str) -> bool {
        self.with(|typed| {
            typed
                .get_mut(uri)
                .is_some_and(|typing| mem::take(&mut typing.saves_itself))
        })
    }

    /// A document was closed.
    pub(crate) fn forget(&self, uri: &str) {
        self.with(|typed| typed.remove(uri));
    }
}
