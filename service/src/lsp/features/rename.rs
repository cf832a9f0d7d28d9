//! `textDocument/prepareRename` and `textDocument/rename`.

use std::sync::Arc;

use ladder_documents::Revision;
use ladder_ide::{Renamable, RenameRefused, Renamed};
use tower_lsp::jsonrpc::{Error, ErrorCode, Result};
use tower_lsp::ls_types::{
    PrepareRenameResponse, RenameParams, TextDocumentPositionParams, TextEdit, Uri, WorkspaceEdit,
};

use super::asked::{Asked, Places, about_place};
use super::of_scenarios::{about_scenarios, naming_at};
use crate::lsp::answers::REQUEST_FAILED;
use crate::lsp::transport::answered::as_text;
use crate::lsp::{convert, session::agreed::Agreed, session::shared::Shared};

/// The files to change: the address, the document if it is open, and the edits.
type Changes = Vec<(Uri, Option<Arc<Revision>>, Vec<TextEdit>)>;

pub(crate) async fn prepare(
    shared: &Arc<Shared>,
    place: TextDocumentPositionParams,
) -> Result<Option<PrepareRenameResponse>> {
    let prepared = match naming_at(shared, &place.text_document.uri) {
        Some(revision) => {
            about_scenarios(shared, revision, move |scenarios| {
                let found =
                    ladder_ide::prepare_scenario_rename(&scenarios.read(), scenarios.offset(place.position));
                Some(found.map(|found| found.map(|it| placeholder(&scenarios.revision, it))))
            })
            .await?
        }
        None => {
            about_place(shared, place, |asked, offset| {
                let found = ladder_ide::prepare_rename(&asked.context, offset);
                Some(found.map(|found| found.map(|it| placeholder(&asked.revision, it))))
            })
            .await?
        }
    };
    match prepared {
        Some(Err(why)) => Err(refused(why)),
        Some(Ok(found)) => Ok(found),
        None => Ok(None),
    }
}

fn placeholder(revision: &Revision, found: Renamable) -> PrepareRenameResponse {
    PrepareRenameResponse::RangeWithPlaceholder {
        range: convert::range_in(revision, found.range),
        placeholder: found.name,
    }
}

pub(crate) async fn rename(shared: &Arc<Shared>, params: RenameParams) -> Result<Option<WorkspaceEdit>> {
    let agreed = shared.agreed();
    let (place, new) = (params.text_document_position, params.new_name);
    let renamed = match naming_at(shared, &place.text_document.uri) {
        Some(revision) => {
            about_scenarios(shared, revision, move |scenarios| {
                let asked = scenarios.program.as_ref()?;
                let options = asked.revision.format_options();
                let offset = scenarios.offset(place.position);
                let files = ladder_ide::rename_in_scenario(&scenarios.read(), offset, &new, &options);
                Some(files.and_then(|files| edit(asked, files, agreed)))
            })
            .await?
        }
        None => {
            about_place(shared, place, move |asked, offset| {
                let options = asked.revision.format_options();
                let files = ladder_ide::rename(&asked.context, offset, &new, &asked.elsewhere, &options);
                Some(files.and_then(|files| edit(asked, files, agreed)))
            })
            .await?
        }
    };
    let (edit, open) = match renamed {
        Some(Err(why)) => return Err(refused(why)),
        Some(Ok(renamed)) => renamed,
        None => return Ok(None),
    };
    // Edits of a text that has moved on would tear it.
    let mut open = open.iter();
    if open.any(|it| !shared.documents.shows(it) && !shared.companions.shows(it)) {
        return Err(Error::content_modified());
    }
    Ok(as_text(Some(edit)))
}

/// The files that change where the tag at a place gets another name.
pub(super) async fn everywhere(
    shared: &Arc<Shared>,
    place: TextDocumentPositionParams,
    new: String,
) -> Result<Option<Changes>> {
    let renamed = about_place(shared, place, move |asked, offset| {
        let options = asked.revision.format_options();
        let files = ladder_ide::rename(&asked.context, offset, &new, &asked.elsewhere, &options);
        Some(files.and_then(|files| changes(asked, files)))
    });
    let changes = renamed.await?.transpose().map_err(refused)?;
    let mut open = changes.iter().flatten().filter_map(|(_, open, _)| open.as_ref());
    if open.any(|it| !shared.documents.shows(it) && !shared.companions.shows(it)) {
        return Err(Error::content_modified());
    }
    Ok(changes)
}

/// The edit, and the open documents that it changes.
pub(super) fn edit(
    asked: &Asked,
    files: Vec<Renamed>,
    agreed: Agreed,
) -> std::result::Result<(WorkspaceEdit, Vec<Arc<Revision>>), RenameRefused> {
    let changes = changes(asked, files)?;
    let open = changes.iter().filter_map(|(_, open, _)| open.clone()).collect();
    let files = changes
        .into_iter()
        .map(|(uri, open, edits)| (uri, open.map(|it| it.version), edits));
    Ok((agreed.edit_of_files(files), open))
}

fn refused(why: RenameRefused) -> Error {
    Error {
        code: ErrorCode::ServerError(REQUEST_FAILED),
        message: why.0.into(),
        data: None,
    }
}

/// What changes in which file. Edits are made in ladder text only.
fn changes(asked: &Asked, files: Vec<Renamed>) -> std::result::Result<Changes, RenameRefused> {
    let mut places = Places::of(asked);
    let mut all = Changes::new();
    for renamed in files {
        let Some((uri, file)) = places.file(&renamed.file) else {
            continue;
        };
        if !file.is_ladder() {
            return Err(RenameRefused(format!(
                "{} would change too, which is not ladder text: change it there first",
                renamed.file
            )));
        }
        let edits = renamed.edits.into_iter().map(|edit| TextEdit {
            range: convert::range(file.range(edit.range)),
            new_text: edit.text,
        });
        all.push((uri.clone(), file.revision.clone(), edits.collect()));
    }
    Ok(all)
}
