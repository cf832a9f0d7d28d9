//! Diagnostics after every change.
//!
//! One task at a time analyses a document. It takes the newest revision, so a burst of changes costs two or
//! three analyses instead of one each, and nobody waits for a revision that is no longer shown.

use std::sync::Arc;
use std::time::Duration;

use ladder_syntax::MAX_FILE_BYTES;
use tower_lsp::ls_types::{Diagnostic, DiagnosticSeverity, NumberOrString, Range};

use super::blocking::blocking;
use super::convert;
use super::shared::Shared;
use crate::document::Revision;

/// Above this many bytes an analysis takes long enough that a pause in typing is worth waiting for.
const LARGE: usize = 200_000;

/// How long a large text must have rested.
const PAUSE: Duration = Duration::from_millis(50);

/// Sees to it that the newest text of the document gets its diagnostics.
pub(super) fn refresh(shared: &Arc<Shared>, uri: &str) {
    if let Some(revision) = shared.documents.begin_analysis(uri) {
        tokio::spawn(analyse(shared.clone(), revision));
    }
}

async fn analyse(shared: Arc<Shared>, first: Arc<Revision>) {
    let mut next = Some(first);
    while let Some(revision) = next {
        if revision.len() > LARGE {
            tokio::time::sleep(PAUSE).await;
        }
        if shared.documents.is_current(&revision) {
            let (agreed, job) = (shared.agreed(), revision.clone());
            match blocking(move |_| diagnostics(agreed, &job)).await {
                Ok(diagnostics) => shared.outbox.diagnostics(revision.clone(), diagnostics),
                Err(error) => shared
                    .outbox
                    .log(format!("no diagnostics for {}: {}", revision.uri, error.message)),
            }
        }
        next = shared.documents.analysed(&revision);
    }
}

fn diagnostics(agreed: super::capabilities::Agreed, revision: &Revision) -> Vec<Diagnostic> {
    match revision.analysis() {
        Some(analysis) => analysis
            .diagnostics()
            .iter()
            .map(|problem| convert::diagnostic(agreed, revision, problem))
            .collect(),
        None => vec![too_large(revision)],
    }
}

fn too_large(revision: &Revision) -> Diagnostic {
    Diagnostic {
        range: Range::default(),
        severity: Some(DiagnosticSeverity::ERROR),
        code: Some(NumberOrString::String("file-too-large".into())),
        source: Some("ladder".into()),
        message: format!(
            "this file has {} bytes; files over {} MiB are not checked, formatted or simulated. Split the \
             program, or open the right file",
            revision.len(),
            MAX_FILE_BYTES >> 20
        ),
        ..Diagnostic::default()
    }
}
