//! The open programs of other systems whose ladder text the client follows.

use std::collections::HashMap;
use std::sync::{Mutex, MutexGuard, PoisonError};

use crate::notation::messages::Previewed;

/// Whose ladder text is followed: by address, with what was sent last.
#[derive(Debug, Default)]
pub(crate) struct Previews {
    sent: Mutex<HashMap<String, String>>,
}

impl Previews {
    /// Whether a client follows the ladder text of a program.
    pub(crate) fn follow(&self, uri: &str) -> bool {
        self.lock().contains_key(uri)
    }

    /// From now on a client does, which has this text.
    pub(crate) fn begin(&self, uri: &str, text: &str) {
        self.lock().insert(uri.to_owned(), text.to_owned());
    }

    /// The program is gone from the editor.
    pub(crate) fn end(&self, uri: &str) {
        self.lock().remove(uri);
    }

    /// Whether this is new to the one who follows. True once: it is sent then.
    pub(crate) fn is_news(&self, previewed: &Previewed) -> bool {
        let mut sent = self.lock();
        let last = sent.get_mut(&previewed.uri);
        let Some(last) = last.filter(|last| **last != previewed.text) else {
            return false;
        };
        last.clone_from(&previewed.text);
        true
    }

    /// A panic elsewhere leaves at worst a text that is sent twice.
    fn lock(&self) -> MutexGuard<'_, HashMap<String, String>> {
        self.sent.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
