//! A comparison for machines. The names of the members are documented; nothing may be renamed.

use super::settings::SettingsDiff;
use ladder_review::outline::{Entry, Outline};
use ladder_review::report::{Compared, names, reason, word};
use ladder_review::{Change, Verdict};
use serde::Serialize;

/// A file that is compared.
#[derive(Serialize)]
#[serde(untagged)]
pub(super) enum File<'c> {
    Program {
        old: Option<&'c str>,
        new: Option<&'c str>,
        same: usize,
        changes: Vec<Changed<'c>>,
    },
    Settings {
        old: Option<&'c str>,
        new: Option<&'c str>,
        lines: &'c [String],
    },
}

#[derive(Serialize)]
pub(super) struct Changed<'c> {
    change: &'static str,
    moved: bool,
    kind: &'static str,
    #[serde(skip_serializing_if = "str::is_empty")]
    place: &'c str,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    names: Vec<&'c str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    meaning: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<String>,
    old: Option<Form<'c>>,
    new: Option<Form<'c>>,
}

#[derive(Serialize)]
struct Form<'c> {
    line: usize,
    text: std::borrow::Cow<'c, str>,
}

impl<'c> File<'c> {
    pub(super) fn program(compared: &'c Compared<'c>) -> File<'c> {
        let comparison = &compared.comparison;
        let changes = comparison.changes.iter().filter(|change| change.is_change());
        let changed = |change: &Change<'c>| Changed {
            change: change.verdict.word(),
            moved: change.moved,
            kind: change.entry().kind.text(),
            place: &change.entry().place,
            names: names(change.entry()),
            meaning: change.meaning.as_ref().map(word),
            reason: reason(change),
            old: change.old.map(|entry| form(comparison.old, entry)),
            new: change.new.map(|entry| form(comparison.new, entry)),
        };
        let counts = comparison.counts();
        let same = Verdict::Same.text();
        File::Program {
            old: compared.old,
            new: compared.new,
            same: counts
                .iter()
                .find(|(what, _)| *what == same)
                .map_or(0, |(_, count)| *count),
            changes: changes.map(changed).collect(),
        }
    }

    pub(super) fn settings(diff: &'c SettingsDiff) -> File<'c> {
        File::Settings {
            old: diff.old.as_deref(),
            new: diff.new.as_deref(),
            lines: &diff.lines,
        }
    }
}

fn form<'c>(outline: &'c Outline, entry: &'c Entry) -> Form<'c> {
    Form {
        line: outline.line(entry),
        text: outline.text(entry.shown),
    }
}
