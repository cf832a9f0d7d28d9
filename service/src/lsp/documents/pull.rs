//! Diagnostics for clients that ask for them: of a document, and of the whole workspace.
//!
//! Such a client is never sent any unasked. Each list has an identity that follows from what is in it, so a client
//! that has it already gets word of that, whichever way it came there.

use std::collections::{BTreeMap, HashMap};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;
use std::sync::{Arc, PoisonError};
use std::time::Duration;

use ladder_documents::Revision;
use ladder_documents::address::{path_of, uri_of};
use ladder_documents::membership::Membership;
use tower_lsp::jsonrpc::{Error, Result};
use tower_lsp::ls_types::{
    Diagnostic, DiagnosticOptions, DiagnosticServerCapabilities, DocumentDiagnosticParams,
    DocumentDiagnosticReport, DocumentDiagnosticReportKind as Report, DocumentDiagnosticReportResult,
    FullDocumentDiagnosticReport, RelatedFullDocumentDiagnosticReport,
    RelatedUnchangedDocumentDiagnosticReport, UnchangedDocumentDiagnosticReport, Uri,
    WorkDoneProgressOptions, WorkspaceDiagnosticParams, WorkspaceDiagnosticReport,
    WorkspaceDiagnosticReportResult, WorkspaceDocumentDiagnosticReport,
    WorkspaceFullDocumentDiagnosticReport, WorkspaceUnchangedDocumentDiagnosticReport,
};

use super::progress::Progress;
use super::{companions, diagnostics, folders, foreign, settings_file, watch};
use crate::lsp::transport::blocking::blocking;
use crate::lsp::{convert, session::shared::Shared};

/// Changes that come together are reported together.
const GATHER: Duration = Duration::from_millis(50);

/// A client that does not answer by then never will; nothing depends on it.
pub(super) const PATIENCE: Duration = Duration::from_secs(30);

/// What is offered to a client that asks for diagnostics.
pub(crate) fn options() -> DiagnosticServerCapabilities {
    DiagnosticServerCapabilities::Options(DiagnosticOptions {
        identifier: Some("ladder".into()),
        inter_file_dependencies: true,
        workspace_diagnostics: true,
        work_done_progress_options: WorkDoneProgressOptions {
            work_done_progress: Some(true),
        },
    })
}

/// Tells a client that asks for diagnostics that those it has may be old ones.
pub(crate) fn refresh(shared: &Arc<Shared>) {
    let agreed = shared.agreed();
    if !agreed.pulls_diagnostics || !agreed.refreshes_diagnostics {
        return;
    }
    if shared.refresh_due.swap(true, Ordering::Relaxed) {
        return;
    }
    let (next_to, work) = (shared.clone(), shared.busy.begin());
    shared.spawn(async move {
        let shared = next_to;
        shared.host.sleep(GATHER).await;
        shared.refresh_due.store(false, Ordering::Relaxed);
        drop(work);
        // Whether it answers is nobody's concern.
        let asked = shared.client.workspace_diagnostic_refresh();
        let _ = shared.within(PATIENCE, asked).await;
    });
}

/// `textDocument/diagnostic`.
pub(crate) async fn document(
    shared: &Arc<Shared>,
    params: DocumentDiagnosticParams,
) -> Result<DocumentDiagnosticReportResult> {
    let uri = params.text_document.uri;
    watch::look_around(shared);
    let next_to = shared.clone();
    let previous = params.previous_result_id;
    blocking(&*shared.host, move |_| {
        let shared = next_to;
        let previous = previous.as_deref();
        if let Some(revision) = shared.companions.get(uri.as_str()) {
            let found = companions::diagnostics_of(&shared, &revision);
            foreign::tell_others(&shared, &revision);
            return related(report(&found, previous), None);
        }
        let Some(revision) = shared.documents.get(uri.as_str()) else {
            // Not open: as it is on disk, if it is known.
            let found = path_of(uri.as_str()).and_then(|path| on_disk(&shared, &path));
            return related(
                report(found.as_deref().map_or(&[], Vec::as_slice), previous),
                None,
            );
        };
        // The rest is asked for when it is known.
        let asks_again = shared.agreed().refreshes_diagnostics;
        let early = asks_again
            .then(|| diagnostics::of_own_text(&shared, &revision))
            .flatten();
        let items = early.unwrap_or_else(|| diagnostics::look_at(&shared, &revision));
        let place = revision.place().filter(|_| shared.agreed().related_documents);
        let settings = place.and_then(|place| settings_file::of_program(&shared, &place.path));
        let settings = settings
            .and_then(|(path, found)| Some([(convert::uri(&uri_of(&path))?, report(&found, None))].into()));
        related(report(&items, previous), settings)
    })
    .await
}

/// `workspace/diagnostic`: of the open documents, of the programs in the client's folders, of those next to open ones,
/// and of the settings files.
pub(crate) async fn workspace(
    shared: &Arc<Shared>,
    params: WorkspaceDiagnosticParams,
) -> Result<WorkspaceDiagnosticReportResult> {
    let token = params.work_done_progress_params.work_done_token.clone();
    let progress = Progress::of_request(shared, token, "Checking ladder programs");
    let next_to = shared.clone();
    let reports = blocking(&*shared.host, move |cancel| {
        let shared = next_to;
        folders::read(&shared, &progress, cancel);
        let known: HashMap<&str, &str> = params
            .previous_result_ids
            .iter()
            .map(|it| (it.uri.as_str(), it.value.as_str()))
            .collect();
        // By address, so that the order is the same each time.
        let mut found: BTreeMap<String, (Option<i32>, Arc<Vec<Diagnostic>>)> = BTreeMap::new();
        for revision in shared.companions.all() {
            let items = companions::diagnostics_of(&shared, &revision);
            found.insert(revision.uri.to_string(), (Some(revision.version), items.into()));
        }
        for revision in shared.documents.all() {
            if cancel.is_cancelled() {
                return None;
            }
            let items = diagnostics::look_at(&shared, &revision);
            found.insert(revision.uri.to_string(), (Some(revision.version), items.into()));
        }
        let open: Vec<PathBuf> = found.keys().filter_map(|uri| path_of(uri)).collect();
        for file in shared.neighbours.settings_files() {
            if !open.contains(&file.path) {
                let items = settings_file::diagnostics(&shared, &file);
                found.insert(uri_of(&file.path), (None, items.into()));
            }
        }
        let closed = shared.neighbours.closed_programs();
        for (done, path) in closed.iter().enumerate() {
            if cancel.is_cancelled() {
                return None;
            }
            progress.report(done, closed.len(), path);
            if !open.contains(path)
                && let Some(items) = on_disk(&shared, path)
            {
                found.insert(uri_of(path), (None, items));
            }
        }
        let reports = found.into_iter().filter_map(|(uri, (version, items))| {
            let report = report(&items, known.get(&*uri).copied());
            Some(of_file(convert::uri(&uri)?, version.map(i64::from), report))
        });
        Some(WorkspaceDiagnosticReport {
            items: reports.collect(),
        })
    })
    .await?;
    Ok(reports.ok_or_else(Error::request_cancelled)?.into())
}

/// The report of a list of diagnostics. The client may have this list already.
fn report(items: &[Diagnostic], previous: Option<&str>) -> Report {
    let mut hasher = DefaultHasher::new();
    serde_json::to_string(items).unwrap_or_default().hash(&mut hasher);
    // The same for the same list, and for no other.
    let result_id = format!("{:016x}", hasher.finish());
    if previous == Some(&*result_id) {
        return UnchangedDocumentDiagnosticReport { result_id }.into();
    }
    let report = FullDocumentDiagnosticReport {
        result_id: Some(result_id),
        items: items.to_vec(),
    };
    report.into()
}

/// The answer about one file, with the reports of others.
fn related(report: Report, others: Option<HashMap<Uri, Report>>) -> DocumentDiagnosticReportResult {
    let report: DocumentDiagnosticReport = match report {
        Report::Full(report) => RelatedFullDocumentDiagnosticReport {
            related_documents: others,
            full_document_diagnostic_report: report,
        }
        .into(),
        Report::Unchanged(report) => RelatedUnchangedDocumentDiagnosticReport {
            related_documents: others,
            unchanged_document_diagnostic_report: report,
        }
        .into(),
    };
    report.into()
}

/// The part of an answer about a whole workspace that is about one file.
fn of_file(uri: Uri, version: Option<i64>, report: Report) -> WorkspaceDocumentDiagnosticReport {
    match report {
        Report::Full(report) => WorkspaceFullDocumentDiagnosticReport {
            uri,
            version,
            full_document_diagnostic_report: report,
        }
        .into(),
        Report::Unchanged(report) => WorkspaceUnchangedDocumentDiagnosticReport {
            uri,
            version,
            unchanged_document_diagnostic_report: report,
        }
        .into(),
    }
}

/// What is found in a program that is not open, or in a settings file. None if the file is not known.
fn on_disk(shared: &Shared, path: &Path) -> Option<Arc<Vec<Diagnostic>>> {
    let agreed = shared.agreed();
    let files = shared.neighbours.settings_files();
    if let Some(file) = files.iter().find(|file| file.path == path) {
        return Some(settings_file::diagnostics(shared, file).into());
    }
    let (file, exported) = shared.neighbours.closed_program(path)?;
    let lock = || shared.found.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((of, seen, found)) = lock().get(path)
        && Arc::ptr_eq(of, &file)
        && Arc::ptr_eq(seen, &exported)
    {
        return Some(found.clone());
    }
    let place = Membership::new(path.to_owned(), &shared.neighbours);
    let revision = Revision::on_disk(&uri_of(path), agreed.encoding, file.member().text(), place);
    let found = Arc::new(diagnostics::of_closed(agreed, &revision));
    lock().insert(path.to_owned(), (file, exported, found.clone()));
    Some(found)
}
