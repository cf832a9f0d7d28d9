//! From the server's own types to the protocol's.

use std::str::FromStr;

use tower_lsp::ls_types::{
    Diagnostic, DiagnosticSeverity, DocumentChanges, NumberOrString, OneOf,
    OptionalVersionedTextDocumentIdentifier, Position, Range, TextDocumentEdit, TextEdit, Uri, WorkspaceEdit,
};

use crate::document::{self, Revision};
use crate::lsp::session::agreed::Agreed;
use ladder_analysis::Severity;
use ladder_format::Edit;
use ladder_syntax::TextRange;

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
    let file = (
        uri(&revision.uri)?,
        Some(revision.version),
        edits(revision, our_edits),
    );
    Some(edit_of_files(agreed, [file]))
}

/// Edits of files as a change of the workspace: each file with the version that its edits are for, if it is open, for clients
/// that can check that.
pub(crate) fn edit_of_files(
    agreed: Agreed,
    files: impl IntoIterator<Item = (Uri, Option<i32>, Vec<TextEdit>)>,
) -> WorkspaceEdit {
    let files = files.into_iter();
    if !agreed.versioned_edits {
        return WorkspaceEdit {
            changes: Some(files.map(|(uri, _, edits)| (uri, edits)).collect()),
            ..WorkspaceEdit::default()
        };
    }
    let changes = files.map(|(uri, version, edits)| TextDocumentEdit {
        text_document: OptionalVersionedTextDocumentIdentifier { uri, version },
        edits: edits.into_iter().map(OneOf::Left).collect(),
    });
    WorkspaceEdit {
        document_changes: Some(DocumentChanges::Edits(changes.collect())),
        ..WorkspaceEdit::default()
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
