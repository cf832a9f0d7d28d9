//! Files that a person makes, renames and deletes in the editor.
//!
//! A client that reports such operations need not watch the disk. Before a file is renamed the scenarios are put right
//! that name it: `program motor.clad` is the one place where a file names another.

use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

use ladder_documents::Revision;
use ladder_documents::address::{path_of, uri_of};
use ladder_documents::membership::Membership;
use ladder_format::Edit;
use ladder_picture::scene;
use ladder_simulator::scenario;
use ladder_workspace::{is_scenario, is_scene};
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{
    CreateFilesParams, DeleteFilesParams, DocumentChangeOperation, DocumentChanges, FileOperationFilter,
    FileOperationPattern, FileOperationPatternKind, FileOperationRegistrationOptions, RenameFilesParams,
    WorkspaceEdit, WorkspaceFileOperationsServerCapabilities,
};

use super::{diagnostics, folders};
use crate::lsp::session::agreed::Reported;
use crate::lsp::session::shared::Shared;
use crate::lsp::transport::blocking::blocking;

pub(crate) fn created(shared: &Arc<Shared>, params: &CreateFilesParams) {
    let paths = params.files.iter().filter_map(|file| path_of(&file.uri));
    follow(shared, paths.collect());
}

pub(crate) fn deleted(shared: &Arc<Shared>, params: &DeleteFilesParams) {
    let paths = params.files.iter().filter_map(|file| path_of(&file.uri));
    follow(shared, paths.collect());
}

pub(crate) fn renamed(shared: &Arc<Shared>, params: &RenameFilesParams) {
    let files = params.files.iter();
    let paths = files.flat_map(|file| [path_of(&file.old_uri), path_of(&file.new_uri)]);
    follow(shared, paths.flatten().collect());
}

/// Files, or folders with all that is in them, are other ones than before.
fn follow(shared: &Arc<Shared>, mut paths: Vec<PathBuf>) {
    shared.in_background(move |shared| {
        paths.extend(shared.neighbours.changed_on_disk());
        diagnostics::files_changed(shared, &paths);
        folders::index(shared);
    });
}

/// `workspace/willRenameFiles`: the edits of scenarios that name the files that are renamed.
pub(crate) async fn will_rename(
    shared: &Arc<Shared>,
    params: RenameFilesParams,
) -> Result<Option<WorkspaceEdit>> {
    let next_to = shared.clone();
    blocking(&*shared.host, move |cancel| {
        let shared = next_to;
        let files = params.files.iter();
        let renames: Vec<(PathBuf, PathBuf)> = files
            .filter_map(|file| Some((path_of(&file.old_uri)?, path_of(&file.new_uri)?)))
            .collect();
        let mut changes = Vec::new();
        for file in scenarios_near(&shared, &renames) {
            if cancel.is_cancelled() {
                return None;
            }
            if let Some(revision) = text_of(&shared, &file)
                && let Some(edit) = renamed_program(&file, &revision.text(), &renames)
            {
                changes.push((revision, edit));
            }
        }
        edit_of(&shared, &changes)
    })
    .await
}

/// The files of scenarios in the folders that the client has open, and in the workspaces of what is renamed.
fn scenarios_near(shared: &Shared, renames: &[(PathBuf, PathBuf)]) -> Vec<PathBuf> {
    let mut roots = folders::open(shared);
    for (old, _) in renames {
        if let Ok(root) = shared.world().disk.root_of(old) {
            roots.push(root.folder().to_owned());
        }
    }
    roots.sort();
    roots.dedup();
    // What lies in one that is there is found with it.
    let mut outer: Vec<PathBuf> = Vec::new();
    for root in roots {
        if !outer.iter().any(|above| root.starts_with(above)) {
            outer.push(root);
        }
    }
    let mut found = shared.world().disk.companions(&outer);
    let open = shared.companions.all();
    let open = open.iter().filter_map(|it| path_of(&it.uri));
    found.extend(open.filter(|path| is_scenario(path) || is_scene(path)));
    found.sort();
    found.dedup();
    found
}

/// A file as the editor shows it, else as it is on disk.
fn text_of(shared: &Shared, file: &Path) -> Option<Arc<Revision>> {
    let companions = shared.companions.all();
    let open = companions
        .into_iter()
        .find(|it| path_of(&it.uri).as_deref() == Some(file));
    open.or_else(|| {
        let text = shared.world().disk.read(file).ok()?;
        let place = Membership::new(file.to_owned(), &shared.neighbours);
        let revision = Revision::on_disk(&uri_of(file), shared.agreed().encoding, &text, place);
        Some(Arc::new(revision))
    })
}

/// The edit that lets a file of scenarios name its program as it is called afterwards, if that is another name.
fn renamed_program(file: &Path, text: &str, renames: &[(PathBuf, PathBuf)]) -> Option<Edit> {
    let (name, range) = if is_scene(file) {
        // Without a place it is named by the scene's own name.
        scene::read(text).program?
    } else {
        scenario::parse(text).program?
    };
    let program = plain(&file.parent()?.join(&name));
    let now = relative(after(file, renames).parent()?, &after(&program, renames));
    if now == name {
        return None;
    }
    let quoted = !is_scene(file) && (now.contains(char::is_whitespace) || text[range].starts_with('"'));
    let text = if quoted { format!("\"{now}\"") } else { now };
    Some(Edit { range, text })
}

/// Where a file lies when the renames are done.
fn after(path: &Path, renames: &[(PathBuf, PathBuf)]) -> PathBuf {
    let rename = renames.iter().find(|(old, _)| path.starts_with(old));
    match rename.and_then(|(old, new)| Some((path.strip_prefix(old).ok()?, new))) {
        // Joining nothing would leave a slash at the end.
        Some((rest, new)) if rest.as_os_str().is_empty() => new.clone(),
        Some((rest, new)) => new.join(rest),
        None => path.to_owned(),
    }
}

/// The path without `.` and `..`.
fn plain(path: &Path) -> PathBuf {
    let mut plain = PathBuf::new();
    for part in path.components() {
        match part {
            Component::CurDir => {}
            Component::ParentDir => {
                plain.pop();
            }
            part => plain.push(part),
        }
    }
    plain
}

/// A file as it is seen from a folder.
fn relative(folder: &Path, file: &Path) -> String {
    let (from, to): (Vec<_>, Vec<_>) = (folder.components().collect(), file.components().collect());
    let common = from.iter().zip(&to).take_while(|(a, b)| a == b).count();
    let up = from[common..].iter().map(|_| "..".to_owned());
    let down = to[common..].iter();
    let down = down.map(|part| part.as_os_str().to_string_lossy().into_owned());
    up.chain(down).collect::<Vec<_>>().join("/")
}

fn edit_of(shared: &Shared, changes: &[(Arc<Revision>, Edit)]) -> Option<WorkspaceEdit> {
    if changes.is_empty() {
        return None;
    }
    let agreed = shared.agreed();
    let mut whole = WorkspaceEdit::default();
    for (revision, edit) in changes {
        let one = agreed.workspace_edit(revision, std::slice::from_ref(edit))?;
        if let Some(changes) = one.changes {
            whole.changes.get_or_insert_default().extend(changes);
        }
        if let Some(DocumentChanges::Edits(mut edits)) = one.document_changes {
            // A file that is not open has no version.
            if !shared.companions.is_current(revision) {
                for edit in &mut edits {
                    edit.text_document.version = None;
                }
            }
            match whole
                .document_changes
                .get_or_insert_with(|| DocumentChanges::Edits(Vec::new()))
            {
                DocumentChanges::Edits(all) => all.extend(edits),
                DocumentChanges::Operations(all) => {
                    all.extend(edits.into_iter().map(DocumentChangeOperation::Edit));
                }
            }
        }
    }
    Some(whole)
}

/// What the client is asked to report files that come and go, if it does.
pub(crate) fn options(reported: Reported) -> Option<WorkspaceFileOperationsServerCapabilities> {
    let operations = WorkspaceFileOperationsServerCapabilities {
        did_create: reported.created.then(followed_files),
        will_rename: reported.will_rename.then(followed_files),
        did_rename: reported.renamed.then(followed_files),
        did_delete: reported.deleted.then(followed_files),
        ..WorkspaceFileOperationsServerCapabilities::default()
    };
    (reported != Reported::default()).then_some(operations)
}

/// The files whose coming and going the client reports.
fn followed_files() -> FileOperationRegistrationOptions {
    let filter = |glob: &str, kind| FileOperationFilter {
        scheme: Some("file".into()),
        pattern: FileOperationPattern {
            glob: glob.into(),
            matches: kind,
            options: None,
        },
    };
    FileOperationRegistrationOptions {
        filters: vec![
            filter("**/*.{clad,ladder-test}", Some(FileOperationPatternKind::File)),
            filter("**/ladder.toml", Some(FileOperationPatternKind::File)),
            // What was in a folder comes and goes with it.
            filter("**", Some(FileOperationPatternKind::Folder)),
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn renamed(text: &str, renames: &[(&str, &str)]) -> Option<String> {
        let renames: Vec<_> = renames
            .iter()
            .map(|(old, new)| (old.into(), new.into()))
            .collect();
        let edit = renamed_program(Path::new("/plant/tests/a.ladder-test"), text, &renames)?;
        let mut text = text.to_owned();
        text.replace_range(std::ops::Range::<usize>::from(edit.range), &edit.text);
        Some(text)
    }

    #[test]
    fn scenarios_name_the_program_as_it_is_called_afterwards() {
        let text = "program ../motor.clad\nstep 10ms\n";
        for (renames, expected) in [
            (
                &[("/plant/motor.clad", "/plant/pump.clad")][..],
                Some("program ../pump.clad\nstep 10ms\n"),
            ),
            (
                &[("/plant/motor.clad", "/plant/tests/motor.clad")],
                Some("program motor.clad\nstep 10ms\n"),
            ),
            (
                &[("/plant/motor.clad", "/plant/main motor.clad")],
                Some("program \"../main motor.clad\"\nstep 10ms\n"),
            ),
            // The scenarios move, or the folder of both.
            (
                &[("/plant/tests", "/plant/checks/all")],
                Some("program ../../motor.clad\nstep 10ms\n"),
            ),
            (&[("/plant", "/line")], None),
            (&[("/plant/other.clad", "/plant/pump.clad")], None),
        ] {
            assert_eq!(renamed(text, renames).as_deref(), expected, "{renames:?}");
        }
        assert_eq!(renamed("step 10ms\n", &[("/plant", "/line")]), None);
    }
}
