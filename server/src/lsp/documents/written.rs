//! The diagnostics of open documents as JSON, each kept as text from one state of its document to the next.
//!
//! The protocol sends all diagnostics of a document with each edit. Most of them are as they were: what a finding says is
//! kept with it, and its places have the same lines and columns if the networks that they count from start at the
//! same lines, which is so without a look while edits make and remove no line. Only the others are written anew.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

use ladder_analysis::{Finding, Severity};
use rustc_hash::FxHashMap;

use super::shown;
use crate::document::Revision;
use crate::language::Analysis;
use crate::lsp::{capabilities::Agreed, convert};

/// What was written of each open document, by its address.
#[derive(Debug, Default)]
pub(crate) struct Written(Mutex<HashMap<String, Kept>>);

/// What was written of one document.
#[derive(Debug, Default)]
struct Kept {
    /// See [`Revision::line_breaks`].
    line_breaks: u64,
    /// How often it was written.
    times: u64,
    /// By the identity of the finding.
    all: FxHashMap<usize, One>,
}

/// One diagnostic.
#[derive(Debug)]
struct One {
    /// Keeps its identity from being that of another one.
    _finding: Finding,
    key: Key,
    json: Arc<str>,
    /// When it was written last.
    last: u64,
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
        (shown, left_out): (Vec<Finding>, usize),
    ) -> String {
        let mut kept = self.take(&revision.uri).unwrap_or_default();
        let all = kept.write(agreed, revision, analysis, &shown);
        let rest = shown::rest(left_out).and_then(|rest| serde_json::to_string(&rest).ok());
        let length: usize = all.iter().map(|json| json.len() + 1).sum();
        let mut params = String::with_capacity(length + 400);
        params.push_str("{\"uri\":");
        params.push_str(&serde_json::Value::from(&*revision.uri).to_string());
        params.push_str(",\"diagnostics\":[");
        for (number, text) in all.iter().map(|json| &**json).chain(rest.as_deref()).enumerate() {
            if number > 0 {
                params.push(',');
            }
            params.push_str(text);
        }
        params.push_str(&format!("],\"version\":{}}}", revision.version));
        self.kept().insert(revision.uri.to_string(), kept);
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

impl Kept {
    /// The JSON of findings, in their order.
    fn write(
        &mut self,
        agreed: Agreed,
        revision: &Revision,
        analysis: &Analysis,
        shown: &[Finding],
    ) -> Vec<Arc<str>> {
        self.times += 1;
        let same_lines = std::mem::replace(&mut self.line_breaks, revision.line_breaks()) == self.line_breaks;
        let mut all: Vec<Option<Arc<str>>> = Vec::with_capacity(shown.len());
        for finding in shown {
            all.push(self.recall(revision, analysis, finding, same_lines));
        }
        let missing = shown.iter().zip(&all).filter(|(_, kept)| kept.is_none());
        let missing: Vec<&Finding> = missing.map(|(finding, _)| finding).collect();
        let said: Vec<_> = missing
            .iter()
            .map(|finding| analysis.diagnostic(finding))
            .collect();
        let written = convert::diagnostics(agreed, revision, &said).into_iter();
        let written = written.map(|one| serde_json::to_string(&one).ok().map(Arc::from));
        let written: Vec<Option<Arc<str>>> = written.collect();
        for (finding, json) in missing.into_iter().zip(&written) {
            self.keep(revision, analysis, finding, json.as_ref());
        }
        // What is not shown any more may be shown again soon, but not for ever.
        if self.all.len() > 2 * shown.len() {
            self.all.retain(|_, one| one.last == self.times);
        }
        let mut written = written.into_iter();
        let mut next = || written.next().flatten();
        all.into_iter()
            .filter_map(|kept| kept.or_else(&mut next))
            .collect()
    }

    /// What was written of a finding, if it would be the same now.
    fn recall(
        &mut self,
        revision: &Revision,
        analysis: &Analysis,
        finding: &Finding,
        same_lines: bool,
    ) -> Option<Arc<str>> {
        let one = self.all.get_mut(&finding.identity())?;
        let was_last = std::mem::replace(&mut one.last, self.times) + 1 == self.times;
        let is_same = if same_lines && was_last {
            one.key.severity == finding.severity
        } else {
            Some(&one.key) == Key::of(revision, analysis, finding).as_ref()
        };
        is_same.then(|| Arc::clone(&one.json))
    }

    fn keep(&mut self, revision: &Revision, analysis: &Analysis, finding: &Finding, json: Option<&Arc<str>>) {
        if let Some((key, json)) = Key::of(revision, analysis, finding).zip(json) {
            let one = One {
                _finding: finding.clone(),
                key,
                json: Arc::clone(json),
                last: self.times,
            };
            self.all.insert(finding.identity(), one);
        }
    }
}

impl Key {
    /// None: what is written is true for one text only.
    fn of(revision: &Revision, analysis: &Analysis, finding: &Finding) -> Option<Key> {
        let networks = analysis.counts_from(finding)?;
        Some(Key {
            severity: finding.severity,
            lines: networks
                .into_iter()
                .map(|start| revision.line_of(start))
                .collect(),
        })
    }
}
