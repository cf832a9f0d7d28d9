//! `textDocument/references` and `textDocument/documentHighlight`.

use std::sync::Arc;

use ladder_documents::{Revision, in_parallel};
use ladder_ide::{Highlight, Reference, Usage, highlights};
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{
    DocumentHighlight, DocumentHighlightKind, DocumentHighlightParams, Location, ReferenceParams,
};

use super::asked::{Asked, about_place};
use super::of_scenarios::{about_scenarios, naming_at};
use crate::lsp::transport::answered::as_text;
use crate::lsp::{convert, session::shared::Shared};

pub(crate) async fn references(
    shared: &Arc<Shared>,
    params: ReferenceParams,
) -> Result<Option<Vec<Location>>> {
    let declarations = params.context.include_declaration;
    let place = params.text_document_position;
    let found = match naming_at(shared, &place.text_document.uri) {
        Some(revision) => {
            about_scenarios(shared, revision, move |scenarios| {
                let asked = scenarios.program.as_ref()?;
                let offset = scenarios.offset(place.position);
                let found = ladder_ide::scenario_references(&scenarios.read(), offset);
                Some(locations(asked, found, declarations))
            })
            .await
        }
        None => {
            about_place(shared, place, move |asked, offset| {
                let found = ladder_ide::references(&asked.context, offset, &asked.elsewhere);
                Some(locations(asked, found, declarations))
            })
            .await
        }
    };
    found.map(as_text)
}

/// Each file by itself, on all processors.
fn locations(asked: &Asked, mut found: Vec<Reference>, declarations: bool) -> Vec<Location> {
    found.retain(|it| declarations || !it.usage.declares());
    let files: Vec<&[Reference]> = found.chunk_by(|a, b| a.file == b.file).collect();
    in_parallel::map(&files, |places| in_file(asked, places)).concat()
}

/// The places in one file.
fn in_file(asked: &Asked, places: &[Reference]) -> Option<Vec<Location>> {
    let file = asked.elsewhere.text(&places.first()?.file)?;
    let uri = convert::uri(&file.uri)?;
    let locations = places.iter().map(|place| Location {
        uri: uri.clone(),
        range: convert::range(file.range(place.range)),
    });
    Some(locations.collect())
}

pub(crate) async fn highlight(
    shared: &Arc<Shared>,
    params: DocumentHighlightParams,
) -> Result<Option<Vec<DocumentHighlight>>> {
    let place = params.text_document_position_params;
    if let Some(revision) = naming_at(shared, &place.text_document.uri) {
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
