//! `textDocument/references` and `textDocument/documentHighlight`.

use std::sync::Arc;

use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{
    DocumentHighlight, DocumentHighlightKind, DocumentHighlightParams, Location, ReferenceParams,
};

use super::asked::{Asked, about_place};
use super::of_scenarios::{about_scenarios, scenarios_at};
use crate::document::{Revision, together};
use crate::lsp::transport::prepared;
use crate::lsp::{convert, shared::Shared};
use ladder_ide::{Highlight, Reference, Usage, highlights};

pub(crate) async fn references(
    shared: &Arc<Shared>,
    params: ReferenceParams,
) -> Result<Option<Vec<Location>>> {
    let declarations = params.context.include_declaration;
    let place = params.text_document_position;
    let text = match scenarios_at(shared, &place.text_document.uri) {
        Some(revision) => {
            about_scenarios(shared, revision, move |scenarios| {
                let asked = scenarios.program.as_ref()?;
                let offset = scenarios.offset(place.position);
                let found = ladder_ide::scenario_references(&scenarios.read(), offset);
                Some(written(asked, found, declarations))
            })
            .await?
        }
        None => {
            about_place(shared, place, move |asked, offset| {
                let found = ladder_ide::references(&asked.context, offset, &asked.elsewhere);
                Some(written(asked, found, declarations))
            })
            .await?
        }
    };
    match text {
        Some(text) => prepared::answer(text),
        None => Ok(None),
    }
}

/// As [`Location`]s: each file by itself, on all processors.
fn written(asked: &Asked, mut found: Vec<Reference>, declarations: bool) -> String {
    found.retain(|it| declarations || !it.usage.declares());
    let files: Vec<&[Reference]> = found.chunk_by(|a, b| a.file == b.file).collect();
    let pieces: Vec<String> = together::map(&files, |places| in_file(asked, places));
    let length: usize = pieces.iter().map(|piece| piece.len() + 1).sum();
    let mut text = String::with_capacity(length + 2);
    text.push('[');
    for piece in pieces {
        if text.len() > 1 {
            text.push(',');
        }
        text.push_str(&piece);
    }
    text.push(']');
    text
}

/// The places in one file, parted by commas.
fn in_file(asked: &Asked, places: &[Reference]) -> Option<String> {
    let file = asked.elsewhere.text(&places.first()?.file)?;
    let uri = serde_json::to_string(convert::uri(&file.uri)?.as_str()).ok()?;
    let mut text = Vec::with_capacity(places.len() * (uri.len() + 96));
    for place in places {
        if !text.is_empty() {
            text.push(b',');
        }
        text.extend_from_slice(br#"{"uri":"#);
        text.extend_from_slice(uri.as_bytes());
        text.extend_from_slice(br#","range":"#);
        serde_json::to_writer(&mut text, &file.range(place.range)).ok()?;
        text.push(b'}');
    }
    String::from_utf8(text).ok()
}

pub(crate) async fn highlight(
    shared: &Arc<Shared>,
    params: DocumentHighlightParams,
) -> Result<Option<Vec<DocumentHighlight>>> {
    let place = params.text_document_position_params;
    if let Some(revision) = scenarios_at(shared, &place.text_document.uri) {
        return about_scenarios(shared, revision, move |scenarios| {
            let found = ladder_ide::scenario_highlights(&scenarios.read(), scenarios.offset(place.position));
            Some(shown(&scenarios.revision, found))
        })
        .await;
    }
    about_place(shared, place, |asked, offset| {
        Some(shown(&asked.revision, highlights(&asked.context, offset)))
    })
    .await
}

fn shown(revision: &Revision, found: Vec<Highlight>) -> Vec<DocumentHighlight> {
    let shown = found.into_iter().map(|it| DocumentHighlight {
        range: convert::range_in(revision, it.range),
        kind: Some(match it.usage {
            Usage::Read => DocumentHighlightKind::READ,
            Usage::Write | Usage::ReadWrite => DocumentHighlightKind::WRITE,
            Usage::Definition | Usage::Declaration | Usage::Mention => DocumentHighlightKind::TEXT,
        }),
    });
    shown.collect()
}
