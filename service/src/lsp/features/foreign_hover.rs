//! `textDocument/hover` in a program of another system: what a line becomes.

use std::sync::Arc;

use ladder_documents::Revision;
use ladder_documents::other_files::OtherFiles;
use ladder_syntax::TextSize;
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{Hover, HoverContents, Position, Uri};

use super::asked::Asked;

use crate::lsp::session::shared::Shared;
use crate::lsp::transport::blocking::blocking;
use crate::lsp::{convert, markup};

/// The program of another system that is open at an address.
pub(super) fn program_at(shared: &Shared, uri: &Uri) -> Option<Arc<Revision>> {
    let companion = shared.companions.get(uri.as_str());
    companion.filter(|revision| revision.kind().notation().is_some())
}

/// Does a job about the ladder text that a place becomes, at each place there until one has an answer.
pub(super) async fn about_ladder<T: Send + 'static>(
    shared: &Arc<Shared>,
    revision: Arc<Revision>,
    position: Position,
    job: impl Fn(&Asked, TextSize) -> Option<T> + Send + 'static,
) -> Result<Option<T>> {
    let next_to = shared.clone();
    blocking(&*shared.host, move |cancel| {
        let offset = revision.offset(convert::our_position(position));
        let places = revision.opened()?.as_ref().ok()?.in_ladder(offset);
        let elsewhere = OtherFiles::of(&revision, &next_to.documents, &next_to.companions, cancel);
        let asked = Asked {
            context: Arc::clone(revision.context()?),
            revision,
            elsewhere,
            knows_others: true,
            opens_library: next_to.agreed().library_blocks,
        };
        places.into_iter().find_map(|at| job(&asked, at))
    })
    .await
}

pub(crate) async fn hover(
    shared: &Shared,
    markdown: bool,
    revision: Arc<Revision>,
    position: Position,
    values: Vec<String>,
) -> Result<Option<Hover>> {
    blocking(&*shared.host, move |_| {
        let opened = revision.opened()?.as_ref().ok();
        let offset = revision.offset(convert::our_position(position));
        let of_line = opened.and_then(|opened| opened.hover(offset));
        let range = of_line
            .as_ref()
            .map(|(range, _)| convert::range_in(&revision, *range));
        let values = Some(values.join("; ")).filter(|values| !values.is_empty());
        let told: Vec<String> = values.into_iter().chain(of_line.map(|(_, text)| text)).collect();
        if told.is_empty() {
            return None;
        }
        let text = told.join("\n\n---\n\n");
        Some(Hover {
            contents: HoverContents::Markup(markup::content(markdown, text)),
            range,
        })
    })
    .await
}
