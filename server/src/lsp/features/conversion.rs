//! The conversion of a program in the first draft of the language, as a code action: the finding that it is one says what
//! to do at the command line.

use ladder_analysis::cplc_draft_beginning;
use ladder_notations::conversion_of_cplc_draft;
use ladder_syntax::TextRange;
use tower_lsp::ls_types::{CodeAction, CodeActionDisabled, CodeActionKind};

use crate::document::Revision;
use crate::language::Analysis;
use crate::lsp::finding::Findings;
use crate::lsp::{convert, session::agreed::Agreed};

/// Where the text turns out to be in the draft, if that is what is wrong with it.
pub(super) fn place(analysis: &Analysis) -> Option<TextRange> {
    let whole = analysis.whole();
    whole
        .has_errors()
        .then(|| cplc_draft_beginning(&whole.context.parse))?
}

/// The action for a text in the draft, with its edit; none in a build that does not read the draft.
pub(super) fn action(agreed: Agreed, revision: &Revision, analysis: &Analysis) -> Option<CodeAction> {
    let mut findings = Findings::of(agreed, revision);
    let found = analysis.findings().iter();
    let action = CodeAction {
        title: "Convert to ladder text".to_owned(),
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
            edit: convert::workspace_edit(agreed, revision, &fix.edits),
            ..action
        },
        Err(error) => CodeAction {
            disabled: Some(CodeActionDisabled {
                reason: format!("it cannot be converted yet: {error}"),
            }),
            ..action
        },
    })
}
