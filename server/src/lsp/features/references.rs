//! `textDocument/references` and `textDocument/documentHighlight`.

use std::sync::Arc;

use serde::{Serialize, Serializer};
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{
    DocumentHighlight, DocumentHighlightKind, DocumentHighlightParams, Location, ReferenceParams,
};

use super::asked::{Places, about_place};
use crate::lsp::transport::prepared;
use crate::lsp::{convert, shared::Shared};
use ladder_ide::{Reference, Usage, highlights};

pub(crate) async fn references(
    shared: &Arc<Shared>,
    params: ReferenceParams,
) -> Result<Option<Vec<Location>>> {
    let declarations = params.context.include_declaration;
    let text = about_place(shared, params.text_document_position, move |asked, offset| {
        let mut found = ladder_ide::references(&asked.context, offset, &asked.elsewhere);
        found.retain(|it| declarations || !it.usage.declares());
        let mut places = Places::of(asked);
        for it in &found {
            places.file(&it.file);
        }
        serde_json::to_string(&Locations(&found, &places)).ok()
    });
    match text.await? {
        Some(text) => prepared::answer(text),
        None => Ok(None),
    }
}

/// As [`Location`]s.
struct Locations<'f>(&'f [Reference], &'f Places<'f>);

#[derive(Serialize)]
struct In<'f> {
    uri: &'f str,
    range: crate::Range,
}

impl Serialize for Locations<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        let Locations(found, places) = self;
        serializer.collect_seq(found.iter().filter_map(|it| {
            let (uri, file) = places.known(&it.file)?;
            Some(In {
                uri: uri.as_str(),
                range: file.range(it.range),
            })
        }))
    }
}

pub(crate) async fn highlight(
    shared: &Arc<Shared>,
    params: DocumentHighlightParams,
) -> Result<Option<Vec<DocumentHighlight>>> {
    about_place(shared, params.text_document_position_params, |asked, offset| {
        let found = highlights(&asked.context, offset).into_iter();
        let shown = found.map(|it| DocumentHighlight {
            range: convert::range_in(&asked.revision, it.range),
            kind: Some(match it.usage {
                Usage::Read => DocumentHighlightKind::READ,
                Usage::Write | Usage::ReadWrite => DocumentHighlightKind::WRITE,
                Usage::Definition | Usage::Declaration | Usage::Mention => DocumentHighlightKind::TEXT,
            }),
        });
        Some(shown.collect())
    })
    .await
}
