//! `ladder.declarations`: the declarations of an open program as a table. `docs/protocol.md` shows the messages.

use std::sync::Arc;

use ladder_live::{Failure, argument_of};
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{ExecuteCommandParams, LSPAny};

use crate::drawing_messages::{DeclarationCells, DeclarationTable, Declarations, DeclaredRow};
use crate::lsp::answers::{error, json};
use crate::lsp::session::shared::Shared;
use crate::lsp::transport::blocking::blocking;

/// The command.
pub(crate) const DECLARATIONS: &str = "ladder.declarations";

pub(crate) async fn execute(shared: &Arc<Shared>, params: ExecuteCommandParams) -> Result<LSPAny> {
    let Declarations { uri } = argument_of(DECLARATIONS, params.arguments).map_err(error)?;
    let failed = |message: String| error(Failure::Failed(message));
    let revision = shared.documents.get(&uri);
    let revision = revision.ok_or_else(|| failed(format!("{uri} is not open in the editor")))?;
    let name = revision.name().to_owned();
    let listed = blocking(&*shared.host, move |_| {
        let context = revision.context()?;
        let rows = ladder_ide::declarations(context).into_iter();
        let rows = rows.map(|row| DeclaredRow {
            block: row.block,
            at: revision.range(row.at),
            cells: DeclarationCells {
                section: row.cells.section,
                name: row.cells.name,
                address: row.cells.address,
                ty: row.cells.ty,
                initial: row.cells.initial,
                comment: row.cells.comment,
            },
        });
        let blocks = context.user_blocks.iter().map(|block| block.name.clone());
        Some(DeclarationTable {
            version: revision.version,
            rows: rows.collect(),
            blocks: blocks.collect(),
        })
    });
    json(
        &listed
            .await?
            .ok_or_else(|| failed(format!("{name} is too large to be drawn")))?,
    )
}
