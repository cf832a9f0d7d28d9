//! The conversion of a program in the first draft of the language, as a code action: the finding that it is one says what
//! to do at the command line.

use ladder_documents::{Analysis, Revision};
use ladder_notations::{CONVERSION, conversion_of_cplc_draft};
use tower_lsp::ls_types::{CodeAction, CodeActionDisabled, CodeActionKind};

use crate::lsp::finding::Findings;
use crate::lsp::session::agreed::Agreed;

/// The action for a text in the draft, with its edit; none in a build that does not read the draft.
pub(super) fn action(agreed: Agreed, revision: &Revision, analysis: &Analysis) -> Option<CodeAction> {
    let mut findings = Findings::of(agreed, revision);
    let found = analysis.findings().iter();
    let action = CodeAction {
        title: CONVERSION.to_owned(),
        kind: Some(CodeActionKind::QUICKFIX),
        diagnostics: Some(
            found
                .map(|found| findings.diagnostic(&found.diagnostic()))
                .collect(),
        ),
        ..CodeAction::default()
    };
    let conversion = conversion_of_cplc_draft(&revision.text(), &revision.format_options())?;
    Some(match conversion {
        Ok(fix) => CodeAction {
            is_preferred: Some(fix.is_safe()),
            edit: agreed.workspace_edit(revision, &fix.edits),
            ..action
        },
        Err(reason) => CodeAction {
            disabled: Some(CodeActionDisabled { reason }),
            ..action
        },
    })
}
