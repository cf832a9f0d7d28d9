//! `ladder.diagramPalette`: what can be drawn in an open program. `docs/protocol.md` shows the messages.

use std::sync::Arc;

use ladder_live::{Failure, argument_of};
use serde::{Deserialize, Serialize};
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{ExecuteCommandParams, LSPAny};

use crate::lsp::answers::{error, json};
use crate::lsp::session::shared::Shared;
use crate::lsp::transport::blocking::blocking;

/// The command.
pub(crate) const PALETTE: &str = "ladder.diagramPalette";

pub(crate) async fn execute(shared: &Arc<Shared>, params: ExecuteCommandParams) -> Result<LSPAny> {
    let asked: Palette = argument_of(PALETTE, params.arguments).map_err(error)?;
    let failed = |message: String| error(Failure::Failed(message));
    let revision = shared.documents.get(&asked.uri);
    let revision = revision.ok_or_else(|| failed(format!("{} is not open in the editor", asked.uri)))?;
    let name = revision.name().to_owned();
    let listed = blocking(&*shared.host, move |_| {
        let rows = ladder_ide::palette(revision.context()?, &asked.search);
        let rows = rows.into_iter().map(|row| DrawableRow {
            section: row.section.to_owned(),
            block: row.block,
            title: row.title,
            elsewhere: row.elsewhere.into_iter().map(str::to_owned).collect(),
            us: row.us.map(str::to_owned),
            operands: row.operands,
        });
        Some(Drawable { rows: rows.collect() })
    });
    json(
        &listed
            .await?
            .ok_or_else(|| failed(format!("{name} is too large to be drawn")))?,
    )
}

/// The argument of `ladder.diagramPalette`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Palette {
    /// The program, which must be open.
    pub uri: String,
    /// What a person looks for: a name here or elsewhere, or what it does. Empty: all.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub search: String,
}

/// The answer to `ladder.diagramPalette`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Drawable {
    /// In the order of their sections, or the likest first.
    pub rows: Vec<DrawableRow>,
}

/// One thing that can be drawn.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct DrawableRow {
    /// The heading that it is under.
    pub section: String,
    /// As it is drawn without operands: `[TON]`.
    pub block: String,
    /// In a few words: "On-delay timer".
    pub title: String,
    /// What it is called elsewhere: `XIC`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub elsewhere: Vec<String>,
    /// What it is called in the United States, where that is another name.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub us: Option<String>,
    /// What its parentheses hold until a person writes something else. Missing: it has none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub operands: Option<String>,
}
