//! What most requests about a document have in common: the document, a job off the main thread, and places in the
//! files of its workspace as the protocol names them.

use std::collections::HashMap;
use std::sync::Arc;

use ladder_analysis::context::Context;
use ladder_analysis::library;
use ladder_documents::Revision;
use ladder_documents::other_files::{FileText, OtherFiles};
use ladder_syntax::{TextRange, TextSize};
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{Location, Position, Range, TextDocumentPositionParams, Uri};

use crate::lsp::transport::blocking::blocking;
use crate::lsp::{convert, session::shared::Shared};

/// A document that is asked about.
pub(crate) struct Asked {
    pub(crate) revision: Arc<Revision>,
    pub(crate) context: Arc<Context>,
    pub(crate) elsewhere: OtherFiles,
    /// Whether all other files are known: large ones are read later than what a person looks at.
    pub(crate) knows_others: bool,
    /// Whether the client can open the library's sources.
    pub(crate) opens_library: bool,
}

impl Asked {
    /// The offset of a position in the document.
    pub(crate) fn offset(&self, position: Position) -> TextSize {
        self.revision.offset(convert::our_position(position))
    }
}

/// A context, and whether it knows the other files.
type Known<'r> = (&'r Arc<Context>, bool);

/// Does a job about a document; nothing for one that is not open, or too large.
pub(crate) async fn about<T: Send + 'static>(
    shared: &Arc<Shared>,
    uri: &Uri,
    job: impl FnOnce(&Asked) -> Option<T> + Send + 'static,
) -> Result<Option<T>> {
    about_context(shared, uri, |revision| Some((revision.context()?, true)), job).await
}

/// As [`about`], with this context.
async fn about_context<T: Send + 'static>(
    shared: &Arc<Shared>,
    uri: &Uri,
    context: fn(&Revision) -> Option<Known<'_>>,
    job: impl FnOnce(&Asked) -> Option<T> + Send + 'static,
) -> Result<Option<T>> {
    let Some(revision) = shared.documents.get(uri.as_str()) else {
        return Ok(None);
    };
    let opens_library = shared.agreed().library_blocks;
    let (documents, companions) = (Arc::clone(&shared.documents), Arc::clone(&shared.companions));
    blocking(&*shared.host, move |cancel| {
        let elsewhere = OtherFiles::of(&revision, &documents, &companions, cancel);
        let (context, knows_others) = context(&revision)?;
        let context = Arc::clone(context);
        job(&Asked {
            revision,
            context,
            elsewhere,
            knows_others,
            opens_library,
        })
    })
    .await
}

/// As [`about`], at a place.
pub(crate) async fn about_place<T: Send + 'static>(
    shared: &Arc<Shared>,
    place: TextDocumentPositionParams,
    job: impl FnOnce(&Asked, TextSize) -> Option<T> + Send + 'static,
) -> Result<Option<T>> {
    about(shared, &place.text_document.uri, move |asked| {
        job(asked, asked.offset(place.position))
    })
    .await
}

/// As [`about_place`], before large files of the workspace are read: what a person looks at comes first.
pub(crate) async fn about_place_first<T: Send + 'static>(
    shared: &Arc<Shared>,
    place: TextDocumentPositionParams,
    job: impl FnOnce(&Asked, TextSize) -> Option<T> + Send + 'static,
) -> Result<Option<T>> {
    about_context(
        shared,
        &place.text_document.uri,
        Revision::first_context,
        move |asked| job(asked, asked.offset(place.position)),
    )
    .await
}

/// The files that an answer names, each read once.
pub(crate) struct Places<'e> {
    elsewhere: &'e OtherFiles,
    opens_library: bool,
    files: HashMap<Arc<str>, Option<(Uri, FileText)>>,
}

impl<'e> Places<'e> {
    pub(crate) fn of(asked: &'e Asked) -> Self {
        Places {
            elsewhere: &asked.elsewhere,
            opens_library: asked.opens_library,
            files: HashMap::new(),
        }
    }

    /// A file's address, and its text.
    pub(crate) fn file(&mut self, name: &Arc<str>) -> Option<&(Uri, FileText)> {
        let files = self.files.entry(Arc::clone(name));
        let found = files.or_insert_with(|| {
            if !self.opens_library && library::source(name).is_some() {
                return None;
            }
            let file = self.elsewhere.text(name)?;
            Some((convert::uri(&file.uri)?, file))
        });
        found.as_ref()
    }

    /// A range of a file.
    pub(crate) fn range(&mut self, name: &Arc<str>, range: TextRange) -> Option<Range> {
        let (_, file) = self.file(name)?;
        Some(convert::range(file.range(range)))
    }

    /// A place in a file.
    pub(crate) fn location(&mut self, name: &Arc<str>, range: TextRange) -> Option<Location> {
        let (uri, file) = self.file(name)?;
        Some(Location {
            uri: uri.clone(),
            range: convert::range(file.range(range)),
        })
    }
}
