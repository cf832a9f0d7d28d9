//! The folders that the client has open.
//!
//! Which workspace a program belongs to is for `ladder.toml` to say, not for the client. But the programs below its
//! folders count before any of them is open: in the diagnostics of a workspace and in searches, and an error in a
//! `ladder.toml` is shown at once. So they are read at the beginning, while the client goes on.

use std::path::{Path, PathBuf};
use std::sync::{Arc, PoisonError};

use ladder_analysis::Cancel;
use ladder_documents::address::path_of;
use ladder_workspace::{SETTINGS_FILE, Survey, shown};
use tower_lsp::ls_types::{DidChangeWorkspaceFoldersParams, InitializeParams, WorkspaceFolder};

use super::{pull, settings_file};
use crate::lsp::documents::progress::Progress;
use crate::lsp::session::shared::Shared;

/// No more files and folders than these are checked below one folder.
const MOST: usize = 200_000;

/// Takes the folders that the client has open at first.
pub(crate) fn begin(shared: &Shared, params: &InitializeParams) {
    let mut folders: Vec<PathBuf> = match &params.workspace_folders {
        Some(folders) => folders.iter().filter_map(path).collect(),
        None => Vec::new(),
    };
    if folders.is_empty() {
        #[expect(deprecated, reason = "clients that know no workspace folders have only this")]
        let root = params.root_uri.as_ref();
        folders.extend(root.and_then(|root| path_of(root.as_str())));
    }
    shared.neighbours.foreign().open(&folders);
    *shared.folders.lock().unwrap_or_else(PoisonError::into_inner) = folders;
}

/// The client has opened and closed folders.
pub(crate) fn changed(shared: &Arc<Shared>, params: &DidChangeWorkspaceFoldersParams) {
    let mut folders = shared.folders.lock().unwrap_or_else(PoisonError::into_inner);
    let removed: Vec<PathBuf> = params.event.removed.iter().filter_map(path).collect();
    folders.retain(|folder| !removed.contains(folder));
    for added in params.event.added.iter().filter_map(path) {
        if !folders.contains(&added) {
            folders.push(added);
        }
    }
    shared.neighbours.foreign().open(&folders);
    drop(folders);
    shared.in_background(|shared| {
        shared.neighbours.forget(|root| is_open(shared, root));
        settings_file::tell(shared);
        pull::refresh(shared);
        index(shared);
    });
}

fn path(folder: &WorkspaceFolder) -> Option<PathBuf> {
    path_of(folder.uri.as_str())
}

/// The folders that the client has open.
pub(crate) fn open(shared: &Shared) -> Vec<PathBuf> {
    shared
        .folders
        .lock()
        .unwrap_or_else(PoisonError::into_inner)
        .clone()
}

/// Whether a folder lies in one that the client has open.
fn is_open(shared: &Shared, folder: &Path) -> bool {
    open(shared).iter().any(|open| folder.starts_with(open))
}

/// Reads what lies in the open folders and was not read yet, in the background.
pub(crate) fn index(shared: &Arc<Shared>) {
    shared.in_background(|shared| {
        let progress = Progress::begin(shared, "Reading ladder programs");
        read(shared, &progress, &Cancel::default());
        settings_file::tell(shared);
    });
}

/// Reads what lies in the open folders and was not read yet. For a blocking thread.
pub(crate) fn read(shared: &Shared, progress: &Progress, cancel: &Cancel) {
    for folder in open(shared) {
        let Survey {
            programs,
            settings_files,
            whole,
            refused,
        } = shared.world().disk.survey(&folder, MOST, cancel);
        if !whole && !cancel.is_cancelled() {
            shared.outbox.log(format!(
                "{}: this folder holds more than {MOST} files; programs that lie deep in it count when they are opened",
                shown::path(&folder)
            ));
        }
        for error in refused {
            shared.outbox.log(error.to_string());
        }
        // A settings file says what its folder is, also where there is no program yet; the one above may lie outside.
        let above = folder.join(SETTINGS_FILE);
        let all: Vec<&PathBuf> = settings_files.iter().chain([&above]).chain(&programs).collect();
        for (done, path) in all.iter().enumerate() {
            if cancel.is_cancelled() {
                return;
            }
            progress.report(done, all.len(), path);
            shared.neighbours.load(path);
        }
    }
}
