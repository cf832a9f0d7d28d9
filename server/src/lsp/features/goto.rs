//! `textDocument/definition`, `declaration`, `typeDefinition` and `implementation`.

use std::sync::Arc;

use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{GotoDefinitionParams, GotoDefinitionResponse, LocationLink};

use super::asked::{Places, about_place};
use crate::lsp::{capabilities::Links, shared::Shared};
use ladder_analysis::context::Context;
use ladder_ide::{Target, Workspace};
use ladder_syntax::TextSize;

/// Which of the four is asked for.
pub(crate) type Question = fn(&Context, TextSize, &dyn Workspace) -> Vec<Target>;

pub(crate) async fn goto(
    shared: &Arc<Shared>,
    params: GotoDefinitionParams,
    question: Question,
    links: fn(&Links) -> bool,
) -> Result<Option<GotoDefinitionResponse>> {
    let links = links(&shared.agreed().links);
    about_place(
        shared,
        params.text_document_position_params,
        move |asked, offset| {
            let targets = question(&asked.context, offset, &asked.elsewhere);
            if targets.is_empty() {
                return None;
            }
            let mut places = Places::of(asked);
            Some(if links {
                let link = |target: &Target| {
                    let place = places.location(&target.file, target.range)?;
                    Some(LocationLink {
                        origin_selection_range: None,
                        target_uri: place.uri,
                        target_range: place.range,
                        target_selection_range: places.range(&target.file, target.focus)?,
                    })
                };
                GotoDefinitionResponse::Link(targets.iter().filter_map(link).collect())
            } else {
                let place = |target: &Target| places.location(&target.file, target.focus);
                GotoDefinitionResponse::Array(targets.iter().filter_map(place).collect())
            })
        },
    )
    .await
}
