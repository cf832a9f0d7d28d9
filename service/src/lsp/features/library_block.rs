//! `ladder.libraryBlock`: the source of a block that the library has.

use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{ExecuteCommandParams, LSPAny};

use crate::library_block::{AskedBlock, block};
use crate::lsp::answers::{error, json};
use crate::simulation::{Failure, argument_of};

/// The command.
pub(crate) const LIBRARY_BLOCK: &str = "ladder.libraryBlock";

pub(crate) fn execute(params: ExecuteCommandParams) -> Result<LSPAny> {
    let asked: AskedBlock = argument_of(LIBRARY_BLOCK, params.arguments).map_err(error)?;
    let missing = || {
        error(Failure::Failed(format!(
            "the library has no block `{}`",
            asked.block
        )))
    };
    json(&block(&asked).ok_or_else(missing)?)
}
