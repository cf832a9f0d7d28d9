//! `ladder.diagramText`: the diagram of an open program, drawn with characters.

use std::sync::Arc;

use ladder_live::diagram_text::{DiagramText, draw};
use ladder_live::{Action, Failure, argument_of};
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{ExecuteCommandParams, LSPAny};

use super::simulate::act;
use crate::lsp::answers::{error, json};
use crate::lsp::session::shared::Shared;
use crate::lsp::transport::blocking::blocking;

/// The command.
pub(crate) const DIAGRAM_TEXT: &str = "ladder.diagramText";

pub(crate) async fn execute(shared: &Arc<Shared>, params: ExecuteCommandParams) -> Result<LSPAny> {
    let asked: DiagramText = argument_of(DIAGRAM_TEXT, params.arguments).map_err(error)?;
    if let Some(session) = asked.session.clone() {
        return act(shared, &session, Action::DiagramText(asked)).await;
    }
    let failed = |message: String| error(Failure::Failed(message));
    let revision = shared.documents.get(&asked.uri);
    let revision = revision.ok_or_else(|| failed(format!("{} is not open in the editor", asked.uri)))?;
    let name = revision.name().to_owned();
    let drawn = blocking(&*shared.host, move |_| draw(&revision, &asked)).await?;
    json(&drawn.ok_or_else(|| failed(format!("{name} is too large to be drawn")))?)
}
