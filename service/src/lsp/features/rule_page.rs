//! `ladder.rulePage`: what a finding's rule is about, as the book says it.

use ladder_analysis::rules;
use ladder_live::{Failure, argument_of};
use serde::{Deserialize, Serialize};
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{ExecuteCommandParams, LSPAny};

use crate::lsp::answers::{error, json};

/// The command.
pub(crate) const RULE_PAGE: &str = "ladder.rulePage";

pub(crate) fn execute(params: ExecuteCommandParams) -> Result<LSPAny> {
    let asked: AskedPage = argument_of(RULE_PAGE, params.arguments).map_err(error)?;
    let found = page(&asked);
    json(&found.ok_or_else(|| error(Failure::Failed(format!("no rule is called `{}`", asked.rule))))?)
}

/// The argument of `ladder.rulePage`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct AskedPage {
    /// The rule's name, as findings have it for their code.
    pub rule: String,
}

/// The answer to `ladder.rulePage`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct RulePage {
    /// The page, in Markdown.
    pub markdown: String,
}

/// The page of a rule; none if no rule has the name.
pub(crate) fn page(asked: &AskedPage) -> Option<RulePage> {
    let rule = rules::rule_named(asked.rule.trim())?;
    let markdown = ladder_ide::rule_page(rule).to_owned();
    Some(RulePage { markdown })
}
