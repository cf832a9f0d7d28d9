//! `textDocument/references` and `textDocument/documentHighlight`.

use std::sync::Arc;

use serde::{Serialize, Serializer};
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{
    DocumentHighlight, DocumentHighlightKind, DocumentHighlightParams, Location, ReferenceParams,
};

use super::asked::{Asked, Places, about_place};
use super::of_scenarios::{about_scenarios, scenarios_at};
use crate::document::Revision;
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
                written(asked, found, declarations)
            })
            .await?
        }
        None => {
            about_place(shared, place, move |asked, offset| {
                let found = ladder_ide::references(&asked.context, offset, &asked.elsewhere);
                written(asked, found, declarations)
            })
            .await?
        }
    };
    match text {
        Some(text) => prepared::answer(text),
        None => Ok(None),
    }
}

fn written(asked: &Asked, mut found: Vec<Reference>, declarations: bool) -> Option<String> {
    found.retain(|it| declarations || !it.usage.declares());
    let mut places = Places::of(asked);
    for it in &found {
        places.file(&it.file);
    }
    serde_json::to_string(&Locations(&found, &places)).ok()
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
