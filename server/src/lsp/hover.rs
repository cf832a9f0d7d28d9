//! `textDocument/hover`.

use std::sync::Arc;

use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{Hover, HoverContents, HoverParams};

use super::blocking::blocking;
use super::convert;
use super::markup;
use super::shared::Shared;

pub(super) async fn hover(shared: &Arc<Shared>, params: HoverParams) -> Result<Option<Hover>> {
    let place = params.text_document_position_params;
    let Some(revision) = shared.documents.get(place.text_document.uri.as_str()) else {
        return Ok(None);
    };
    let markdown = shared.agreed().markdown;
    blocking(move |_| {
        let analysis = revision.analysis()?;
        let hover = analysis.hover(revision.offset(convert::our_position(place.position)))?;
        let range = Some(convert::range_in(&revision, hover.range));
        let text = markup::linked(hover.markdown, &revision.uri);
        let contents = markup::content(markdown, text);
        Some(Hover {
            contents: HoverContents::Markup(contents),
            range,
        })
    })
    .await
}
