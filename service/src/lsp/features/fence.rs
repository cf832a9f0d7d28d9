//! `ladder.fence`: ladder text of another document, coloured and drawn.

use std::sync::Arc;

use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{ExecuteCommandParams, LSPAny};

use crate::fence::{Fence, draw};
use crate::lsp::answers::{error, json};
use crate::lsp::session::shared::Shared;
use crate::lsp::transport::blocking::blocking;
use crate::simulation::{Failure, argument_of};

/// The command.
pub(crate) const FENCE: &str = "ladder.fence";

pub(crate) async fn execute(shared: &Arc<Shared>, params: ExecuteCommandParams) -> Result<LSPAny> {
    let asked: Fence = argument_of(FENCE, params.arguments).map_err(error)?;
    let drawn = blocking(&*shared.host, move |_| draw(&asked)).await?;
    json(&drawn.ok_or_else(|| error(Failure::Failed("the text is too large to be drawn".to_owned())))?)
}
