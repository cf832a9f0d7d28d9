//! The documents in which a person types, with the change that waits in each.

use std::collections::HashMap;
use std::mem;
use std::sync::{Mutex, PoisonError};

use tower_lsp::ls_types::TextDocumentSaveReason;

use ladder_documents::Revision;

/// So many lines wait: nobody writes more without looking.
const MOST_WRITTEN: usize = 500;

/// What is known of a document in which a person types.
#[derive(Debug, Default)]
struct Typing {
    /// The line of the change that waits to be checked.
    line: Option<u32>,
    /// The editor is about to save the document by itself.
    saves_itself: bool,
    /// How many line ends the document has.
    line_ends: u32,
    /// Nothing was in it before.
    began_empty: bool,
    /// What was written, the oldest first.
    written: Vec<Written>,
}

/// A line that a person has written. What it declares or uses has its counterpart in lines that are still to come.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Written {
    line: u32,
    /// The cursor has been elsewhere since.
    is_left: bool,
}

impl Typing {
    /// A change that begins in a line, after which the document has so many line ends.
    fn wrote(&mut self, line: u32, line_ends: u32) {
        let before = mem::replace(&mut self.line_ends, line_ends);
        let (added, removed) = (line_ends.saturating_sub(before), before.saturating_sub(line_ends));
        self.written
            .retain(|it| it.line < line || it.line > line + removed);
        for written in self.written.iter_mut().filter(|it| it.line > line) {
            written.line = written.line + added - removed;
        }
        let new = (line..=line + added).take(MOST_WRITTEN);
        self.written
            .extend(new.map(|line| Written { line, is_left: false }));
        let too_many = self.written.len().saturating_sub(MOST_WRITTEN);
        self.written.drain(..too_many);
    }

    /// The cursor is in a line. Whether it has come back to it.
    fn came_to(&mut self, line: u32) -> bool {
        let before = self.written.len();
        self.written.retain_mut(|written| {
            let is_back = written.line == line && written.is_left;
            written.is_left |= written.line != line;
            !is_back
        });
        self.written.len() < before
    }
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
                typing.wrote(line, revision.last_line());
            }
        });
    }

    /// A client says where its cursor is in a document. Returns the line of the change that waits there.
    pub(crate) fn follow(&self, revision: &Revision) -> Option<u32> {
        let begin = || Typing {
            line_ends: revision.last_line(),
            began_empty: revision.is_blank(),
            ..Typing::default()
        };
        self.with(|typed| typed.entry(revision.uri.to_string()).or_insert_with(begin).line)
    }

    /// The cursor is in a line. Whether it has come back to what was written there, which does not wait any longer.
    pub(crate) fn came_to(&self, uri: &str, line: u32) -> bool {
        self.with(|typed| typed.get_mut(uri).is_some_and(|typing| typing.came_to(line)))
    }

    /// The lines that were written and not come back to, and whether nothing was in the document before.
    pub(crate) fn written(&self, uri: &str) -> (Vec<u32>, bool) {
        self.with(|typed| {
            let Some(typing) = typed.get(uri) else {
                return Default::default();
            };
            let written = typing.written.iter().map(|it| it.line);
            (written.collect(), typing.began_empty)
        })
    }

    /// A person has saved a document: nothing waits any longer; whether something did.
    pub(crate) fn saved(&self, uri: &str) -> bool {
        self.with(|typed| {
            typed.get_mut(uri).is_some_and(|typing| {
                let waited = typing.line.take().is_some();
                let was_written = !mem::take(&mut typing.written).is_empty();
                typing.began_empty = false;
                waited || was_written
            })
        })
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

    /// A document was closed, or nobody types in it any longer. Whether something waited.
    pub(crate) fn forget(&self, uri: &str) -> bool {
        let typing = self.with(|typed| typed.remove(uri));
        typing.is_some_and(|typing| typing.line.is_some() || !typing.written.is_empty())
    }
}

#[cfg(test)]
mod tests {
    use super::Typing;

    #[test]
    fn a_line_waits_until_the_cursor_has_been_elsewhere_and_back() {
        let mut typing = Typing {
            line_ends: 20,
            ..Typing::default()
        };
        let written = |typing: &Typing| typing.written.iter().map(|it| it.line).collect::<Vec<_>>();
        typing.wrote(3, 20);
        // Enter, and what is written there.
        typing.wrote(3, 21);
        assert!(!typing.came_to(4));
        typing.wrote(4, 21);
        assert_eq!(written(&typing), [3, 4]);
        // Lines above come and go.
        typing.wrote(0, 23);
        assert_eq!(written(&typing), [5, 6, 0, 1, 2]);
        typing.wrote(0, 21);
        assert_eq!(written(&typing), [3, 4, 0]);
        assert!(!typing.came_to(0));
        assert!(typing.came_to(3));
        assert_eq!(written(&typing), [4, 0]);
        assert!(!typing.came_to(3));
    }
}
