//! What an editor asks: a file for each request, or for each that belong together.

pub(crate) mod asked;
pub(crate) mod call_hierarchy;
pub(crate) mod code_action;
pub(crate) mod code_lens;
pub(crate) mod comment;
#[cfg(feature = "review")]
pub(crate) mod compare;
pub(crate) mod completion;
mod conversion;
pub(crate) mod cross_reference;
pub(crate) mod debug;
pub(crate) mod diagram;
pub(crate) mod diagram_text;
pub(crate) mod edit;
pub(crate) mod fence;
pub(crate) mod folding;
pub(crate) mod foreign_hover;
pub(crate) mod formatting;
pub(crate) mod goto;
pub(crate) mod hover;
pub(crate) mod inlay_hint;
pub(crate) mod library_block;
pub(crate) mod links;
pub(crate) mod notations;
mod of_scenarios;
pub(crate) mod preview;
pub(crate) mod prove;
pub(crate) mod references;
pub(crate) mod rename;
pub(crate) mod rule_page;
pub(crate) mod run_scenarios;
pub(crate) mod scenario_actions;
pub(crate) mod semantic_tokens;
pub(crate) mod signature;
pub(crate) mod simulate;
mod switch_off;
pub(crate) mod symbols;
