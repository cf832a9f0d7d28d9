//! Edits as changes of the workspace, as the client takes them.

use ladder_documents::Revision;
use ladder_format::Edit;
use tower_lsp::ls_types::{
    DocumentChanges, OneOf, OptionalVersionedTextDocumentIdentifier, TextDocumentEdit, TextEdit, Uri,
    WorkspaceEdit,
};

use super::agreed::Agreed;
use crate::lsp::convert;

impl Agreed {
    /// The edits as a change of the workspace, bound to the version that they are for where the client can check
    /// that.
    pub(crate) fn workspace_edit(self, revision: &Revision, edits: &[Edit]) -> Option<WorkspaceEdit> {
        let file = (
            convert::uri(&revision.uri)?,
            Some(revision.version),
            convert::edits(revision, edits),
        );
        Some(self.edit_of_files([file]))
    }

    /// Edits of files as a change of the workspace: each file with the version that its edits are for, if it is open, for clients
    /// that can check that.
    pub(crate) fn edit_of_files(
        self,
        files: impl IntoIterator<Item = (Uri, Option<i32>, Vec<TextEdit>)>,
    ) -> WorkspaceEdit {
        let files = files.into_iter();
        if !self.versioned_edits {
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
}
