//! From the server's own types to the protocol's.

use std::str::FromStr;

use tower_lsp::ls_types::{Diagnostic, DiagnosticSeverity, NumberOrString, Position, Range, TextEdit, Uri};

use ladder_analysis::Severity;
use ladder_documents::Revision;
use ladder_format::Edit;
use ladder_syntax::TextRange;

pub(crate) fn position(position: ladder_documents::Position) -> Position {
    Position {
        line: position.line,
        character: position.character,
    }
}

pub(crate) fn range(range: ladder_documents::Range) -> Range {
    Range {
        start: position(range.start),
        end: position(range.end),
    }
}

pub(crate) fn our_position(position: Position) -> ladder_documents::Position {
    ladder_documents::Position {
        line: position.line,
        character: position.character,
    }
}

pub(crate) fn our_range(range: Range) -> ladder_documents::Range {
    ladder_documents::Range {
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

/// How much a finding counts, as the protocol says it.
pub(crate) fn severity(severity: Severity) -> DiagnosticSeverity {
    match severity {
        Severity::Error => DiagnosticSeverity::ERROR,
        Severity::Warning => DiagnosticSeverity::WARNING,
        Severity::Info => DiagnosticSeverity::INFORMATION,
    }
}

/// A diagnostic with nothing but its message: about a text that is not ladder text, or a whole file. What the rules find is
/// put together in [`finding`](super::finding).
pub(crate) fn diagnostic(range: Range, severity: Severity, code: &str, message: String) -> Diagnostic {
    Diagnostic {
        range,
        severity: Some(self::severity(severity)),
        code: Some(NumberOrString::String(code.to_owned())),
        source: Some("ladder".into()),
        message,
        ..Diagnostic::default()
    }
}
