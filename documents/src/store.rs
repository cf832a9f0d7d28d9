//! The open documents, by address.
//!
//! One plain mutex guards them and is never held over an `await` or over work: that is what keeps three
//! thousand changes in the order in which the editor sent them.

use std::collections::HashMap;
use std::fmt;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use ropey::Rope;

use crate::edit::{Change, apply};
use crate::kind::Kind;
use crate::membership::Membership;
use crate::position::Encoding;
use crate::revision::{Edited, Revision};

/// Why a change was not applied.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ChangeRefused {
    /// The editor never opened the document, or closed it.
    NotOpen,
    /// The change is not newer than the text it would change.
    OldVersion {
        /// The version of the open text.
        open: i32,
        /// The version the change names.
        sent: i32,
        /// Whether this has happened since the document was opened: once is worth a message to the person.
        again: bool,
    },
}

impl fmt::Display for ChangeRefused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ChangeRefused::NotOpen => write!(f, "the document is not open"),
            ChangeRefused::OldVersion { open, sent, .. } => write!(
                f,
                "version {sent} is not newer than version {open}, which is open; close the file and open it again"
            ),
        }
    }
}

/// The documents that the editor has open.
#[derive(Debug, Default)]
pub struct Documents {
    open: Mutex<Open>,
}

#[derive(Debug, Default)]
struct Open {
    documents: HashMap<String, Document>,
    openings: u64,
}

#[derive(Debug)]
struct Document {
    revision: Arc<Revision>,
    /// Whether a thread analyses this document now, and will go on with the newest revision when done.
    analysing: bool,
    /// Whether a change was refused: editor and server may see different texts since.
    refused: bool,
}

impl Documents {
    /// As [`Documents::open_at`], for a program that is not a file.
    pub fn open(&self, uri: &str, version: i32, encoding: Encoding, text: &str) -> Arc<Revision> {
        self.open_at(uri, Kind::Program, version, encoding, text, None)
    }

    /// Opens a document; a file has a place in its workspace. One that is open already is replaced: the editor's
    /// newest word counts.
    pub fn open_at(
        &self,
        uri: &str,
        kind: Kind,
        version: i32,
        encoding: Encoding,
        text: &str,
        place: Option<Membership>,
    ) -> Arc<Revision> {
        let mut open = self.lock();
        open.openings += 1;
        let rope = Rope::from_str(text);
        let revision = Arc::new(Revision::new(
            Arc::from(uri),
            kind,
            version,
            open.openings,
            encoding,
            rope,
            place,
        ));
        open.documents.insert(
            uri.to_owned(),
            Document {
                revision: revision.clone(),
                analysing: false,
                refused: false,
            },
        );
        revision
    }

    /// Applies the changes in their order, all or none.
    ///
    /// # Errors
    /// The document is not open, or has this version already; it stays as it is.
    pub fn change(
        &self,
        uri: &str,
        version: i32,
        changes: &[Change],
    ) -> Result<Arc<Revision>, ChangeRefused> {
        let mut open = self.lock();
        let document = open.documents.get_mut(uri).ok_or(ChangeRefused::NotOpen)?;
        let old = &document.revision;
        if version <= old.version {
            return Err(ChangeRefused::OldVersion {
                open: old.version,
                sent: version,
                again: std::mem::replace(&mut document.refused, true),
            });
        }
        let mut rope = old.rope().clone();
        let mut edited = Edited {
            at: old.edited().into(),
            edits: Some(Vec::new()),
        };
        for change in changes {
            let edit = apply(&mut rope, old.encoding(), change);
            edited.at = edit.as_ref().map_or(0, |edit| edit.old.start);
            edited.edits = edited.edits.zip(edit).map(|(mut edits, edit)| {
                edits.push(edit);
                edits
            });
        }
        document.revision = Arc::new(old.followed_by(version, rope, edited));
        Ok(document.revision.clone())
    }

    /// The same text once more, to be analysed again because other files have changed. `false` if it is not open.
    pub fn touch(&self, uri: &str) -> bool {
        let mut open = self.lock();
        let Some(document) = open.documents.get_mut(uri) else {
            return false;
        };
        let old = &document.revision;
        let edited = Edited {
            at: old.edited().into(),
            edits: Some(Vec::new()),
        };
        document.revision = Arc::new(old.followed_by(old.version, old.rope().clone(), edited));
        true
    }

    /// All open documents.
    pub fn all(&self) -> Vec<Arc<Revision>> {
        let open = self.lock();
        open.documents
            .values()
            .map(|document| document.revision.clone())
            .collect()
    }

    /// Forgets a document; `false` if it was not open.
    pub fn close(&self, uri: &str) -> bool {
        self.lock().documents.remove(uri).is_some()
    }

    /// The newest state of a document, or `None` if it is not open.
    pub fn get(&self, uri: &str) -> Option<Arc<Revision>> {
        self.lock()
            .documents
            .get(uri)
            .map(|document| document.revision.clone())
    }

    /// Whether this is what the editor shows now.
    pub fn is_current(&self, revision: &Revision) -> bool {
        self.lock()
            .documents
            .get(&*revision.uri)
            .is_some_and(|document| document.revision.is(revision))
    }

    /// Whether this is the text that the editor shows now, even if it is to be analysed again because other files
    /// have changed.
    pub fn shows(&self, revision: &Revision) -> bool {
        self.lock().documents.get(&*revision.uri).is_some_and(|document| {
            let shown = &document.revision;
            (shown.version, shown.opening) == (revision.version, revision.opening)
        })
    }

    /// The revision to analyse, for the one who may begin; `None` if the document is being analysed, in which
    /// case [`Documents::analysed`] hands the newest revision to the thread that does.
    pub fn begin_analysis(&self, uri: &str) -> Option<Arc<Revision>> {
        let mut open = self.lock();
        let document = open
            .documents
            .get_mut(uri)
            .filter(|document| !document.analysing)?;
        document.analysing = true;
        Some(document.revision.clone())
    }

    /// Ends the analysis of `done`: the revision to go on with if the document has changed meanwhile.
    pub fn analysed(&self, done: &Revision) -> Option<Arc<Revision>> {
        let mut open = self.lock();
        let document = open.documents.get_mut(&*done.uri)?;
        if document.revision.opening != done.opening {
            return None;
        }
        if document.revision.is(done) {
            document.analysing = false;
            return None;
        }
        Some(document.revision.clone())
    }

    /// A panic elsewhere leaves the map whole: every method changes it in one step.
    fn lock(&self) -> MutexGuard<'_, Open> {
        self.open.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::position::{Position, Range};

    const URI: &str = "file:///motor.clad";

    fn insert_front(text: &str) -> Vec<Change> {
        vec![Change::Part {
            range: Range {
                start: Position::default(),
                end: Position::default(),
            },
            text: text.into(),
        }]
    }

    #[test]
    fn versions_only_grow() {
        let documents = Documents::default();
        documents.open(URI, 5, Encoding::Utf16, "x");
        assert_eq!(
            documents.change(URI, 5, &insert_front("a")).unwrap_err(),
            ChangeRefused::OldVersion {
                open: 5,
                sent: 5,
                again: false
            }
        );
        assert_eq!(
            documents.change(URI, 4, &insert_front("a")).unwrap_err(),
            ChangeRefused::OldVersion {
                open: 5,
                sent: 4,
                again: true
            }
        );
        assert_eq!(
            documents.get(URI).unwrap().rope(),
            "x",
            "a refused change leaves the text alone"
        );
        let revision = documents.change(URI, 9, &insert_front("a")).unwrap();
        assert_eq!(
            (revision.rope().to_string().as_str(), revision.version),
            ("ax", 9)
        );
    }

    #[test]
    fn a_change_to_a_closed_document_is_refused() {
        let documents = Documents::default();
        assert_eq!(documents.change(URI, 1, &[]).unwrap_err(), ChangeRefused::NotOpen);
        documents.open(URI, 1, Encoding::Utf16, "");
        assert!(documents.close(URI));
        assert!(!documents.close(URI));
        assert_eq!(documents.change(URI, 2, &[]).unwrap_err(), ChangeRefused::NotOpen);
    }

    #[test]
    fn one_analysis_at_a_time_and_then_the_newest() {
        let documents = Documents::default();
        documents.open(URI, 1, Encoding::Utf16, "");
        let first = documents.begin_analysis(URI).unwrap();
        documents.change(URI, 2, &insert_front("a")).unwrap();
        documents.change(URI, 3, &insert_front("b")).unwrap();
        assert!(documents.begin_analysis(URI).is_none(), "it is being analysed");
        assert!(!documents.is_current(&first));
        let next = documents.analysed(&first).unwrap();
        assert_eq!(next.version, 3);
        assert!(documents.is_current(&next));
        assert!(documents.analysed(&next).is_none());
        assert!(documents.begin_analysis(URI).is_some());
    }

    #[test]
    fn a_text_that_is_looked_at_again_is_the_same_text() {
        let documents = Documents::default();
        documents.open(URI, 1, Encoding::Utf16, "");
        let old = documents.get(URI).unwrap();
        assert!(documents.touch(URI));
        assert!(!documents.is_current(&old) && documents.shows(&old));
        documents.change(URI, 2, &insert_front("a")).unwrap();
        assert!(!documents.shows(&old));
    }

    #[test]
    fn a_reopened_document_is_another_one() {
        let documents = Documents::default();
        documents.open(URI, 1, Encoding::Utf16, "");
        let old = documents.begin_analysis(URI).unwrap();
        documents.close(URI);
        documents.open(URI, 1, Encoding::Utf16, "x");
        assert!(
            !documents.is_current(&old),
            "same address, same version, another text"
        );
        assert!(documents.begin_analysis(URI).is_some());
        assert!(!documents.shows(&old));
        assert!(
            documents.analysed(&old).is_none(),
            "and the old analysis does not go on with it"
        );
        assert!(documents.begin_analysis(URI).is_none());
    }
}
