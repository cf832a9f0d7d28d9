//! `ladder.comment`: lines that become comments, or comments that become lines again.

use std::sync::Arc;

use ladder_documents::{Lines, Revision};
use ladder_ide::toggle_comment;
use ladder_live::{Failure, argument_of};
use ladder_syntax::TextSize;
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{ExecuteCommandParams, LSPAny};

use crate::lsp::answers::{error, json};
use crate::lsp::session::shared::Shared;
use crate::lsp::transport::blocking::blocking;
use crate::typing_messages::{EditedDrawing, Replacement, ToggleComment};

/// The command.
pub(crate) const COMMENT: &str = "ladder.comment";

pub(crate) async fn execute(shared: &Arc<Shared>, params: ExecuteCommandParams) -> Result<LSPAny> {
    let ToggleComment { uri, lines } = argument_of(COMMENT, params.arguments).map_err(error)?;
    let Some(revision) = shared.documents.get(&uri) else {
        let why = "this document is not open as a ladder program";
        return Err(error(Failure::Failed(why.to_owned())));
    };
    let edited = blocking(&*shared.host, move |_| toggle(&revision, &lines));
    json(&edited.await?.map_err(error)?)
}

/// Toggles each of some stretches of lines by itself. One that begins in the lines of another is left out.
fn toggle(revision: &Revision, stretches: &[Lines]) -> std::result::Result<EditedDrawing, Failure> {
    let text = revision.text();
    let mut stretches = stretches.to_vec();
    stretches.sort_by_key(|lines| lines.first);
    let mut edits = Vec::new();
    let mut next_line = 0;
    for Lines { first, last } in stretches {
        if first < next_line || first > revision.last_line() {
            continue;
        }
        next_line = last.saturating_add(1);
        let start = usize::from(revision.line_start(first));
        let end = usize::from(revision.line_start(next_line));
        let lines = text[start..end].trim_end_matches(['\n', '\r']);
        let toggled = toggle_comment(&text, start..start + lines.len()).map_err(|refused| {
            let line = revision.line_of(TextSize::try_from(refused).unwrap_or_default()) + 1;
            Failure::Failed(format!(
                "line {line} holds a \"#\", which would end the comment; write it without"
            ))
        })?;
        edits.extend(toggled);
    }
    let replacement = |edit: ladder_format::Edit| Replacement {
        range: revision.range(edit.range),
        new_text: edit.text,
    };
    Ok(EditedDrawing {
        version: revision.version,
        edits: edits.into_iter().map(replacement).collect(),
        cursor: None,
    })
}
