//! `textDocument/references` and `textDocument/documentHighlight`.

use std::sync::Arc;

use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{
    DocumentHighlight, DocumentHighlightKind, DocumentHighlightParams, Location, ReferenceParams,
};

use super::asked::{Places, about_place};
use crate::lsp::{convert, shared::Shared};
use ladder_ide::{Usage, highlights};

pub(crate) async fn references(
    shared: &Arc<Shared>,
    params: ReferenceParams,
) -> Result<Option<Vec<Location>>> {
    let declarations = params.context.include_declaration;
    about_place(shared, params.text_document_position, move |asked, offset| {
        let found = ladder_ide::references(&asked.context, offset, &asked.elsewhere);
        let mut places = Places::of(asked);
        let wanted = found.iter().filter(|it| declarations || !it.usage.declares());
        Some(
            wanted
                .filter_map(|it| places.location(&it.file, it.range))
                .collect(),
        )
    })
    .await
}

pub(crate) async fn highlight(
    shared: &Arc<Shared>,
    params: DocumentHighlightParams,
) -> Result<Option<Vec<DocumentHighlight>>> {
    about_place(shared, params.text_document_position_params, |asked, offset| {
        let found = highlights(&asked.context, offset).into_iter();
        let shown = found.map(|it| DocumentHighlight {
            range: convert::range_in(&asked.revision, it.range),
            kind: Some(match it.usage {
                Usage::Read => DocumentHighlightKind::READ,
                Usage::Write | Usage::ReadWrite => DocumentHighlightKind::WRITE,
                Usage::Definition | Usage::Declaration | Usage::Mention => DocumentHighlightKind::TEXT,
            }),
        });
        Some(shown.collect())
    })
    .await
}
