//! `textDocument/codeAction`: the fixes of the problems in the range, ways to switch their rules off, refactorings of what is
//! selected, and all sure fixes of the file at once. What an action does to the text is worked out when it is offered only for clients that
//! cannot ask for it later (`codeAction/resolve`): to put the drawing straight takes the whole text.

use std::sync::Arc;

use ladder_analysis::Cancel;
use ladder_documents::other_files::OtherFiles;
use ladder_documents::{Analysis, Revision};
use ladder_ide::{Action, ActionKind};
use ladder_syntax::{TextRange, TextSize};
use serde::{Deserialize, Serialize};
use tower_lsp::jsonrpc::{Error, Result};
use tower_lsp::ls_types::{
    CodeAction, CodeActionContext, CodeActionDisabled, CodeActionKind, CodeActionOrCommand, CodeActionParams,
    CodeActionResponse, Command, WorkspaceEdit,
};

use super::asked::Asked;
use super::of_scenarios::scenarios_at;
use super::{conversion, rename, scenario_actions, switch_off};
use crate::lsp::transport::blocking::blocking;
use crate::lsp::{
    convert,
    finding::Findings,
    session::{agreed::Agreed, commands::RENAME, shared::Shared},
};

/// The kind of the action that applies every sure fix of a file.
pub(crate) const FIX_ALL: CodeActionKind = CodeActionKind::new("source.fixAll.ladder");

/// The kinds of actions, and how the protocol calls them.
pub(crate) static KINDS: [(ActionKind, CodeActionKind); 5] = [
    (ActionKind::QuickFix, CodeActionKind::QUICKFIX),
    (ActionKind::Extract, CodeActionKind::REFACTOR_EXTRACT),
    (ActionKind::Inline, CodeActionKind::REFACTOR_INLINE),
    (ActionKind::Rewrite, CodeActionKind::REFACTOR_REWRITE),
    (ActionKind::FixAll, FIX_ALL),
];

/// What an action carries, so that its edits can be asked for later.
#[derive(Debug, Serialize, Deserialize)]
struct Data {
    uri: String,
    version: i32,
    start: u32,
    end: u32,
}

pub(crate) async fn code_action(
    shared: &Arc<Shared>,
    params: CodeActionParams,
) -> Result<Option<CodeActionResponse>> {
    if let Some(scenarios) = scenarios_at(shared, &params.text_document.uri) {
        return scenario_actions::code_action(shared, scenarios, params).await;
    }
    let Some(revision) = shared.documents.get(params.text_document.uri.as_str()) else {
        return Ok(None);
    };
    let agreed = shared.agreed();
    let next_to = Arc::clone(shared);
    blocking(&*shared.host, move |cancel| {
        let shared = next_to;
        let analysis = revision.analysis()?;
        let asked = asked(&shared, &revision, cancel)?;
        let place = |range| {
            let range = convert::our_range(range);
            let (start, end) = (revision.offset(range.start), revision.offset(range.end));
            TextRange::new(start.min(end), end.max(start))
        };
        let range = place(params.range);
        // An editor shows the problems of a whole line, and asks about them wherever on it the cursor is.
        let shown = params.context.diagnostics.iter().map(|it| place(it.range));
        let problems = shown.fold(range, TextRange::cover);
        let offered = analysis.actions(range, problems, |kind| wanted(&params.context, &name(kind)));
        // Put together once for all of them; a client that asks for edits later asks for one.
        let text = (!agreed.resolves_edits).then(|| revision.text());
        let shown = offered
            .iter()
            .filter(|action| action.disabled.is_none() || agreed.disabled_actions)
            .map(|action| offer(agreed, &asked, analysis, range, action, text.as_deref()));
        let conversion = analysis
            .whole()
            .cplc_draft()
            .filter(|place| {
                wanted(&params.context, &name(ActionKind::QuickFix)) && place.intersect(problems).is_some()
            })
            .and_then(|_| conversion::action(agreed, &revision, analysis))
            .filter(|action| action.disabled.is_none() || agreed.disabled_actions);
        let (off, properties) = if wanted(&params.context, &name(ActionKind::QuickFix)) {
            (
                switch_off::actions(&shared, agreed, &revision, analysis, problems),
                scenario_actions::of_program(&shared, &revision, &asked.context, range),
            )
        } else {
            (Vec::new(), Vec::new())
        };
        let others = conversion.into_iter().chain(off).chain(properties);
        Some(shown.chain(others.map(CodeActionOrCommand::CodeAction)).collect())
    })
    .await
}

/// `codeAction/resolve`: the edits of an action that was offered without them.
pub(crate) async fn resolve(shared: &Arc<Shared>, mut action: CodeAction) -> Result<CodeAction> {
    let data = action
        .data
        .clone()
        .and_then(|data| serde_json::from_value::<Data>(data).ok());
    let Some(data) = data.filter(|_| action.edit.is_none()) else {
        return Ok(action);
    };
    let revision = shared.documents.get(&data.uri);
    let Some(revision) = revision.filter(|revision| revision.version == data.version) else {
        return Err(Error::content_modified());
    };
    let agreed = shared.agreed();
    let next_to = Arc::clone(shared);
    blocking(&*shared.host, move |cancel| {
        let range = within(&revision, &data);
        if let (Some(analysis), Some(asked)) = (revision.analysis(), asked(&next_to, &revision, cancel)) {
            let offered = analysis.actions(range, range, |kind| Some(name(kind)) == action.kind);
            let same = offered.into_iter().find(|offered| offered.title == action.title);
            action.edit = same.and_then(|same| edit(agreed, &asked, analysis, &same, &revision.text()));
        }
        action
    })
    .await
}

/// The document with the files next to it: some actions change scenarios too.
fn asked(shared: &Shared, revision: &Arc<Revision>, cancel: &Cancel) -> Option<Asked> {
    Some(Asked {
        revision: Arc::clone(revision),
        context: Arc::clone(revision.context()?),
        elsewhere: OtherFiles::of(revision, &shared.documents, &shared.companions, cancel),
        knows_others: true,
        opens_library: shared.agreed().library_blocks,
    })
}

/// How the protocol calls a kind.
fn name(kind: ActionKind) -> CodeActionKind {
    let found = KINDS.iter().find(|(ours, _)| *ours == kind);
    found.map_or(CodeActionKind::EMPTY, |(_, name)| name.clone())
}

/// The range of an action, which has been with the client meanwhile.
fn within(revision: &Revision, data: &Data) -> TextRange {
    let len = revision.len() as u32;
    let end = data.end.min(len);
    TextRange::new(TextSize::new(data.start.min(end)), TextSize::new(end))
}

/// Whether the client asks for actions of this kind: `source` asks for `source.fixAll.ladder` too.
pub(super) fn wanted(context: &CodeActionContext, kind: &CodeActionKind) -> bool {
    let Some(only) = &context.only else { return true };
    only.iter().any(|asked| {
        let rest = kind.as_str().strip_prefix(asked.as_str());
        rest.is_some_and(|rest| asked.as_str().is_empty() || rest.is_empty() || rest.starts_with('.'))
    })
}

/// An action, with its edits if there is a `text` to make them of; without one the client asks for them later.
fn offer(
    agreed: Agreed,
    asked: &Asked,
    analysis: &Analysis,
    range: TextRange,
    action: &Action,
    text: Option<&str>,
) -> CodeActionOrCommand {
    let revision = &*asked.revision;
    let later = text.is_none() && action.disabled.is_none();
    let finding = action
        .finding
        .and_then(|finding| analysis.findings().get(finding));
    // A fix is found again where its problem is.
    let range = finding.map_or(range, |finding| finding.range);
    let data = later.then(|| {
        serde_json::to_value(Data {
            uri: revision.uri.to_string(),
            version: revision.version,
            start: range.start().into(),
            end: range.end().into(),
        })
    });
    let now = text.filter(|_| action.disabled.is_none());
    let made_up = action.made_up.as_ref().filter(|_| agreed.renames);
    let command = made_up.map(|name| Command {
        title: format!("Rename {name}"),
        command: RENAME.to_owned(),
        arguments: Some(vec![revision.uri.to_string().into(), name.clone().into()]),
    });
    CodeActionOrCommand::CodeAction(CodeAction {
        title: action.title.clone(),
        kind: Some(name(action.kind)),
        diagnostics: finding
            .map(|finding| vec![Findings::of(agreed, revision).diagnostic(&finding.diagnostic())]),
        command,
        edit: now.and_then(|text| edit(agreed, asked, analysis, action, text)),
        is_preferred: finding.map(|_| action.preferred),
        disabled: action
            .disabled
            .clone()
            .map(|reason| CodeActionDisabled { reason }),
        data: data.and_then(std::result::Result::ok),
    })
}

/// The edits of an action. None: a file would change that is not ladder text.
fn edit(
    agreed: Agreed,
    asked: &Asked,
    analysis: &Analysis,
    action: &Action,
    text: &str,
) -> Option<WorkspaceEdit> {
    let options = asked.revision.format_options();
    let files = analysis.everywhere(action, text, &options, &asked.elsewhere);
    Some(rename::edit(asked, files, agreed).ok()?.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_kind_asks_for_its_sub_kinds() {
        let asks = |only: &'static str| {
            let context = CodeActionContext {
                only: Some(vec![CodeActionKind::new(only)]),
                ..CodeActionContext::default()
            };
            [
                wanted(&context, &CodeActionKind::QUICKFIX),
                wanted(&context, &CodeActionKind::REFACTOR_REWRITE),
                wanted(&context, &FIX_ALL),
            ]
        };
        assert_eq!(asks("quickfix"), [true, false, false]);
        assert_eq!(asks("source"), [false, false, true]);
        assert_eq!(asks("source.fixAll"), [false, false, true]);
        assert_eq!(asks("source.fix"), [false, false, false]);
        assert_eq!(asks(""), [true, true, true]);
        assert_eq!(asks("refactor"), [false, true, false]);
        assert_eq!(asks("refactor.rewrite"), [false, true, false]);
        assert_eq!(asks("refactor.inline"), [false, false, false]);
        assert!(wanted(&CodeActionContext::default(), &CodeActionKind::QUICKFIX));
    }
}
