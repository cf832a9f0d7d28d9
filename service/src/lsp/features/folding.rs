//! `textDocument/foldingRange` and `textDocument/selectionRange`.

use std::sync::Arc;

use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{
    FoldingRange, FoldingRangeKind, FoldingRangeParams, SelectionRange, SelectionRangeParams,
};

use super::asked::about;
use crate::lsp::{convert, session::shared::Shared};
use ladder_ide::{folds, selections};

pub(crate) async fn folding_ranges(
    shared: &Arc<Shared>,
    params: FoldingRangeParams,
) -> Result<Option<Vec<FoldingRange>>> {
    let limit = shared
        .agreed()
        .fold_limit
        .map_or(usize::MAX, |limit| limit as usize);
    about(shared, &params.text_document.uri, move |asked| {
        let found = folds(&asked.context).into_iter().take(limit);
        let fold = found.map(|fold| {
            let range = convert::range_in(&asked.revision, fold.range);
            FoldingRange {
                start_line: range.start.line,
                end_line: range.end.line,
                kind: fold.comment.then_some(FoldingRangeKind::Comment),
                ..FoldingRange::default()
            }
        });
        Some(fold.collect())
    })
    .await
}

pub(crate) async fn selection_ranges(
    shared: &Arc<Shared>,
    params: SelectionRangeParams,
) -> Result<Option<Vec<SelectionRange>>> {
    about(shared, &params.text_document.uri, move |asked| {
        let of_position = |position| {
            let ranges = selections(&asked.context, asked.offset(position));
            let outermost_first = ranges.into_iter().rev();
            let chain = outermost_first.fold(None, |parent: Option<Box<SelectionRange>>, range| {
                let range = convert::range_in(&asked.revision, range);
                Some(Box::new(SelectionRange { range, parent }))
            });
            chain.map_or_else(SelectionRange::default, |innermost| *innermost)
        };
        Some(params.positions.into_iter().map(of_position).collect())
    })
    .await
}
