//! `textDocument/hover`.

use std::sync::Arc;

use ladder_documents::Kind;
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{Hover, HoverContents, HoverParams};

use super::asked::about_place_first;
use super::of_scenarios::scene_attributes;
use super::{foreign_hover, of_scenarios, simulate};
use crate::lsp::{convert, markup, session::shared::Shared};

pub(crate) async fn hover(shared: &Arc<Shared>, params: HoverParams) -> Result<Option<Hover>> {
    let markdown = shared.agreed().markdown;
    let place = &params.text_document_position_params;
    if let Some(revision) = foreign_hover::program_at(shared, &place.text_document.uri) {
        let values = simulate::values_at(shared, place.text_document.uri.as_str(), place.position).await;
        return foreign_hover::hover(shared, markdown, revision, place.position, values).await;
    }
    if let Some(revision) = of_scenarios::naming_at(shared, &place.text_document.uri) {
        let position = place.position;
        return of_scenarios::about_scenarios(shared, revision, move |asked| {
            let offset = asked.offset(position);
            let (hover, file) = if asked.revision.kind() == Kind::Scene {
                ladder_ide::scene_hover(&asked.read(), offset, &scene_attributes())?
            } else {
                ladder_ide::scenario_hover(&asked.read(), offset)?
            };
            let file = asked.program.as_ref().zip(file);
            let text = match file.and_then(|(program, file)| program.elsewhere.text(&file)) {
                Some(file) => markup::linked(hover.markdown, &file.uri),
                None => hover.markdown,
            };
            Some(Hover {
                contents: HoverContents::Markup(markup::content(markdown, text)),
                range: Some(convert::range_in(&asked.revision, hover.range)),
            })
        })
        .await;
    }
    let values = simulate::values_at(shared, place.text_document.uri.as_str(), place.position).await;
    about_place_first(
        shared,
        params.text_document_position_params,
        move |asked, offset| {
            let hover = ladder_ide::hover(&asked.context, offset)?;
            let range = Some(convert::range_in(&asked.revision, hover.range));
            let mut text = markup::linked(hover.markdown, &asked.revision.uri);
            if asked.knows_others
                && let Some(elsewhere) =
                    ladder_ide::used_in_other_files(&asked.context, offset, &asked.elsewhere)
            {
                text = format!("{text}\n\n---\n\n{elsewhere}");
            }
            if !values.is_empty() {
                text = format!("{}\n\n---\n\n{text}", values.join("; "));
            }
            Some(Hover {
                contents: HoverContents::Markup(markup::content(markdown, text)),
                range,
            })
        },
    )
    .await
}
