//! Diagnostics for clients that ask for them: of a document, and of the whole workspace.
//!
//! Such a client is never sent any unasked. Each list has an identity that follows from what is in it, so a client
//! that has it already gets word of that, whichever way it came there.

use std::collections::{BTreeMap, HashMap};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use ladder_analysis::Exported;
use serde_json::Value;
use tower_lsp::jsonrpc::{Error, Result};
use tower_lsp::ls_types::{
    DiagnosticOptions, DiagnosticServerCapabilities, DocumentDiagnosticParams, DocumentDiagnosticReport,
    DocumentDiagnosticReportResult, RelatedFullDocumentDiagnosticReport, WorkDoneProgressOptions,
    WorkspaceDiagnosticParams, WorkspaceDiagnosticReport, WorkspaceDiagnosticReportResult,
};

use super::{companions, diagnostics, folders, settings_file, watch};
use crate::document::Revision;
use crate::document::address::{path_of, uri_of};
use crate::document::membership::Membership;
use crate::document::on_disk::OnDisk;
use crate::lsp::shared::Shared;
use crate::lsp::transport::{blocking::blocking, prepared, progress::Progress};

/// Changes that come together are reported together.
const GATHER: Duration = Duration::from_millis(50);

/// A client that does not answer by then never will; nothing depends on it.
const PATIENCE: Duration = Duration::from_secs(30);

/// What was found in files that are not open, as long as they and what they see stay as they are.
pub(crate) type Found = Mutex<HashMap<PathBuf, (Arc<OnDisk>, Arc<Exported>, Arc<str>)>>;

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
    let (shared, work) = (shared.clone(), shared.busy.begin());
    tokio::spawn(async move {
        tokio::time::sleep(GATHER).await;
        shared.refresh_due.store(false, Ordering::Relaxed);
        drop(work);
        // Whether it answers is nobody's concern.
        let _ = tokio::time::timeout(PATIENCE, shared.client.workspace_diagnostic_refresh()).await;
    });
}

/// `textDocument/diagnostic`.
pub(crate) async fn document(
    shared: &Arc<Shared>,
    params: DocumentDiagnosticParams,
) -> Result<DocumentDiagnosticReportResult> {
    let uri = params.text_document.uri;
    watch::look_around(shared);
    let beside = shared.clone();
    let previous = params.previous_result_id;
    let report = blocking(move |_| {
        let shared = beside;
        if let Some(revision) = shared.companions.get(uri.as_str()) {
            let found = companions::diagnostics_of(&shared, &revision);
            return report(&diagnostics::list(&found), previous.as_deref(), "");
        }
        let Some(revision) = shared.documents.get(uri.as_str()) else {
            // Not open: as it is on disk, if it is known.
            let found = path_of(uri.as_str()).and_then(|path| on_disk(&shared, &path));
            return report(found.as_deref().unwrap_or("[]"), previous.as_deref(), "");
        };
        let items = diagnostics::look_at(&shared, &revision);
        let place = revision.place().filter(|_| shared.agreed().related_documents);
        let settings = place.and_then(|place| settings_file::of_program(&shared, &place.path));
        let related = settings.map(|(path, found)| {
            let settings = report(&diagnostics::list(&found), None, "");
            format!(",\"relatedDocuments\":{{\"{}\":{settings}}}", uri_of(&path))
        });
        report(&items, previous.as_deref(), &related.unwrap_or_default())
    })
    .await?;
    let unsent = DocumentDiagnosticReport::Full(RelatedFullDocumentDiagnosticReport::default());
    prepared::answer_instead(unsent.into(), report)
}

/// `workspace/diagnostic`: of the open documents, of the programs in the client's folders, of those beside open ones,
/// and of the settings files.
pub(crate) async fn workspace(
    shared: &Arc<Shared>,
    params: WorkspaceDiagnosticParams,
) -> Result<WorkspaceDiagnosticReportResult> {
    let token = params.work_done_progress_params.work_done_token.clone();
    let progress = Progress::of_request(shared, token, "Checking ladder programs");
    let beside = shared.clone();
    let reports = blocking(move |cancel| {
        let shared = beside;
        folders::read(&shared, &progress, &|| cancel.is_cancelled());
        let known: HashMap<&str, &str> = params
            .previous_result_ids
            .iter()
            .map(|it| (it.uri.as_str(), it.value.as_str()))
            .collect();
        // By address, so that the order is the same each time.
        let mut found: BTreeMap<String, (Option<i32>, Arc<str>)> = BTreeMap::new();
        for revision in shared.companions.all() {
            let items = diagnostics::list(&companions::diagnostics_of(&shared, &revision));
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
                let items = settings_file::diagnostics(&file, shared.agreed().encoding);
                found.insert(uri_of(&file.path), (None, diagnostics::list(&items).into()));
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
        let reports = found.into_iter().map(|(uri, (version, items))| {
            let version = version.map_or("null".to_owned(), |version| version.to_string());
            let of_file = format!(",\"uri\":{},\"version\":{version}", Value::from(&*uri));
            report(&items, known.get(&*uri).copied(), &of_file)
        });
        Some(format!(
            "{{\"items\":[{}]}}",
            reports.collect::<Vec<_>>().join(",")
        ))
    })
    .await?;
    let unsent = WorkspaceDiagnosticReport { items: Vec::new() };
    prepared::answer_instead(unsent.into(), reports.ok_or_else(Error::request_cancelled)?)
}

/// The report of a list of diagnostics, with more members behind. The client may have this list already.
fn report(items: &str, previous: Option<&str>, more: &str) -> String {
    let mut hasher = DefaultHasher::new();
    items.hash(&mut hasher);
    // The same for the same list, and for no other.
    let identity = format!("{:016x}", hasher.finish());
    if previous == Some(&*identity) {
        return format!("{{\"kind\":\"unchanged\",\"resultId\":\"{identity}\"{more}}}");
    }
    format!("{{\"kind\":\"full\",\"resultId\":\"{identity}\",\"items\":{items}{more}}}")
}

/// What is found in a program that is not open, or in a settings file, as the JSON of a list. None if the file is not known.
fn on_disk(shared: &Shared, path: &Path) -> Option<Arc<str>> {
    let agreed = shared.agreed();
    let files = shared.neighbours.settings_files();
    if let Some(file) = files.iter().find(|file| file.path == path) {
        return Some(diagnostics::list(&settings_file::diagnostics(file, agreed.encoding)).into());
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
    let revision = Revision::on_disk(&uri_of(path), agreed.encoding, file.text(), place);
    let found: Arc<str> = diagnostics::of_closed(agreed, &revision).into();
    lock().insert(path.to_owned(), (file, exported, found.clone()));
    Some(found)
}
