//! `textDocument/codeAction`: the fixes of the problems in the range, and all sure fixes of the file at once.

use std::collections::BTreeMap;
use std::sync::Arc;

use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{
    CodeAction, CodeActionContext, CodeActionKind, CodeActionOrCommand, CodeActionParams, CodeActionResponse,
};

use super::blocking::blocking;
use super::capabilities::{Agreed, FIX_ALL};
use super::convert;
use super::shared::Shared;
use crate::document::Revision;
use crate::language::Analysis;
use ladder_analysis::{Diagnostic, Fix};
use ladder_format::Edit;
use ladder_syntax::TextSize;

pub(super) async fn code_action(
    shared: &Arc<Shared>,
    params: CodeActionParams,
) -> Result<Option<CodeActionResponse>> {
    let Some(revision) = shared.documents.get(params.text_document.uri.as_str()) else {
        return Ok(None);
    };
    let agreed = shared.agreed();
    blocking(move |_| {
        let analysis = revision.analysis()?;
        let problems = analysis.diagnostics();
        let range = convert::our_range(params.range);
        let (start, end) = (revision.offset(range.start), revision.offset(range.end));
        let mut actions = Vec::new();
        if wanted(&params.context, &CodeActionKind::QUICKFIX) {
            let touched = problems
                .iter()
                .filter(|problem| problem.range.start() <= end && start <= problem.range.end());
            actions.extend(touched.flat_map(|problem| quick_fixes(agreed, &revision, analysis, problem)));
        }
        if wanted(&params.context, &FIX_ALL) {
            actions.extend(fix_all(agreed, &revision, analysis));
        }
        Some(actions)
    })
    .await
}

/// Whether the client asks for actions of this kind: `source` asks for `source.fixAll.ladder` too.
fn wanted(context: &CodeActionContext, kind: &CodeActionKind) -> bool {
    let Some(only) = &context.only else { return true };
    only.iter().any(|asked| {
        let rest = kind.as_str().strip_prefix(asked.as_str());
        rest.is_some_and(|rest| asked.as_str().is_empty() || rest.is_empty() || rest.starts_with('.'))
    })
}

fn quick_fixes(
    agreed: Agreed,
    revision: &Revision,
    analysis: &Analysis,
    problem: &Diagnostic,
) -> Vec<CodeActionOrCommand> {
    let diagnostic = convert::diagnostic(agreed, revision, problem);
    let action = |(nth, fix): (usize, &Fix)| {
        CodeActionOrCommand::CodeAction(CodeAction {
            title: fix.title.clone(),
            kind: Some(CodeActionKind::QUICKFIX),
            diagnostics: Some(vec![diagnostic.clone()]),
            edit: convert::workspace_edit(agreed, revision, &analysis.mend(fix.edits.clone())),
            is_preferred: Some(nth == 0),
            ..CodeAction::default()
        })
    };
    problem.fixes.iter().enumerate().map(action).collect()
}

/// The first fix of every problem, as far as they do not touch each other: the rest is for the next round.
fn first_fixes(problems: &[Diagnostic]) -> Vec<Edit> {
    let mut edits: BTreeMap<TextSize, Edit> = BTreeMap::new();
    for fix in problems.iter().filter_map(|problem| problem.fixes.first()) {
        // Those taken do not touch each other, so only the last one that begins before the end can touch.
        let touches = |new: &Edit| {
            let before = edits.range(..=new.range.end()).next_back();
            before.is_some_and(|(_, old)| new.range.start() <= old.range.end())
        };
        if !fix.edits.iter().any(touches) {
            edits.extend(fix.edits.iter().map(|edit| (edit.range.start(), edit.clone())));
        }
    }
    edits.into_values().collect()
}

fn fix_all(agreed: Agreed, revision: &Revision, analysis: &Analysis) -> Option<CodeActionOrCommand> {
    let edits = first_fixes(analysis.diagnostics());
    if edits.is_empty() {
        return None;
    }
    let edits = analysis.mend(edits);
    Some(CodeActionOrCommand::CodeAction(CodeAction {
        title: "Apply all fixes".into(),
        kind: Some(FIX_ALL),
        edit: convert::workspace_edit(agreed, revision, &edits),
        ..CodeAction::default()
    }))
}

#[cfg(test)]
mod tests {
    use ladder_analysis::Rule;
    use ladder_syntax::TextRange;

    use super::*;

    /// The texts that "Apply all fixes" puts in for findings with these fixes, each an edit.
    fn all_fixes(fixes: &[(u32, u32, &str)]) -> Vec<String> {
        let finding = |&(start, end, text): &(u32, u32, &str)| {
            let range = TextRange::new(start.into(), end.into());
            Diagnostic::new(Rule::MissingWire, range, "").fix("", range, text)
        };
        let findings: Vec<_> = fixes.iter().map(finding).collect();
        first_fixes(&findings).into_iter().map(|edit| edit.text).collect()
    }

    #[test]
    fn fixes_that_touch_each_other_are_not_made_together() {
        assert_eq!(
            all_fixes(&[(0, 2, "first"), (4, 6, "second")]),
            ["first", "second"]
        );
        assert_eq!(
            all_fixes(&[(4, 6, "second"), (0, 2, "first")]),
            ["first", "second"],
            "in the order of the text"
        );
        assert_eq!(
            all_fixes(&[(0, 4, "first"), (2, 6, "across"), (8, 9, "third")]),
            ["first", "third"]
        );
        assert_eq!(all_fixes(&[(3, 3, "first"), (3, 3, "same place")]), ["first"]);
        assert_eq!(all_fixes(&[(0, 3, "first"), (3, 5, "right behind")]), ["first"]);
        assert_eq!(all_fixes(&[]), Vec::<String>::new());
    }

    #[test]
    fn a_kind_asks_for_its_sub_kinds() {
        let asks = |only: &'static str| {
            let context = CodeActionContext {
                only: Some(vec![CodeActionKind::new(only)]),
                ..CodeActionContext::default()
            };
            [
                wanted(&context, &CodeActionKind::QUICKFIX),
                wanted(&context, &FIX_ALL),
            ]
        };
        assert_eq!(asks("quickfix"), [true, false]);
        assert_eq!(asks("source"), [false, true]);
        assert_eq!(asks("source.fixAll"), [false, true]);
        assert_eq!(asks("source.fix"), [false, false]);
        assert_eq!(asks(""), [true, true]);
        assert_eq!(asks("refactor"), [false, false]);
        assert!(wanted(&CodeActionContext::default(), &CodeActionKind::QUICKFIX));
    }
}
