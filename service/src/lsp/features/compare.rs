//! `ladder.compare`: what changed in an open program since an earlier text.

use std::sync::Arc;

use ladder_review::while_wanted;
use tower_lsp::jsonrpc::{Error, Result};
use tower_lsp::ls_types::{ExecuteCommandParams, LSPAny};

use crate::compare::{Compare, compare_with};
use crate::lsp::answers::{error, json};
use crate::lsp::session::shared::Shared;
use crate::lsp::transport::blocking::blocking;
use crate::simulation::{Failure, argument_of};

/// The command.
pub(crate) const COMPARE: &str = "ladder.compare";

pub(crate) async fn execute(shared: &Arc<Shared>, params: ExecuteCommandParams) -> Result<LSPAny> {
    let asked: Compare = argument_of(COMPARE, params.arguments).map_err(error)?;
    let failed = |message: String| error(Failure::Failed(message));
    let revision = shared.documents.get(&asked.uri);
    let revision = revision.ok_or_else(|| failed(format!("{} is not open in the editor", asked.uri)))?;
    let (of, documents) = (revision.clone(), Arc::clone(&shared.documents));
    let compared = blocking(&*shared.host, move |cancel| {
        let (cancel, shown) = (cancel.clone(), of.clone());
        let is_wanted = move || !cancel.is_cancelled() && documents.shows(&shown);
        while_wanted(is_wanted, || compare_with(&of, &asked))
    })
    .await?;
    // What it says is about lines of that text.
    if !shared.documents.shows(&revision) {
        return Err(Error::content_modified());
    }
    json(&compared.ok_or_else(|| failed(format!("{} is too large to be compared", revision.name())))?)
}
