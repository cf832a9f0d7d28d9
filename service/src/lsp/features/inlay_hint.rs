//! `textDocument/inlayHint`: off unless the setting `inlayHints.enable` says otherwise.

use std::sync::Arc;

use ladder_syntax::TextRange;
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{InlayHint, InlayHintLabel, InlayHintParams, InlayHintTooltip};

use crate::lsp::transport::blocking::blocking;
use crate::lsp::{convert, session::shared::Shared};

pub(crate) async fn inlay_hint(
    shared: &Arc<Shared>,
    params: InlayHintParams,
) -> Result<Option<Vec<InlayHint>>> {
    if !shared.editor().inlay_hints {
        return Ok(None);
    }
    let Some(revision) = shared.documents.get(params.text_document.uri.as_str()) else {
        return Ok(None);
    };
    blocking(&*shared.host, move |_| {
        let range = convert::our_range(params.range);
        let (start, end) = (revision.offset(range.start), revision.offset(range.end));
        let within = TextRange::new(start.min(end), start.max(end));
        let found = ladder_ide::inlays(revision.context()?, within).into_iter();
        let hints = found.map(|inlay| InlayHint {
            position: convert::range_in(&revision, TextRange::empty(inlay.at)).start,
            label: InlayHintLabel::String(inlay.label),
            kind: None,
            text_edits: None,
            tooltip: inlay.whole.map(InlayHintTooltip::String),
            padding_left: Some(true),
            padding_right: None,
            data: None,
        });
        Some(hints.collect())
    })
    .await
}
