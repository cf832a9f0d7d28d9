//! `ladder.rulePage`: what a finding's rule is about, as the book says it.

use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{ExecuteCommandParams, LSPAny};

use crate::lsp::answers::{error, json};
use crate::rule_page::{AskedPage, page};
use crate::simulation::{Failure, argument_of};

/// The command.
pub(crate) const RULE_PAGE: &str = "ladder.rulePage";

pub(crate) fn execute(params: ExecuteCommandParams) -> Result<LSPAny> {
    let asked: AskedPage = argument_of(RULE_PAGE, params.arguments).map_err(error)?;
    let found = page(&asked);
    json(&found.ok_or_else(|| error(Failure::Failed(format!("no rule is called `{}`", asked.rule))))?)
}
