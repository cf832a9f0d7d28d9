//! Opening, changing and closing documents.
//!
//! These functions are not `async`: the handlers call them first, before any `await`, which keeps changes in the
//! order in which they came (the framework runs several handlers at once).

use std::sync::Arc;

use ladder_documents::edit::Change;
use ladder_documents::membership::Membership;
use ladder_documents::{ChangeRefused, Kind, address};
use tower_lsp::ls_types::{
    DidChangeTextDocumentParams, DidChangeWatchedFilesParams, DidCloseTextDocumentParams,
    DidOpenTextDocumentParams, DidSaveTextDocumentParams, TextDocumentContentChangeEvent,
    WillSaveTextDocumentParams,
};

use super::{companions, diagnostics, typed, watch};
use crate::lsp::{convert::our_range, session::shared::Shared};

pub(crate) fn opened(shared: &Arc<Shared>, params: DidOpenTextDocumentParams) {
    let document = params.text_document;
    let uri = document.uri.as_str();
    let kind = Kind::of(uri, &document.language_id, &document.text);
    let store = match kind {
        Kind::Program => &shared.documents,
        Kind::Foreign(_) | Kind::Settings | Kind::Scenarios | Kind::Scene | Kind::Other => &shared.companions,
    };
    if shared.documents.get(uri).is_some() || shared.companions.get(uri).is_some() {
        shared.outbox.log(format!(
            "{uri} was opened twice without being closed; the newer text counts"
        ));
        shared.documents.close(uri);
        shared.companions.close(uri);
    }
    let place = address::path_of(uri).map(|path| Membership::new(path, &shared.neighbours));
    if let Some(place) = place.as_ref().filter(|_| kind == Kind::Program) {
        shared.neighbours.opened(&place.path);
    }
    let encoding = shared.agreed().encoding;
    store.open_at(uri, kind, document.version, encoding, &document.text, place);
    shared.text_moved(uri);
    text_is_new(shared, uri);
}

pub(crate) fn changed(shared: &Arc<Shared>, params: DidChangeTextDocumentParams) {
    let uri = params.text_document.uri.as_str();
    let changes: Vec<_> = params.content_changes.into_iter().map(change).collect();
    let version = params.text_document.version;
    let done = match shared.companions.change(uri, version, &changes) {
        Err(ChangeRefused::NotOpen) => shared.documents.change(uri, version, &changes),
        done => done,
    };
    match done {
        Ok(revision) => {
            shared.typed.changed(&revision);
            shared.text_moved(uri);
            text_is_new(shared, uri);
        }
        Err(refused) => {
            let message = format!("a change to {uri} was refused: {refused}");
            // From here on editor and server see different texts: that is for the person to know.
            if matches!(refused, ChangeRefused::OldVersion { again: false, .. }) {
                shared.outbox.show(&message);
            }
            shared.outbox.log(message);
        }
    }
}

fn text_is_new(shared: &Arc<Shared>, uri: &str) {
    if shared.companions.get(uri).is_some() {
        companions::refresh(shared, uri);
    } else {
        diagnostics::refresh(shared, uri);
    }
    watch::look_around(shared);
}

pub(crate) fn closed(shared: &Arc<Shared>, params: &DidCloseTextDocumentParams) {
    let uri = params.text_document.uri.as_str();
    if shared.companions.close(uri) {
        shared.sessions.stop_all_of(uri);
        companions::closed(shared, uri);
    } else if shared.documents.close(uri) {
        shared.document_closed(uri);
        if !shared.agreed().pulls_diagnostics {
            shared.outbox.no_diagnostics(uri);
        }
        if let Some(path) = address::path_of(uri) {
            diagnostics::neighbour_closed(shared, uri.to_owned(), path);
        }
    } else {
        shared
            .outbox
            .log(format!("{uri} was closed, but it was not open"));
    }
}

/// A document is about to be saved.
pub(crate) fn will_save(shared: &Shared, params: &WillSaveTextDocumentParams) {
    shared
        .typed
        .will_save(params.text_document.uri.as_str(), params.reason);
}

/// A document was saved: for a client that does not report changed files.
pub(crate) fn saved(shared: &Arc<Shared>, params: &DidSaveTextDocumentParams) {
    typed::saved(shared, params.text_document.uri.as_str());
    if !shared.agreed().watches_files
        && let Some(path) = address::path_of(params.text_document.uri.as_str())
    {
        diagnostics::disk_changed(shared, vec![path]);
    }
}

/// Files next to the open documents were changed, made or removed.
pub(crate) fn watched(shared: &Arc<Shared>, params: &DidChangeWatchedFilesParams) {
    let paths = params.changes.iter();
    let paths: Vec<_> = paths
        .filter_map(|change| address::path_of(change.uri.as_str()))
        .collect();
    diagnostics::disk_changed(shared, paths);
}

fn change(event: TextDocumentContentChangeEvent) -> Change {
    match event.range {
        Some(range) => Change::Part {
            range: our_range(range),
            text: event.text,
        },
        None => Change::Whole(event.text),
    }
}
