//! The diagnostics of open documents as JSON, each kept as text from one state of its document to the next.
//!
//! The protocol sends all diagnostics of a document with each edit. Most of them are as they were: what a finding says is
//! kept with it, and its places have the same lines and columns if the networks that they count from start at the
//! same lines. Only the others are written anew.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

use ladder_analysis::{Finding, Severity};

use super::shown;
use crate::document::Revision;
use crate::language::Analysis;
use crate::lsp::{capabilities::Agreed, convert};

/// What was written of each open document, by its address.
#[derive(Debug, Default)]
pub(crate) struct Written(Mutex<HashMap<String, Kept>>);

/// By the identity of the finding.
type Kept = HashMap<usize, One>;

/// One diagnostic.
#[derive(Debug)]
struct One {
    /// Keeps its identity from being that of another one.
    _finding: Finding,
    key: Key,
    json: Arc<str>,
}

/// What else than the finding itself decides about its JSON: how much it counts, and the lines where the networks start
/// that its places count from.
#[derive(Debug, PartialEq, Eq)]
struct Key {
    severity: Severity,
    lines: Vec<u32>,
}

impl Written {
    /// The parameters of `textDocument/publishDiagnostics` for a document: the findings that are shown, and how many are
    /// left out.
    pub(crate) fn params(
        &self,
        agreed: Agreed,
        revision: &Revision,
        analysis: &Analysis,
        (shown, left_out): (Vec<&Finding>, usize),
    ) -> String {
        let before = self.take(&revision.uri).unwrap_or_default();
        let all = write(agreed, revision, analysis, &shown, before);
        let rest = shown::rest(left_out).and_then(|rest| serde_json::to_string(&rest).ok());
        let length: usize = all.iter().map(|(json, _)| json.len() + 1).sum();
        let mut params = String::with_capacity(length + 400);
        params.push_str("{\"uri\":");
        params.push_str(&serde_json::Value::from(&*revision.uri).to_string());
        params.push_str(",\"diagnostics\":[");
        let texts = all.iter().map(|(json, _)| &**json).chain(rest.as_deref());
        for (number, text) in texts.enumerate() {
            if number > 0 {
                params.push(',');
            }
            params.push_str(text);
        }
        params.push_str(&format!("],\"version\":{}}}", revision.version));
        let keep = shown.into_iter().zip(all).filter_map(|(finding, (json, key))| {
            let one = One {
                _finding: finding.clone(),
                key: key?,
                json,
            };
            Some((finding.identity(), one))
        });
        self.kept().insert(revision.uri.to_string(), keep.collect());
        params
    }

    /// A document is closed.
    pub(crate) fn forget(&self, uri: &str) {
        self.take(uri);
    }

    fn take(&self, uri: &str) -> Option<Kept> {
        self.kept().remove(uri)
    }

    fn kept(&self) -> std::sync::MutexGuard<'_, HashMap<String, Kept>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The JSON of findings, in their order, each with its key if it may be kept.
fn write(
    agreed: Agreed,
    revision: &Revision,
    analysis: &Analysis,
    shown: &[&Finding],
    mut before: Kept,
) -> Vec<(Arc<str>, Option<Key>)> {
    let key = |finding: &Finding| {
        let networks = analysis.counts_from(finding)?;
        Some(Key {
            severity: finding.severity,
            lines: networks
                .into_iter()
                .map(|start| revision.line_of(start))
                .collect(),
        })
    };
    let keys: Vec<Option<Key>> = shown.iter().map(|finding| key(finding)).collect();
    let kept: Vec<Option<Arc<str>>> = shown
        .iter()
        .zip(&keys)
        .map(|(finding, key)| {
            let one = before.remove(&finding.identity())?;
            (Some(&one.key) == key.as_ref()).then_some(one.json)
        })
        .collect();
    let missing = shown.iter().zip(&kept).filter(|(_, kept)| kept.is_none());
    let missing: Vec<_> = missing.map(|(finding, _)| analysis.diagnostic(finding)).collect();
    let mut written = convert::diagnostics(agreed, revision, &missing).into_iter();
    let mut next = || {
        let diagnostic = written.next()?;
        serde_json::to_string(&diagnostic).ok().map(Arc::from)
    };
    kept.into_iter()
        .zip(keys)
        .filter_map(|(kept, key)| Some((kept.or_else(&mut next)?, key)))
        .collect()
}
