//! A rule is switched off in the `ladder.toml` above a program, as a code action on each of its findings.

use std::collections::BTreeSet;

use ladder_analysis::Rule;
use ladder_documents::address::uri_of;
use ladder_documents::{Analysis, Revision, position};
use ladder_syntax::TextRange;
use ladder_workspace::Settings;
use ropey::Rope;
use tower_lsp::ls_types::{CodeAction, CodeActionKind, TextEdit, Uri, WorkspaceEdit};

use crate::lsp::convert;
use crate::lsp::finding::Findings;
use crate::lsp::session::{agreed::Agreed, shared::Shared};

/// The settings file above a program, as the client has it.
struct SettingsText {
    path: std::path::PathBuf,
    uri: Uri,
    text: String,
    version: Option<i32>,
}

impl SettingsText {
    fn above(shared: &Shared, revision: &Revision) -> Option<SettingsText> {
        let file = shared.neighbours.settings_file(&revision.place()?.path)?;
        let address = uri_of(&file.path);
        // What is open counts as it is shown, saved or not.
        let open = shared.companions.get(&address);
        Some(SettingsText {
            path: file.path.clone(),
            uri: convert::uri(&address)?,
            text: open
                .as_ref()
                .map_or_else(|| file.text.clone(), |open| open.text()),
            version: open.map(|open| open.version),
        })
    }

    fn without(&self, agreed: Agreed, rule: Rule) -> Option<WorkspaceEdit> {
        let edit = Settings::switch_off(&self.path, &self.text, rule)?;
        let rope = Rope::from_str(&self.text);
        let edit = TextEdit {
            range: convert::range(position::range(&rope, agreed.encoding, edit.range.into())),
            new_text: edit.text,
        };
        Some(agreed.edit_of_files([(self.uri.clone(), self.version, vec![edit])]))
    }
}

/// One for each rule that found something in a range. None without a `ladder.toml`: where one is made, it alone decides about
/// the layout and the simulation too.
pub(super) fn actions(
    shared: &Shared,
    agreed: Agreed,
    revision: &Revision,
    analysis: &Analysis,
    problems: TextRange,
) -> Vec<CodeAction> {
    let found = || {
        let touched = |range: TextRange| range.intersect(problems).is_some();
        let findings = analysis.findings().iter();
        findings.filter(move |found| touched(found.range) && found.rule.may_be_switched_off())
    };
    let rules: BTreeSet<Rule> = found().map(|found| found.rule).collect();
    let settings = (!rules.is_empty()).then(|| SettingsText::above(shared, revision));
    let Some(settings) = settings.flatten() else {
        return Vec::new();
    };
    let of_rule = |rule: Rule| {
        let edit = settings.without(agreed, rule)?;
        let mut findings = Findings::of(agreed, revision);
        let about = found().filter(|found| found.rule == rule);
        Some(CodeAction {
            title: format!("Switch `{}` off in ladder.toml", rule.name()),
            kind: Some(CodeActionKind::QUICKFIX),
            diagnostics: Some(
                about
                    .map(|found| findings.diagnostic(&found.diagnostic()))
                    .collect(),
            ),
            edit: Some(edit),
            ..CodeAction::default()
        })
    };
    rules.into_iter().filter_map(of_rule).collect()
}
