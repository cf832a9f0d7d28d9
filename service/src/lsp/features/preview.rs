//! `ladder.preview`: the ladder text of an open program of another system, which is followed from then on.

use std::sync::Arc;

use ladder_live::{Failure, argument_of};
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{ExecuteCommandParams, LSPAny};

use crate::lsp::answers::{error, json};
use crate::lsp::documents::foreign;
use crate::lsp::session::shared::Shared;
use crate::lsp::transport::blocking::blocking;
use crate::notation::messages::Preview;

/// The command.
pub(crate) const PREVIEW: &str = "ladder.preview";

pub(crate) async fn execute(shared: &Arc<Shared>, params: ExecuteCommandParams) -> Result<LSPAny> {
    let Preview { uri } = argument_of(PREVIEW, params.arguments).map_err(error)?;
    let revision = shared.companions.get(&uri);
    let revision = revision
        .filter(|revision| revision.kind().notation().is_some())
        .ok_or_else(|| {
            error(Failure::Failed(format!(
                "{uri} is not open as a program of another system; open it as one first"
            )))
        })?;
    let next_to = shared.clone();
    let previewed = blocking(&*shared.host, move |_| {
        let failed = |message: String| Err(Failure::Failed(format!("{}:{message}", revision.name())));
        match revision.opened() {
            Some(Ok(opened)) => {
                next_to.previews.begin(&revision.uri, opened.foreign().ladder());
                let previewed = foreign::previewed(&revision, opened);
                // A change that came meanwhile was sent to nobody.
                if let Some(newest) = next_to.companions.get(&revision.uri) {
                    foreign::tell_preview(&next_to, &newest);
                }
                Ok(previewed)
            }
            Some(Err(broken)) if broken.place.is_some() => failed(broken.to_string()),
            Some(Err(broken)) => failed(format!(" {broken}")),
            None => failed(" the file is too large to be read".to_owned()),
        }
    });
    json(&previewed.await?.map_err(error)?)
}
