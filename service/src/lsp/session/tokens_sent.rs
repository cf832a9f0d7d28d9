//! The semantic tokens that the client has.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

use tower_lsp::ls_types::SemanticToken;

/// The tokens that were last sent of each document, so that only what changes is sent again.
#[derive(Debug, Default)]
pub(crate) struct TokensSent {
    by_uri: Mutex<HashMap<String, Last>>,
}

#[derive(Debug)]
struct Last {
    id: u64,
    tokens: Arc<Vec<SemanticToken>>,
}

impl TokensSent {
    /// Keeps what is sent now, and gives it a name.
    pub(crate) fn keep(&self, uri: &str, tokens: Arc<Vec<SemanticToken>>) -> String {
        let mut sent = self.by_uri.lock().unwrap_or_else(PoisonError::into_inner);
        let id = sent.get(uri).map_or(1, |last| last.id + 1);
        sent.insert(uri.to_owned(), Last { id, tokens });
        id.to_string()
    }

    /// What was sent by this name, if it was the last.
    pub(crate) fn last(&self, uri: &str, id: &str) -> Option<Arc<Vec<SemanticToken>>> {
        let sent = self.by_uri.lock().unwrap_or_else(PoisonError::into_inner);
        let last = sent.get(uri).filter(|last| last.id.to_string() == id)?;
        Some(last.tokens.clone())
    }

    /// The document is closed.
    pub(crate) fn forget(&self, uri: &str) {
        let mut sent = self.by_uri.lock().unwrap_or_else(PoisonError::into_inner);
        sent.remove(uri);
    }
}
