//! Opening, changing and closing documents.
//!
//! These functions are not `async`: the handlers call them first, before any `await`, which keeps changes in the
//! order in which they came (the framework runs several handlers at once).

use std::sync::Arc;

use serde::Deserialize;
use tower_lsp::jsonrpc::Request;
use tower_lsp::ls_types::{
    CancelParams, DidChangeConfigurationParams, DidChangeTextDocumentParams, DidChangeWatchedFilesParams,
    DidCloseTextDocumentParams, DidOpenTextDocumentParams, TextDocumentContentChangeEvent,
};

use super::convert::our_range;
use super::diagnostics;
use super::shared::Shared;
use crate::document::edit::Change;
use crate::document::neighbours::Place;
use crate::document::{Refused, address};

pub(super) fn opened(shared: &Arc<Shared>, params: DidOpenTextDocumentParams) {
    let document = params.text_document;
    let uri = document.uri.as_str();
    if shared.documents.get(uri).is_some() {
        shared.outbox.log(format!(
            "{uri} was opened twice without being closed; the newer text counts"
        ));
    }
    let place = address::path_of(uri).map(|path| Place::new(path, &shared.neighbours));
    shared.documents.open_at(
        uri,
        document.version,
        shared.agreed().encoding,
        &document.text,
        place,
    );
    shared.text_moved(uri);
    diagnostics::refresh(shared, uri);
}

pub(super) fn changed(shared: &Arc<Shared>, params: DidChangeTextDocumentParams) {
    let uri = params.text_document.uri.as_str();
    let changes: Vec<_> = params.content_changes.into_iter().map(change).collect();
    match shared
        .documents
        .change(uri, params.text_document.version, &changes)
    {
        Ok(_) => {
            shared.text_moved(uri);
            diagnostics::refresh(shared, uri);
        }
        Err(refused) => {
            let message = format!("a change to {uri} was refused: {refused}");
            // From here on editor and server see different texts: that is for the person to know.
            if matches!(refused, Refused::OldVersion { again: false, .. }) {
                shared.outbox.show(&message);
            }
            shared.outbox.log(message);
        }
    }
}

pub(super) fn closed(shared: &Arc<Shared>, params: &DidCloseTextDocumentParams) {
    let uri = params.text_document.uri.as_str();
    if shared.documents.close(uri) {
        shared.document_closed(uri);
        shared.outbox.no_diagnostics(uri);
        if let Some(path) = address::path_of(uri) {
            diagnostics::neighbour_closed(shared, uri.to_owned(), path);
        }
    } else {
        shared
            .outbox
            .log(format!("{uri} was closed, but it was not open"));
    }
}

/// Files beside the open documents were changed, made or removed.
pub(super) fn watched(shared: &Arc<Shared>, params: &DidChangeWatchedFilesParams) {
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

/// What is wrong with the parameters of a notification, if anything. The framework drops such a notification
/// without a word, and an editor would never learn why its changes have no effect.
pub(super) fn misread(notification: &Request) -> Option<String> {
    let params = notification.params()?;
    let error = match notification.method() {
        "textDocument/didOpen" => DidOpenTextDocumentParams::deserialize(params).err(),
        "textDocument/didChange" => DidChangeTextDocumentParams::deserialize(params).err(),
        "workspace/didChangeConfiguration" => DidChangeConfigurationParams::deserialize(params).err(),
        "workspace/didChangeWatchedFiles" => DidChangeWatchedFilesParams::deserialize(params).err(),
        "textDocument/didClose" => DidCloseTextDocumentParams::deserialize(params).err(),
        "$/cancelRequest" => CancelParams::deserialize(params).err(),
        _ => None,
    }?;
    Some(format!(
        "{} was ignored, its parameters make no sense: {error}",
        notification.method()
    ))
}
