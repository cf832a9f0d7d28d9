//! `textDocument/hover`.

use std::sync::Arc;

use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{Hover, HoverContents, HoverParams, MarkupContent, MarkupKind};

use super::blocking::blocking;
use super::convert;
use super::shared::Shared;

pub(super) async fn hover(shared: &Arc<Shared>, params: HoverParams) -> Result<Option<Hover>> {
    let place = params.text_document_position_params;
    let Some(revision) = shared.documents.get(place.text_document.uri.as_str()) else {
        return Ok(None);
    };
    let markdown = shared.agreed().markdown;
    blocking(move |_| {
        let analysis = revision.analysis()?;
        let hover = analysis.hover(revision.offset(convert::our_position(place.position)))?;
        let range = Some(convert::range_in(&revision, hover.range));
        let contents = if markdown {
            MarkupContent {
                kind: MarkupKind::Markdown,
                value: hover.markdown,
            }
        } else {
            MarkupContent {
                kind: MarkupKind::PlainText,
                value: plain(&hover.markdown),
            }
        };
        Some(Hover {
            contents: HoverContents::Markup(contents),
            range,
        })
    })
    .await
}

/// The text without its Markdown: fences, backquotes and the stars of bold text go.
fn plain(markdown: &str) -> String {
    let lines = markdown.lines().filter(|line| !line.starts_with("```"));
    lines
        .map(|line| line.replace("**", "").replace('`', ""))
        .collect::<Vec<_>>()
        .join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plain_text_keeps_the_words() {
        assert_eq!(
            plain("**on-delay** timer\n```clad\n[TON]( t, PT )\n```\nsee `ET`"),
            "on-delay timer\n[TON]( t, PT )\nsee ET"
        );
    }
}
