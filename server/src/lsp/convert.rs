//! From the server's own types to the protocol's.

use std::cell::{Cell, OnceCell};
use std::fmt::Write;
use std::str::FromStr;

use serde_json::json;
use tower_lsp::ls_types::{
    Diagnostic, DiagnosticRelatedInformation, DiagnosticSeverity, DiagnosticTag, DocumentChanges, Location,
    NumberOrString, OneOf, OptionalVersionedTextDocumentIdentifier, Position, Range, TextDocumentEdit,
    TextEdit, Uri, WorkspaceEdit,
};

use crate::document::positions::Positions;
use crate::document::{self, Beside, Revision};
use crate::lsp::capabilities::Agreed;
use ladder_analysis::Severity;
use ladder_format::Edit;
use ladder_syntax::TextRange;

/// The rules that mark text without effect: editors show it faded.
const UNNECESSARY: [&str; 3] = ["unreachable", "unused-function", "unused-label"];

pub(crate) fn position(position: document::position::Position) -> Position {
    Position {
        line: position.line,
        character: position.character,
    }
}

pub(crate) fn range(range: document::position::Range) -> Range {
    Range {
        start: position(range.start),
        end: position(range.end),
    }
}

pub(crate) fn our_position(position: Position) -> document::position::Position {
    document::position::Position {
        line: position.line,
        character: position.character,
    }
}

pub(crate) fn our_range(range: Range) -> document::position::Range {
    document::position::Range {
        start: our_position(range.start),
        end: our_position(range.end),
    }
}

/// An address that came from the protocol goes back unchanged, so it always reads.
pub(crate) fn uri(uri: &str) -> Option<Uri> {
    Uri::from_str(uri).ok()
}

pub(crate) fn range_in(revision: &Revision, place: TextRange) -> Range {
    range(revision.range(place))
}

pub(crate) fn edits(revision: &Revision, edits: &[Edit]) -> Vec<TextEdit> {
    edits
        .iter()
        .map(|edit| TextEdit {
            range: range_in(revision, edit.range),
            new_text: edit.text.clone(),
        })
        .collect()
}

/// The edits as a change of the workspace, bound to the version that they are for where the client can check
/// that.
pub(crate) fn workspace_edit(
    agreed: Agreed,
    revision: &Revision,
    our_edits: &[Edit],
) -> Option<WorkspaceEdit> {
    let uri = uri(&revision.uri)?;
    let edits = edits(revision, our_edits);
    Some(if agreed.versioned_edits {
        let text_document = OptionalVersionedTextDocumentIdentifier {
            uri,
            version: Some(revision.version),
        };
        let edits = edits.into_iter().map(OneOf::Left).collect();
        WorkspaceEdit {
            document_changes: Some(DocumentChanges::Edits(vec![TextDocumentEdit {
                text_document,
                edits,
            }])),
            ..WorkspaceEdit::default()
        }
    } else {
        WorkspaceEdit {
            changes: Some([(uri, edits)].into()),
            ..WorkspaceEdit::default()
        }
    })
}

/// Findings of a file. [`Json`](crate::lsp::documents::diagnostic_json::Json) writes the same.
pub(crate) fn diagnostics<'f>(
    agreed: Agreed,
    revision: &Revision,
    found: impl IntoIterator<Item = &'f ladder_analysis::Diagnostic>,
) -> Vec<Diagnostic> {
    let mut beside = Beside::new(revision);
    let ranges = Ranges::new(revision);
    found
        .into_iter()
        .map(|found| diagnostic(agreed, revision, &ranges, &mut beside, found))
        .collect()
}

/// So many places are looked up one by one; for more a table of all lines costs less.
const FEW: usize = 100;

/// What counts the lines and columns of findings.
pub(crate) struct Ranges<'r> {
    revision: &'r Revision,
    asked: Cell<usize>,
    many: OnceCell<Positions>,
}

impl<'r> Ranges<'r> {
    /// Of a text, for places of which nobody knows yet how many there are.
    pub(crate) fn new(revision: &'r Revision) -> Self {
        Ranges {
            revision,
            asked: Cell::new(0),
            many: OnceCell::new(),
        }
    }

    /// The lines and columns of a stretch.
    pub(crate) fn range(&self, place: TextRange) -> document::position::Range {
        self.asked.update(|asked| asked + 1);
        if self.asked.get() <= FEW {
            return self.revision.range(place);
        }
        self.many.get_or_init(|| self.revision.positions()).range(place)
    }
}

/// How much a finding counts, as the protocol says it.
pub(crate) fn severity(severity: Severity) -> DiagnosticSeverity {
    match severity {
        Severity::Error => DiagnosticSeverity::ERROR,
        Severity::Warning => DiagnosticSeverity::WARNING,
        Severity::Info => DiagnosticSeverity::INFORMATION,
    }
}

/// Whether a finding is about text without effect, which the client shows faded.
pub(crate) fn is_unnecessary(agreed: Agreed, found: &ladder_analysis::Diagnostic) -> bool {
    agreed.unnecessary_tag && UNNECESSARY.contains(&found.rule.name())
}

fn diagnostic(
    agreed: Agreed,
    revision: &Revision,
    ranges: &Ranges<'_>,
    beside: &mut Beside<'_>,
    found: &ladder_analysis::Diagnostic,
) -> Diagnostic {
    let mut message = found.message.clone();
    if let Some(help) = &found.help {
        let _ = write!(message, "\n{help}");
    }
    let mut related_information = None;
    if agreed.related_information {
        let own = uri(&revision.uri);
        let related = found.related.iter().filter_map(|related| {
            let location = match &related.file {
                None => Location {
                    uri: own.clone()?,
                    range: range(ranges.range(related.range)),
                },
                Some(file) => {
                    let (address, place) = beside.range(file, related.range)?;
                    Location {
                        uri: uri(&address)?,
                        range: range(place),
                    }
                }
            };
            Some(DiagnosticRelatedInformation {
                location,
                message: related.message.clone().into_owned(),
            })
        });
        related_information = Some(related.collect::<Vec<_>>()).filter(|related| !related.is_empty());
    } else {
        // A client that cannot link other places still gets to know of them.
        for related in &found.related {
            let (file, place) = match &related.file {
                None => ("", Some(ranges.range(related.range))),
                Some(file) => {
                    let place = beside.range(file, related.range);
                    (&**file, place.map(|(_, place)| place))
                }
            };
            let Some(place) = place else { continue };
            let line = place.start.line + 1;
            let comma = if file.is_empty() { "" } else { ", " };
            let _ = write!(message, "\n{file}{comma}line {line}: {}", related.message);
        }
    }
    let unnecessary = is_unnecessary(agreed, found);
    let titles: Vec<_> = found.fixes.iter().map(|fix| &fix.title).collect();
    Diagnostic {
        range: range(ranges.range(found.range)),
        severity: Some(severity(found.severity)),
        code: Some(NumberOrString::String(found.rule.name().to_owned())),
        code_description: None,
        source: Some("ladder".into()),
        message,
        related_information,
        tags: unnecessary.then(|| vec![DiagnosticTag::UNNECESSARY]),
        data: (agreed.diagnostic_data && !titles.is_empty()).then(|| json!({ "fixes": titles })),
    }
}
