//! Diagnostics after every change.
//!
//! One task at a time analyses a document. It takes the newest revision, so a burst of changes costs two or
//! three analyses instead of one each, and nobody waits for a revision that is no longer shown.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use ladder_analysis::rules::is_of_own_text;
use ladder_analysis::{Cancel, Finding, Severity};
use ladder_documents::Revision;
use ladder_documents::neighbours::Affected;
use ladder_host::Work;
use ladder_syntax::{MAX_OPEN_BYTES, MAX_OPEN_LINES};
use ladder_workspace::SETTINGS_FILE;
use tower_lsp::ls_types::{Diagnostic, Range};

use super::{companions, folders, foreign, pull, settings_file, shown, typed};
use crate::lsp::transport::blocking::caught;
use crate::lsp::{convert, finding::Findings, session::agreed::Agreed, session::shared::Shared};

/// Sees to it that the newest text of the document gets its diagnostics.
pub(crate) fn refresh(shared: &Arc<Shared>, uri: &str) {
    if let Some(revision) = shared.documents.begin_analysis(uri) {
        let (next_to, work) = (shared.clone(), shared.busy.begin());
        // All on one thread: what was allocated there is freed there, and a small edit costs less than a hop to another.
        shared
            .host
            .work(Box::new(move || analyse(&next_to, revision, work)));
    }
}

fn analyse(shared: &Arc<Shared>, first: Arc<Revision>, _work: Work) {
    let mut next = Some(first);
    while let Some(revision) = next {
        if shared.documents.is_current(&revision)
            && let Err(error) = caught(|| look(shared, &revision))
        {
            let message = format!("no diagnostics for {}: {}", revision.uri, error.message);
            shared.outbox.log(message);
        }
        next = shared.documents.analysed(&revision);
    }
}

/// Looks for what is wrong in a text: the person gets it first, then the other files. For a blocking thread.
fn look(shared: &Arc<Shared>, revision: &Arc<Revision>) {
    let agreed = shared.agreed();
    // What is sent of the text before stays until then.
    let (documents, current) = (shared.documents.clone(), revision.clone());
    let cancel = Cancel::when(move || !documents.is_current(&current));
    if !agreed.pulls_diagnostics
        && let Some(found) = of_own_text(shared, revision)
    {
        send(shared, revision, found);
    }
    if revision.fits() && revision.analysis_unless(&cancel).is_none() {
        return;
    }
    if !agreed.pulls_diagnostics {
        send(shared, revision, of_open(shared, revision));
    }
    if revision.was_shown_early() {
        ask_again(shared);
    }
    tell_others(shared, revision);
}

/// Notifies the client that what it asked for before large files of the workspace were read may be old.
fn ask_again(shared: &Arc<Shared>) {
    pull::refresh(shared);
    if shared.agreed().refreshes_semantic_tokens {
        let next_to = shared.clone();
        shared.spawn(async move {
            let asked = next_to.client.semantic_tokens_refresh();
            let _ = next_to.within(pull::PATIENCE, asked).await;
        });
    }
}

/// Sends the diagnostics of a program.
fn send(shared: &Shared, revision: &Arc<Revision>, found: Vec<Diagnostic>) {
    shared
        .outbox
        .diagnostics(&shared.documents, revision.clone(), found);
}

/// The diagnostics of a program. The other open files of its workspace are checked again if they
/// see something else in it than before. For a blocking thread.
pub(crate) fn look_at(shared: &Arc<Shared>, revision: &Revision) -> Vec<Diagnostic> {
    let diagnostics = of_open(shared, revision);
    tell_others(shared, revision);
    diagnostics
}

/// Has the other open files of a program's workspace checked again if they see something else in it than before.
fn tell_others(shared: &Arc<Shared>, revision: &Revision) {
    if let Some(place) = revision.place().filter(|_| shared.documents.is_current(revision)) {
        let affected = revision.tell_neighbours();
        if affected.for_others {
            refresh_others(shared, &[&place.path], Some(&revision.uri));
        }
        if affected.moved && !affected.for_others {
            refresh_related(shared, revision);
        }
        if affected.for_itself {
            look_again(shared, &revision.uri);
        }
        simulate_with(shared, &place.path, Some(&revision.uri));
        settings_file::tell(shared);
        companions::refresh_scenarios(shared);
    }
}

/// A program that is not ladder text was passed on to the other files of its workspace.
pub(crate) fn passed_on(shared: &Arc<Shared>, affected: Affected, path: &Path) {
    // What is inside of its blocks counts in a simulation, which no finding is about.
    simulate_with(shared, path, None);
    if affected == Affected::default() {
        return;
    }
    shared.neighbours.places_moved(path);
    refresh_others(shared, &[path], None);
    companions::refresh_scenarios(shared);
}

/// Looks once more at the open documents of the workspaces of files, but for one. Once for all of the files: each look says
/// what it finds.
fn refresh_others(shared: &Arc<Shared>, paths: &[impl AsRef<Path>], but: Option<&str>) {
    for other in shared.documents.all() {
        let next_to = other.place().is_some_and(|place| {
            let together = |path: &Path| shared.neighbours.together(&place.path, path);
            paths.iter().any(|path| together(path.as_ref()))
        });
        if next_to && Some(&*other.uri) != but {
            look_again(shared, &other.uri);
        }
    }
    pull::refresh(shared);
}

/// Looks once more at the open documents whose findings name places in a file: they are others now.
fn refresh_related(shared: &Arc<Shared>, revision: &Revision) {
    let (Some(place), Some(context)) = (revision.place(), revision.context()) else {
        return;
    };
    let file = &context.name;
    let all = shared.documents.all();
    let related: Vec<_> = all.iter().filter(|other| other.relates_to(file)).collect();
    if related.is_empty() {
        return;
    }
    shared.neighbours.places_moved(&place.path);
    for other in related {
        look_again(shared, &other.uri);
    }
    pull::refresh(shared);
}

/// Simulations of the other programs of a file's workspace go on with what the file holds now: what is inside of its functions
/// and blocks counts as well, which no finding is about.
fn simulate_with(shared: &Arc<Shared>, path: &Path, but: Option<&str>) {
    if shared.sessions.is_empty() {
        return;
    }
    let companions = shared.companions.all().into_iter();
    let companions = companions.filter(|other| shared.simulated(&other.uri).is_some());
    for other in shared.documents.all().into_iter().chain(companions) {
        let next_to = other
            .place()
            .is_some_and(|place| shared.neighbours.together(&place.path, path));
        if next_to && Some(&*other.uri) != but {
            shared.sessions.follow_others(&other);
        }
    }
}

/// Looks once more at an open document, whose text is as it was.
pub(crate) fn look_again(shared: &Arc<Shared>, uri: &str) {
    if shared.documents.touch(uri) {
        refresh(shared, uri);
    }
}

/// A document was closed: its file counts as it is on disk.
pub(crate) fn neighbour_closed(shared: &Arc<Shared>, uri: String, path: PathBuf) {
    shared.in_background(move |shared| {
        // Unless it was opened again meanwhile.
        let is_open = shared.documents.get(&uri).is_some() || shared.companions.get(&uri).is_some();
        if !is_open && shared.neighbours.closed(&path) {
            refresh_others(shared, &[&path], None);
        }
        simulate_with(shared, &path, None);
        // What was typed into it and not saved counts no longer.
        companions::refresh_scenarios(shared);
    });
}

/// Files were changed, made or removed on disk.
pub(crate) fn disk_changed(shared: &Arc<Shared>, paths: Vec<PathBuf>) {
    shared.in_background(move |shared| files_changed(shared, &paths));
}

/// As [`disk_changed`], on a thread that may read the disk.
pub(crate) fn files_changed(shared: &Arc<Shared>, paths: &[PathBuf]) {
    let settings = paths
        .iter()
        .any(|path| path.file_name().is_some_and(|name| name == SETTINGS_FILE));
    if shared.neighbours.disk_changed(paths) {
        if settings {
            // Which file belongs where may be another matter now.
            look_at_everything_again(shared);
        } else {
            refresh_others(shared, paths, None);
        }
    }
    for path in paths {
        simulate_with(shared, path, None);
    }
    companions::refresh_programs(shared, paths);
    companions::refresh_scenarios(shared);
}

/// The settings of the editor or of a workspace are other ones, or the client has other folders open.
pub(crate) fn look_at_everything_again(shared: &Arc<Shared>) {
    for document in shared.documents.all() {
        look_again(shared, &document.uri);
    }
    pull::refresh(shared);
    folders::index(shared);
}

/// What is found in a text that a person has open, without what is being typed. For a blocking thread.
fn of_open(shared: &Shared, revision: &Revision) -> Vec<Diagnostic> {
    let Some(analysis) = revision.analysis() else {
        return vec![too_large(revision)];
    };
    let (mut shown, left_out) = shown::shown(analysis, revision);
    typed::without_waiting(shared, revision, &mut shown);
    list(shared.agreed(), revision, &shown, left_out)
}

/// What is found in a text that a person has open whatever the other files show, while large ones of them are still to be read. For a
/// blocking thread.
pub(crate) fn of_own_text(shared: &Shared, revision: &Revision) -> Option<Vec<Diagnostic>> {
    let analysis = revision.first_analysis()?;
    let (mut shown, _) = shown::shown(&analysis, revision);
    shown.retain(|finding| is_of_own_text(finding.rule));
    typed::without_waiting(shared, revision, &mut shown);
    Some(list(shared.agreed(), revision, &shown, 0))
}

/// What is found in a text that nobody has open. For a blocking thread.
pub(crate) fn of_closed(agreed: Agreed, revision: &Revision) -> Vec<Diagnostic> {
    if revision.kind().notation().is_some() {
        return foreign::diagnostics_of(agreed, revision);
    }
    let Some(analysis) = revision.analysis() else {
        return vec![too_large(revision)];
    };
    let (shown, left_out) = shown::shown(analysis, revision);
    list(agreed, revision, &shown, left_out)
}

/// The findings that are shown, in their order, and one that says how many are left out.
fn list(agreed: Agreed, revision: &Revision, shown: &[Finding], left_out: usize) -> Vec<Diagnostic> {
    let mut findings = Findings::of(agreed, revision);
    let shown = shown.iter().map(|found| findings.diagnostic(&found.diagnostic()));
    shown.chain(shown::rest(left_out)).collect()
}

pub(crate) fn too_large(revision: &Revision) -> Diagnostic {
    let message = format!(
        "this file has {} bytes; files over {} MiB, or of more than {MAX_OPEN_LINES} lines, are not checked, \
         formatted or simulated. Split the program, or open the right file",
        revision.len(),
        MAX_OPEN_BYTES >> 20
    );
    convert::diagnostic(Range::default(), Severity::Error, "file-too-large", message)
}
