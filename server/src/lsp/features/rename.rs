//! `textDocument/prepareRename` and `textDocument/rename`.

use std::collections::HashMap;
use std::sync::Arc;

use tower_lsp::jsonrpc::{Error, ErrorCode, Result};
use tower_lsp::ls_types::{
    DocumentChanges, OneOf, OptionalVersionedTextDocumentIdentifier, PrepareRenameResponse, RenameParams,
    TextDocumentEdit, TextDocumentPositionParams, TextEdit, Uri, WorkspaceEdit,
};

use super::asked::{Asked, Places, about_place};
use crate::document::Revision;
use crate::lsp::transport::prepared;
use crate::lsp::{convert, shared::Shared};
use ladder_ide::{RenameRefused, Renamed};

/// `RequestFailed`: the request made sense, and cannot be done.
const REQUEST_FAILED: i64 = -32803;

/// The files to change: the address, the document if it is open, and the edits.
type Changes = Vec<(Uri, Option<Arc<Revision>>, Vec<TextEdit>)>;

pub(crate) async fn prepare(
    shared: &Arc<Shared>,
    place: TextDocumentPositionParams,
) -> Result<Option<PrepareRenameResponse>> {
    let prepared = about_place(shared, place, |asked, offset| {
        Some(match ladder_ide::prepare_rename(&asked.context, offset) {
            Err(refused) => Err(refused),
            Ok(found) => Ok(found.map(|it| PrepareRenameResponse::RangeWithPlaceholder {
                range: convert::range_in(&asked.revision, it.range),
                placeholder: it.name,
            })),
        })
    });
    match prepared.await? {
        Some(Err(why)) => Err(refused(why)),
        Some(Ok(found)) => Ok(found),
        None => Ok(None),
    }
}

pub(crate) async fn rename(shared: &Arc<Shared>, params: RenameParams) -> Result<Option<WorkspaceEdit>> {
    let versioned = shared.agreed().versioned_edits;
    let renamed = about_place(shared, params.text_document_position, move |asked, offset| {
        let options = asked.revision.format_options();
        let (analysis, new) = (&asked.context, params.new_name);
        let renamed = ladder_ide::rename(analysis, offset, &new, &asked.elsewhere, &options);
        Some(renamed.map(|files| {
            let changes = changes(asked, files);
            let open: Vec<_> = changes.iter().filter_map(|(_, open, _)| open.clone()).collect();
            (serde_json::to_string(&workspace_edit(versioned, changes)), open)
        }))
    });
    let (text, open) = match renamed.await? {
        Some(Err(why)) => return Err(refused(why)),
        Some(Ok((text, open))) => (text.map_err(|_| Error::internal_error())?, open),
        None => return Ok(None),
    };
    // Edits of a text that has moved on would tear it.
    let mut open = open.iter();
    if open.any(|it| !shared.documents.shows(it) && !shared.companions.shows(it)) {
        return Err(Error::content_modified());
    }
    prepared::answer(text)
}

fn refused(why: RenameRefused) -> Error {
    Error {
        code: ErrorCode::ServerError(REQUEST_FAILED),
        message: why.0.into(),
        data: None,
    }
}

fn changes(asked: &Asked, files: Vec<Renamed>) -> Changes {
    let mut places = Places::of(asked);
    let change = |renamed: Renamed| {
        let (uri, file) = places.file(&renamed.file)?;
        let edits = renamed.edits.into_iter().map(|edit| TextEdit {
            range: convert::range(file.range(edit.range)),
            new_text: edit.text,
        });
        Some((uri.clone(), file.revision.clone(), edits.collect()))
    };
    files.into_iter().filter_map(change).collect()
}

/// Bound to the versions of open documents, where the client can check them.
fn workspace_edit(versioned: bool, changes: Changes) -> WorkspaceEdit {
    if !versioned {
        let changes = changes.into_iter().map(|(uri, _, edits)| (uri, edits));
        return WorkspaceEdit {
            changes: Some(changes.collect::<HashMap<_, _>>()),
            ..WorkspaceEdit::default()
        };
    }
    let changes = changes
        .into_iter()
        .map(|(uri, revision, edits)| TextDocumentEdit {
            text_document: OptionalVersionedTextDocumentIdentifier {
                uri,
                version: revision.map(|revision| revision.version),
            },
            edits: edits.into_iter().map(OneOf::Left).collect(),
        });
    WorkspaceEdit {
        document_changes: Some(DocumentChanges::Edits(changes.collect())),
        ..WorkspaceEdit::default()
    }
}
