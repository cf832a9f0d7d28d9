//! From the server's own types to the protocol's.

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

/// Findings of a file.
pub(crate) fn diagnostics<'f>(
    agreed: Agreed,
    revision: &Revision,
    found: impl IntoIterator<Item = &'f ladder_analysis::Diagnostic>,
) -> Vec<Diagnostic> {
    let mut beside = Beside::new(revision);
    let found: Vec<_> = found.into_iter().collect();
    let ranges = if found.len() > FEW {
        Ranges::Many(revision.positions())
    } else {
        Ranges::Few(revision)
    };
    found
        .into_iter()
        .map(|found| diagnostic(agreed, revision, &ranges, &mut beside, found))
        .collect()
}

/// For so many findings each place is looked up by itself; for more a table of all lines costs less.
const FEW: usize = 50;

/// What counts the lines and columns of findings.
enum Ranges<'r> {
    Few(&'r Revision),
    Many(Positions),
}

impl Ranges<'_> {
    fn range(&self, place: TextRange) -> document::position::Range {
        match self {
            Ranges::Few(revision) => revision.range(place),
            Ranges::Many(positions) => positions.range(place),
        }
    }
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
    let unnecessary = agreed.unnecessary_tag && UNNECESSARY.contains(&found.rule.name());
    let titles: Vec<_> = found.fixes.iter().map(|fix| &fix.title).collect();
    Diagnostic {
        range: range(ranges.range(found.range)),
        severity: Some(match found.severity {
            Severity::Error => DiagnosticSeverity::ERROR,
            Severity::Warning => DiagnosticSeverity::WARNING,
            Severity::Info => DiagnosticSeverity::INFORMATION,
        }),
        code: Some(NumberOrString::String(found.rule.name().to_owned())),
        code_description: None,
        source: Some("ladder".into()),
        message,
        related_information,
        tags: unnecessary.then(|| vec![DiagnosticTag::UNNECESSARY]),
        data: (agreed.diagnostic_data && !titles.is_empty()).then(|| json!({ "fixes": titles })),
    }
}
