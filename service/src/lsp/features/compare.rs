//! `ladder.compare`: what changed in an open program since an earlier text. `docs/protocol.md` shows the messages.

use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::Duration;

use ladder_analysis::Cancel;
use ladder_documents::{Lines, Revision};
use ladder_live::{Failure, argument_of};
use ladder_picture::Theme;
use ladder_review::outline::{Entry, why_not};
use ladder_review::rename::renamed;
use ladder_review::report::{html, summary};
use ladder_review::words::{heading, names, reason, word};
use ladder_review::{Change, Comparison, Outline, compare_renamed};
use ladder_syntax::{MAX_OPEN_BYTES, MAX_OPEN_LINES};
use ladder_workspace::shown;
use serde::{Deserialize, Serialize};
use tower_lsp::jsonrpc::{Error, Result};
use tower_lsp::ls_types::{ExecuteCommandParams, LSPAny};

use crate::lsp::answers::{error, json};
use crate::lsp::session::shared::Shared;
use crate::lsp::transport::blocking::blocking;

/// The command.
pub(crate) const COMPARE: &str = "ladder.compare";

pub(crate) async fn execute(shared: &Arc<Shared>, params: ExecuteCommandParams) -> Result<LSPAny> {
    let asked: Compare = argument_of(COMPARE, params.arguments).map_err(error)?;
    let failed = |message: String| error(Failure::Failed(message));
    let revision = shared.documents.get(&asked.uri);
    let revision = revision.ok_or_else(|| failed(format!("{} is not open in the editor", asked.uri)))?;
    let (of, documents) = (revision.clone(), Arc::clone(&shared.documents));
    let compared = blocking(&*shared.host, move |cancel| {
        let (cancel, shown) = (cancel.clone(), of.clone());
        let cancel = Cancel::when(move || cancel.is_cancelled() || !documents.shows(&shown));
        compare_with(&of, &asked, &cancel)
    })
    .await?;
    // What it says is about lines of that text.
    if !shared.documents.shows(&revision) {
        return Err(Error::content_modified());
    }
    json(&compared.ok_or_else(|| failed(format!("{} is too large to be compared", revision.name())))?)
}

/// How long may be asked what edited networks do.
const TIME: Duration = Duration::from_secs(5);

/// The argument of `ladder.compare`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Compare {
    /// The program, which must be open.
    pub uri: String,
    /// The earlier text.
    pub base: String,
    /// The drawings of what changed are wanted, in these colours.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub drawings: Option<CompareTheme>,
}

/// The colours of drawings.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub enum CompareTheme {
    /// Dark on light.
    Light,
    /// Light on dark.
    Dark,
}

/// The answer to `ladder.compare`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct ComparedTexts {
    /// The program.
    pub uri: String,
    /// The version of its text.
    pub version: i32,
    /// How many of each there are, in words.
    pub summary: String,
    /// What is different, from top to bottom.
    pub changes: Vec<Changed>,
    /// The style sheet of the drawings.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub style: Option<String>,
}

/// A network, declaration or comment that is not as it was.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Changed {
    /// `edited`, `redrawn`, `commented`, `new`, `gone`, or `same` of what has only moved.
    pub change: String,
    /// Whether it is elsewhere among the others.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub moved: bool,
    /// `network`, `declaration` and so on.
    pub kind: String,
    /// The tags that it writes, or the names that it declares.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub names: Vec<String>,
    /// Of an edited network `same`, `other`, `declared` or `unknown`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub meaning: Option<String>,
    /// The values that show another meaning, or why it is not known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
    /// What happened to it and where, in words.
    pub title: String,
    /// Its first line in the program; of what is gone the line above which it was.
    pub line: u32,
    /// Its lines in the program.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub new: Option<Lines>,
    /// Its lines in the earlier text.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub old: Option<Lines>,
    /// Both forms next to each other, an HTML element.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub drawing: Option<String>,
}

/// Compares; once it is cancelled, no more than the texts. None: one of them is too large. For a blocking thread.
pub(crate) fn compare_with(revision: &Revision, asked: &Compare, cancel: &Cancel) -> Option<ComparedTexts> {
    let base = &asked.base;
    let base_fits = base.len() <= MAX_OPEN_BYTES && base.lines().count() <= MAX_OPEN_LINES;
    if !base_fits || !revision.fits() {
        return None;
    }
    // Both among the other files as they are now: what changed in those is reported where they are compared.
    let outline = |text: &str| {
        let (analysis, linked) = revision.earlier(text);
        let context = Arc::clone(&analysis.context);
        let program = linked
            .map(|linked| linked.program)
            .map_err(|not_whole| why_not(&not_whole, &context.name, str::to_owned));
        Outline::among(context, program, BTreeMap::new())
    };
    let (mut old, new) = (outline(base), outline(&revision.text()));
    let mut renames = Vec::new();
    if let Some(renamed) = renamed(&old, &new) {
        let with_new_names = outline(&renamed.text);
        // Another file may use the old name.
        if with_new_names.runs() || !old.runs() {
            (old, renames) = (with_new_names, renamed.renames);
        }
    }
    let mut comparison = compare_renamed(&old, &new, renames);
    comparison.decide(TIME, cancel);
    let drawings = asked.drawings.filter(|_| !cancel.is_cancelled());
    let drawn = drawings.map(|_| html::sections(&comparison));
    let mut drawn = drawn.into_iter().flatten();
    let mut changes = Vec::new();
    for (at, change) in comparison.changes.iter().enumerate() {
        if change.is_change() {
            let drawing = drawn.next().map(|html| shown::text(&html).into_owned());
            changes.push(changed(&comparison, at, change, drawing));
        }
    }
    Some(ComparedTexts {
        uri: revision.uri.to_string(),
        version: revision.version,
        summary: summary(&comparison),
        changes,
        style: drawings.map(|theme| {
            html::style(match theme {
                CompareTheme::Light => Theme::Light,
                CompareTheme::Dark => Theme::Dark,
            })
        }),
    })
}

fn changed(comparison: &Comparison<'_>, at: usize, change: &Change<'_>, drawing: Option<String>) -> Changed {
    let new = change.new.map(|entry| lines(comparison.new, entry));
    // What is gone was above what follows it.
    let next = comparison.changes[at..].iter().find_map(|change| change.new);
    let line = match next {
        Some(next) => comparison.new.line(next),
        None => comparison.new.context.line_number(comparison.new.end.end()),
    };
    Changed {
        change: change.verdict.word().to_owned(),
        moved: change.moved,
        kind: change.entry().kind.text().to_owned(),
        names: names(change.entry()).into_iter().map(str::to_owned).collect(),
        meaning: change.meaning.as_ref().map(|meaning| word(meaning).to_owned()),
        reason: reason(change),
        title: heading(comparison, change),
        line: line as u32 - 1,
        new,
        old: change.old.map(|entry| lines(comparison.old, entry)),
        drawing,
    }
}

/// The lines of an entry without what is above it.
fn lines(outline: &Outline, entry: &Entry) -> Lines {
    let last = entry.own.end().checked_sub(1.into());
    let last = last.unwrap_or_default().max(entry.own.start());
    Lines {
        first: outline.line(entry) as u32 - 1,
        last: outline.context.line_number(last) as u32 - 1,
    }
}
