//! Diagnostics of settings files that nobody has open: an error in `ladder.toml` concerns every program below it.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, PoisonError};

use ladder_analysis::Severity;
use ladder_documents::SettingsFile;
use ladder_documents::address::{path_of, uri_of};
use ladder_documents::position;
use ladder_workspace::shown;
use ropey::Rope;
use tower_lsp::ls_types::Diagnostic;

use super::companions::BAD_SETTING;
use super::misfits;
use crate::lsp::{convert, session::shared::Shared};

/// A settings file was closed: what was reported of it was withdrawn, and is reported again.
pub(crate) fn tell_again(shared: &Arc<Shared>, uri: &str) {
    if let Some(path) = path_of(uri) {
        let mut sent = shared
            .settings_files
            .lock()
            .unwrap_or_else(PoisonError::into_inner);
        sent.remove(&path);
    }
    shared.in_background(|shared| tell(shared));
}

/// Tells the client what is wrong in settings files that were read, as far as that is new. A file that is open shows
/// what is wrong in the editor's own text.
pub(crate) fn tell(shared: &Shared) {
    let agreed = shared.agreed();
    let open = open_files(shared);
    let mut wrong: BTreeMap<PathBuf, Vec<Diagnostic>> = BTreeMap::new();
    for file in shared.neighbours.settings_files() {
        if !open.contains(&file.path) {
            let found = diagnostics(shared, &file);
            if !found.is_empty() {
                wrong.insert(file.path.clone(), found);
            }
        }
    }
    let mut later = Vec::new();
    let mut sent = shared
        .settings_files
        .lock()
        .unwrap_or_else(PoisonError::into_inner);
    if *sent == wrong {
        return;
    }
    if agreed.pulls_diagnostics {
        // The client asks for them, next to those of a program; one that does not take them there gets a message.
        if !agreed.related_documents {
            for (path, diagnostics) in &wrong {
                if sent.get(path) == Some(diagnostics) {
                    continue;
                }
                if concerns_an_open_program(shared, path) {
                    shared.outbox.show(sentence(path, diagnostics));
                } else {
                    // Nobody looks at it now: sent when a program is opened below it.
                    later.push(path.clone());
                }
            }
        }
    } else {
        for (path, diagnostics) in &wrong {
            if sent.get(path) != Some(diagnostics) {
                shared
                    .outbox
                    .diagnostics_on_disk(&uri_of(path), diagnostics.clone());
            }
        }
        let fixed = sent.keys().filter(|path| !wrong.contains_key(*path));
        for path in fixed.filter(|path| !open.contains(path)) {
            shared.outbox.no_diagnostics(&uri_of(path));
        }
    }
    wrong.retain(|path, _| !later.contains(path));
    *sent = wrong;
}

/// Whether a program is open that the settings file is above.
fn concerns_an_open_program(shared: &Shared, settings_file: &Path) -> bool {
    shared.documents.all().iter().any(|document| {
        document
            .place()
            .and_then(|place| shared.neighbours.settings_file(&place.path))
            .is_some_and(|file| file.path == settings_file)
    })
}

/// The files that the client has open as texts that are not programs.
fn open_files(shared: &Shared) -> Vec<PathBuf> {
    let open = shared.companions.all();
    open.iter().filter_map(|it| path_of(&it.uri)).collect()
}

/// The settings file of a program's workspace, if something in it is wrong and it is not open.
pub(crate) fn of_program(shared: &Shared, program: &Path) -> Option<(PathBuf, Vec<Diagnostic>)> {
    let file = shared.neighbours.settings_file(program)?;
    if open_files(shared).contains(&file.path) {
        return None;
    }
    Some((file.path.clone(), diagnostics(shared, &file)))
}

/// What is wrong in a settings file.
pub(crate) fn diagnostics(shared: &Shared, file: &SettingsFile) -> Vec<Diagnostic> {
    let (rope, encoding) = (Rope::from_str(&file.text), shared.agreed().encoding);
    let settings = shared.neighbours.that_may_misfit(&file.path);
    let misfits = settings.map(|settings| misfits::of(shared, &file.path, &settings, &file.text));
    let errors = file.errors.iter().chain(misfits.iter().flatten());
    errors
        .map(|error| {
            let range = convert::range(position::range(&rope, encoding, error.range.into()));
            convert::diagnostic(range, Severity::Error, BAD_SETTING, error.message.clone())
        })
        .collect()
}

/// `/plant/ladder.toml:3:1: ...`, a line for each.
fn sentence(path: &Path, diagnostics: &[Diagnostic]) -> String {
    let lines = diagnostics.iter().map(|it| {
        let start = it.range.start;
        format!(
            "{}:{}:{}: {}",
            shown::path(path),
            start.line + 1,
            start.character + 1,
            shown::line(&it.message)
        )
    });
    lines.collect::<Vec<_>>().join("\n")
}
