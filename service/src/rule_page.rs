//! `ladder.rulePage`: the page of a rule, for a client that opens the link of a finding.

use ladder_analysis::{Rule, rules};
use serde::{Deserialize, Serialize};

/// The scheme of the addresses that findings link: they are no files, and the server has their text.
pub(crate) const SCHEME: &str = "ladder-rule";

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

/// The address of a rule's page. Links between pages, which are relative, lead from one such address to another.
pub(crate) fn address(rule: Rule) -> String {
    format!("{SCHEME}:/{}.md", rule.name())
}

/// The page of a rule; none if no rule has the name.
pub(crate) fn page(asked: &AskedPage) -> Option<RulePage> {
    let rule = rules::rule_named(asked.rule.trim())?;
    let markdown = ladder_ide::rule_page(rule).to_owned();
    Some(RulePage { markdown })
}
