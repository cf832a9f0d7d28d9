//! `ladder.libraryBlock`: the source of a block that the library has.

use ladder_analysis::library::{self, Source};
use ladder_live::{Failure, argument_of};
use serde::{Deserialize, Serialize};
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{ExecuteCommandParams, LSPAny};

use crate::lsp::answers::{error, json};

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

/// The argument of `ladder.libraryBlock`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct AskedBlock {
    /// The block's name, with the `$`.
    pub block: String,
}

/// The answer to `ladder.libraryBlock`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct LibraryBlock {
    /// The source, in ladder text.
    pub text: String,
}

/// The source of a block; none if the library has none of the name.
pub(crate) fn block(asked: &AskedBlock) -> Option<LibraryBlock> {
    let is_it = |source: &&Source| source.name.eq_ignore_ascii_case(asked.block.trim());
    let source = library::SOURCES.iter().find(is_it)?;
    Some(LibraryBlock {
        text: source.text.to_owned(),
    })
}
