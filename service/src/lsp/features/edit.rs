//! `ladder.edit`: a change of the drawing by a key, as edits that the client makes in one step.

use std::sync::Arc;

use ladder_documents::position;
use ladder_ide::{Redraw, redraw};
use ladder_live::{Failure, argument_of};
use ladder_syntax::TextRange;
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{ExecuteCommandParams, LSPAny};

use super::diagram_edit::replacement;
use crate::lsp::answers::{error, json};
use crate::lsp::session::shared::Shared;
use crate::lsp::transport::blocking::blocking;
use crate::typing_messages::{EditDrawing, EditKind, EditedDrawing};

/// The command.
pub(crate) const EDIT: &str = "ladder.edit";

const fn redraw_of(edit: EditKind) -> Redraw {
    match edit {
        EditKind::Contact => Redraw::Contact,
        EditKind::ClosedContact => Redraw::ClosedContact,
        EditKind::Coil => Redraw::Coil,
        EditKind::Block => Redraw::Block,
        EditKind::Branch => Redraw::Branch,
        EditKind::Invert => Redraw::Invert,
        EditKind::Left => Redraw::Left,
        EditKind::Right => Redraw::Right,
        EditKind::Up => Redraw::Up,
        EditKind::Down => Redraw::Down,
        EditKind::Delete => Redraw::Delete,
    }
}

pub(crate) async fn execute(shared: &Arc<Shared>, params: ExecuteCommandParams) -> Result<LSPAny> {
    let EditDrawing { uri, range, edit } = argument_of(EDIT, params.arguments).map_err(error)?;
    let failed = |why: &str| Failure::Failed(why.to_owned());
    let Some(revision) = shared.documents.get(&uri) else {
        return Err(error(failed("this document is not open as a ladder program")));
    };
    let edited = blocking(&*shared.host, move |_| {
        let context = revision.context().ok_or("the file is too large")?;
        let (start, end) = (revision.offset(range.start), revision.offset(range.end));
        let range = TextRange::new(start.min(end), end.max(start));
        let done = redraw(context, range, redraw_of(edit), &revision.format_options())?;
        let cursor = done.focus.map(|at| {
            let new = revision.after(&done.edits);
            position::position(&new, revision.encoding(), at.into())
        });
        Ok::<_, String>(EditedDrawing {
            version: revision.version,
            edits: done
                .edits
                .iter()
                .map(|edit| replacement(&revision, edit))
                .collect(),
            cursor,
        })
    });
    json(&edited.await?.map_err(|why| error(failed(&why)))?)
}
