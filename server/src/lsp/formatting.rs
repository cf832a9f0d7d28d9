//! `textDocument/formatting`: many small edits, so that cursors and breakpoints stay where they are.

use std::sync::Arc;

use tower_lsp::jsonrpc::{Error, Result};
use tower_lsp::ls_types::{DocumentFormattingParams, TextEdit};

use super::blocking::blocking;
use super::convert;
use super::shared::Shared;

pub(super) async fn formatting(
    shared: &Arc<Shared>,
    params: DocumentFormattingParams,
) -> Result<Option<Vec<TextEdit>>> {
    let Some(revision) = shared.documents.get(params.text_document.uri.as_str()) else {
        return Ok(None);
    };
    let job = revision.clone();
    let edits = blocking(move |_| Some(convert::edits(&job, &job.format()?))).await?;
    // An answer names no version: edits for a text that has moved on would tear the drawing.
    if !shared.documents.is_current(&revision) {
        return Err(Error::content_modified());
    }
    Ok(edits)
}
