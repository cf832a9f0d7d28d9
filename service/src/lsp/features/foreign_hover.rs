//! `textDocument/hover` in a program of another system: what a line becomes.

use std::sync::Arc;

use ladder_documents::Revision;
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{Hover, HoverContents, Position};

use crate::lsp::session::shared::Shared;
use crate::lsp::transport::blocking::blocking;
use crate::lsp::{convert, markup};

pub(crate) async fn hover(
    shared: &Shared,
    markdown: bool,
    revision: Arc<Revision>,
    position: Position,
) -> Result<Option<Hover>> {
    blocking(&*shared.host, move |_| {
        let opened = revision.opened()?.as_ref().ok()?;
        let offset = revision.offset(convert::our_position(position));
        let (range, text) = opened.hover(offset)?;
        Some(Hover {
            contents: HoverContents::Markup(markup::content(markdown, text)),
            range: Some(convert::range_in(&revision, range)),
        })
    })
    .await
}
