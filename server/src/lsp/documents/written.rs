//! The diagnostics of open documents as JSON, each kept as text from one state of its document to the next.
//!
//! The protocol sends all diagnostics of a document with each edit. Most of them are as they were: what a finding says is
//! kept with it, and its places have the same lines and columns if what they count from starts at the
//! same lines, which is so without a look while edits make and remove no line. Where text comes or goes above, only the
//! numbers of lines are exchanged.

use std::collections::HashMap;
use std::sync::{Mutex, PoisonError};

use ladder_analysis::{Finding, Severity};
use rustc_hash::FxHashMap;

use super::diagnostic_json::{Json, Writer};
use super::shown;
use crate::document::Revision;
use crate::language::Analysis;
use crate::lsp::capabilities::Agreed;

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
    /// How long it was last.
    length: usize,
    /// By the identity of the finding.
    all: FxHashMap<usize, One>,
}

/// One diagnostic.
#[derive(Debug)]
struct One {
    /// Keeps its identity from being that of another one.
    _finding: Finding,
    severity: Severity,
    /// See [`Finding::first_lines`].
    lines: Box<[u32]>,
    json: Json,
    /// When it was written last.
    last: u64,
}

impl Written {
    /// The parameters of `textDocument/publishDiagnostics` for a document: the findings that are shown, and how many are
    /// left out.
    pub(crate) fn params(
        &self,
        agreed: Agreed,
        revision: &Revision,
        analysis: &Analysis,
        chosen: (Vec<Finding>, usize),
    ) -> String {
        let uri = serde_json::Value::from(&*revision.uri);
        let before = format!("{{\"uri\":{uri},\"diagnostics\":");
        let behind = format!(",\"version\":{}}}", revision.version);
        self.within((&before, &behind), agreed, revision, analysis, chosen)
    }

    /// The same findings as a list, for a client that asks for them.
    pub(crate) fn list(
        &self,
        agreed: Agreed,
        revision: &Revision,
        analysis: &Analysis,
        chosen: (Vec<Finding>, usize),
    ) -> String {
        self.within(("", ""), agreed, revision, analysis, chosen)
    }

    /// The list between two texts.
    fn within(
        &self,
        (before, behind): (&str, &str),
        agreed: Agreed,
        revision: &Revision,
        analysis: &Analysis,
        chosen: (Vec<Finding>, usize),
    ) -> String {
        let mut kept = self.take(&revision.uri).unwrap_or_default();
        let mut text = kept.room();
        text.push_str(before);
        kept.list(agreed, revision, analysis, chosen, &mut text);
        text.push_str(behind);
        self.kept().insert(revision.uri.to_string(), kept);
        text
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

/// As [`Written::list`], of a text that nobody has open: nothing is kept.
pub(crate) fn list_once(
    agreed: Agreed,
    revision: &Revision,
    analysis: &Analysis,
    chosen: (Vec<Finding>, usize),
) -> String {
    let mut list = String::new();
    Kept::default().list(agreed, revision, analysis, chosen, &mut list);
    list
}

impl Kept {
    /// For what is written next, which is likely to be as long as what was written last.
    fn room(&self) -> String {
        String::with_capacity(self.length + 400)
    }

    /// Adds the JSON list of findings, with one that says how many are left out.
    fn list(
        &mut self,
        agreed: Agreed,
        revision: &Revision,
        analysis: &Analysis,
        (shown, left_out): (Vec<Finding>, usize),
        out: &mut String,
    ) {
        out.push('[');
        self.write(agreed, revision, analysis, &shown, out);
        if let Some(rest) = shown::rest(left_out).and_then(|rest| serde_json::to_string(&rest).ok()) {
            separate(out, shown.is_empty());
            out.push_str(&rest);
        }
        out.push(']');
        self.length = out.len();
    }

    /// Adds the JSON of findings, in their order.
    fn write(
        &mut self,
        agreed: Agreed,
        revision: &Revision,
        analysis: &Analysis,
        shown: &[Finding],
        out: &mut String,
    ) {
        let mut writer = Writer::new(agreed, revision);
        for (number, finding) in shown.iter().enumerate() {
            separate(out, number == 0);
            let json = writer.write(&finding.diagnostic(), &[]);
            out.push_str(json.as_str());
        }
    }
}

/// Puts a comma between what is written and what is not the first.
fn separate(out: &mut String, is_first: bool) {
    if !is_first {
        out.push(',');
    }
}

#[cfg(test)]
mod tests {
    use serde::Deserialize;
    use serde_json::Value;
    use tower_lsp::ls_types::PublishDiagnosticsParams;

    use super::*;
    use crate::document::Documents;
    use crate::document::edit::Change;
    use crate::document::position::{Encoding, Position, Range};

    const URI: &str = "file:///a%20b.clad";

    /// Findings in networks and at declarations, with related places in both, with fixes, with text without effect, one whose
    /// places are true for one text only, and none of them on a line of one digit alone.
    const TEXT: &str = "VAR\n  a, b, öl : BOOL;\n  a2 : INT;\n  unused, x : BOOL;\n  t : TON;\nEND_VAR\n\
        +--[ ]( a )--( )( b )--[ ]( a )--( )( x )--+\n\n\
        +--# über\n  Zeilen #--[ ]( öl )--[GT]( \"ä\\\\\", a2 )--( )( b )--+\n\n\
        +--[ ]( x )--( )( x )--[ ]( missing )--( )( b )--\\--+\n\n\
        +--<LBL>( here )--[ ]( a )--(S)( öl )--+\n\n\
        +--[TON]( t, T#1s )--<JMP>( away )--+\n\n\
        +--[TON]( t, T#2s )--[ ]( a )--[ ]( gone )--( )( b )--+\n";

    fn agreed(choice: usize) -> Agreed {
        Agreed {
            encoding: Encoding::Utf16,
            related_information: choice & 1 > 0,
            unnecessary_tag: choice & 2 > 0,
            diagnostic_data: choice & 4 > 0,
            ..Agreed::default()
        }
    }

    fn written(written: &Written, agreed: Agreed, revision: &Revision) -> Value {
        let analysis = revision.analysis().expect("the text is not too large");
        let shown = (analysis.findings().to_vec(), 0);
        let params = written.params(agreed, revision, analysis, shown);
        serde_json::from_str(&params).expect("what is written is JSON")
    }

    /// What is written without anything kept.
    fn expected(agreed: Agreed, revision: &Revision) -> Value {
        let fresh = written(&Written::default(), agreed, revision);
        let typed = PublishDiagnosticsParams::deserialize(&fresh).expect("it is what the protocol asks for");
        assert_eq!(serde_json::to_value(typed).expect("it can be written"), fresh);
        fresh
    }

    #[test]
    fn what_is_kept_moves_with_the_text() {
        let edits = [
            // A line comes above all networks, and one goes.
            ((1, 0), (1, 0), "  c : BOOL;\n"),
            ((1, 0), (2, 0), ""),
            // Numbers of lines get more digits, and fewer.
            ((6, 0), (6, 0), "\n\n\n\n\n\n\n\n\n\n"),
            ((0, 0), (0, 0), "\n".repeat(90).leak() as &str),
            ((0, 0), (90, 0), ""),
            ((6, 0), (16, 0), ""),
            // A comment that spans lines comes and goes.
            ((8, 0), (8, 0), "# one\n two\n#\n"),
            ((8, 0), (11, 0), ""),
            // No line comes or goes.
            ((6, 3), (6, 3), "--"),
            ((6, 3), (6, 5), ""),
            ((3, 2), (3, 8), "unused_too"),
            ((3, 2), (3, 12), "unused"),
            // Networks between others.
            ((7, 0), (7, 0), "\n+--[ ]( b )--( )( c )--+\n\n"),
            ((7, 0), (10, 0), ""),
        ];
        for choice in 0..8 {
            let agreed = agreed(choice);
            let documents = Documents::default();
            let kept = Written::default();
            let mut revision = documents.open(URI, 1, Encoding::Utf16, TEXT);
            assert!(revision.analysis().is_some_and(|it| it.findings().len() > 5));
            assert_eq!(written(&kept, agreed, &revision), expected(agreed, &revision));
            for (version, (start, end, text)) in (2..).zip(edits) {
                let at = |(line, character)| Position { line, character };
                let change = Change::Part {
                    range: Range {
                        start: at(start),
                        end: at(end),
                    },
                    text: text.to_owned(),
                };
                revision = documents.change(URI, version, &[change]).expect("it is open");
                let fresh = expected(agreed, &revision);
                assert_eq!(
                    written(&kept, agreed, &revision),
                    fresh,
                    "edit {version}, {choice}"
                );
            }
            assert_eq!(revision.text(), TEXT);
        }
    }
}
