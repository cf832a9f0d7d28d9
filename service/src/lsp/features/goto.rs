//! `textDocument/definition`, `declaration`, `typeDefinition` and `implementation`.

use std::sync::Arc;

use ladder_analysis::context::Context;
use ladder_ide::{Target, Workspace};
use ladder_syntax::TextSize;
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{GotoDefinitionParams, GotoDefinitionResponse, LocationLink};

use super::asked::{Asked, Places, about_place};
use super::foreign_hover;
use super::of_scenarios::{about_scenarios, naming_at};
use crate::lsp::session::{agreed::Links, shared::Shared};

/// Which of the four is asked for.
pub(crate) type Question = fn(&Context, TextSize, &dyn Workspace) -> Vec<Target>;

pub(crate) async fn goto(
    shared: &Arc<Shared>,
    params: GotoDefinitionParams,
    question: Question,
    links: fn(&Links) -> bool,
) -> Result<Option<GotoDefinitionResponse>> {
    let links = links(&shared.agreed().links);
    let place = params.text_document_position_params;
    if let Some(revision) = naming_at(shared, &place.text_document.uri) {
        // A row leads to the tag of the program, whichever of the four is asked for.
        return about_scenarios(shared, revision, move |scenarios| {
            let asked = scenarios.program.as_ref()?;
            let offset = scenarios.offset(place.position);
            let targets = ladder_ide::scenario_definition(&scenarios.read(), offset);
            response(asked, &targets, links)
        })
        .await;
    }
    if let Some(revision) = foreign_hover::program_at(shared, &place.text_document.uri) {
        return foreign_hover::about_ladder(shared, revision, place.position, move |asked, offset| {
            let targets = question(&asked.context, offset, &asked.elsewhere);
            response(asked, &targets, links)
        })
        .await;
    }
    about_place(shared, place, move |asked, offset| {
        let targets = question(&asked.context, offset, &asked.elsewhere);
        response(asked, &targets, links)
    })
    .await
}

fn response(asked: &Asked, targets: &[Target], links: bool) -> Option<GotoDefinitionResponse> {
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
}
