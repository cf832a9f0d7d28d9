//! `ladder.crossReference`: where each tag of an open program is read and written.

use std::sync::Arc;

use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{ExecuteCommandParams, LSPAny};

use crate::cross_reference::{CrossReference, list};
use crate::lsp::answers::{error, json};
use crate::lsp::session::shared::Shared;
use crate::lsp::transport::blocking::blocking;
use crate::simulation::{Failure, argument_of};

/// The command.
pub(crate) const CROSS_REFERENCE: &str = "ladder.crossReference";

pub(crate) async fn execute(shared: &Arc<Shared>, params: ExecuteCommandParams) -> Result<LSPAny> {
    let asked: CrossReference = argument_of(CROSS_REFERENCE, params.arguments).map_err(error)?;
    let failed = |message: String| error(Failure::Failed(message));
    let revision = shared.documents.get(&asked.uri);
    let revision = revision.ok_or_else(|| failed(format!("{} is not open in the editor", asked.uri)))?;
    let name = revision.name().to_owned();
    let listed = blocking(&*shared.host, move |_| list(&revision, &asked)).await?;
    json(&listed.ok_or_else(|| failed(format!("{name} is too large for a cross-reference")))?)
}
