//! `textDocument/formatting`, `rangeFormatting`, `rangesFormatting` and `onTypeFormatting`: many small edits, so that
//! cursors and breakpoints stay where they are.

use std::sync::Arc;

use ladder_documents::{Kind, Revision};
use ladder_format::{Edit, format_ranges};
use ladder_ide::{on_type, scenario_layout, scenario_on_type};
use ladder_syntax::TextRange;
use serde::Deserialize;
use tower_lsp::jsonrpc::{Error, Result};
use tower_lsp::ls_types::{
    DocumentFormattingParams, DocumentOnTypeFormattingParams, DocumentRangeFormattingParams, Range,
    TextDocumentIdentifier, TextEdit, Uri,
};

use super::of_scenarios::scenarios_at;
use crate::lsp::transport::blocking::blocking;
use crate::lsp::{convert, session::shared::Shared};

/// The parameters of `textDocument/rangesFormatting`, which the protocol has since 3.18. Layout has no use for the
/// editor's options.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct DocumentRangesFormattingParams {
    text_document: TextDocumentIdentifier,
    ranges: Vec<Range>,
}

pub(crate) async fn formatting(
    shared: &Arc<Shared>,
    params: DocumentFormattingParams,
) -> Result<Option<Vec<TextEdit>>> {
    current(shared, &params.text_document.uri, |revision| {
        match revision.kind() {
            Kind::Scenarios => Some(scenario_layout(&revision.text())),
            _ => revision.format(),
        }
    })
    .await
}

pub(crate) async fn range_formatting(
    shared: &Arc<Shared>,
    params: DocumentRangeFormattingParams,
) -> Result<Option<Vec<TextEdit>>> {
    let ranges = vec![params.range];
    current(shared, &params.text_document.uri, |it| in_ranges(it, ranges)).await
}

pub(crate) async fn ranges_formatting(
    shared: &Arc<Shared>,
    params: DocumentRangesFormattingParams,
) -> Result<Option<Vec<TextEdit>>> {
    let ranges = params.ranges;
    current(shared, &params.text_document.uri, |it| in_ranges(it, ranges)).await
}

pub(crate) async fn on_type_formatting(
    shared: &Arc<Shared>,
    params: DocumentOnTypeFormattingParams,
) -> Result<Option<Vec<TextEdit>>> {
    let place = params.text_document_position;
    let Some(typed) = params.ch.chars().next_back() else {
        return Ok(None);
    };
    current(shared, &place.text_document.uri, move |revision| {
        let offset = revision.offset(convert::our_position(place.position));
        if revision.kind() == Kind::Scenarios {
            return Some(scenario_on_type(&revision.text(), offset, typed));
        }
        let (context, _) = revision.first_context()?;
        Some(on_type(context, offset, typed, &revision.format_options()))
    })
    .await
}

fn in_ranges(revision: &Revision, ranges: Vec<Range>) -> Option<Vec<Edit>> {
    if revision.kind() == Kind::Scenarios {
        // Columns reach beyond what is selected: the lines that are touched go where all of them would.
        let mut edits = scenario_layout(&revision.text());
        let lines: Vec<_> = ranges.iter().map(|it| it.start.line..=it.end.line).collect();
        edits.retain(|edit| {
            let line = revision.line_of(edit.range.start());
            let is_one = line == revision.line_of(edit.range.end());
            is_one && lines.iter().any(|lines| lines.contains(&line))
        });
        return Some(edits);
    }
    let (context, _) = revision.first_context()?;
    let range = |range: Range| {
        let range = convert::our_range(range);
        let (a, b) = (revision.offset(range.start), revision.offset(range.end));
        TextRange::new(a.min(b), a.max(b))
    };
    let ranges: Vec<TextRange> = ranges.into_iter().map(range).collect();
    let options = revision.format_options();
    Some(format_ranges(&context.parse, &options, &ranges))
}

/// The edits of a document. An answer names no version: edits for a text that has moved on would tear the drawing.
async fn current(
    shared: &Arc<Shared>,
    uri: &Uri,
    job: impl FnOnce(&Revision) -> Option<Vec<Edit>> + Send + 'static,
) -> Result<Option<Vec<TextEdit>>> {
    let open = shared.documents.get(uri.as_str());
    let Some(revision) = open.or_else(|| scenarios_at(shared, uri)) else {
        return Ok(None);
    };
    let of = revision.clone();
    let edits = blocking(&*shared.host, move |_| {
        if !of.fits() {
            return None;
        }
        Some(convert::edits(&of, &job(&of)?))
    })
    .await?;
    if !shared.documents.shows(&revision) && !shared.companions.shows(&revision) {
        return Err(Error::content_modified());
    }
    Ok(edits)
}
