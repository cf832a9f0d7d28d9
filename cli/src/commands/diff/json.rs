//! A comparison for machines. The names of the members are documented; nothing may be renamed.

use super::settings::SettingsDiff;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_prover::{Which, scenario_of_difference};
use ladder_review::outline::{Entry, Outline};
use ladder_review::report::{Compared, shown, unread};
use ladder_review::whole::{REFUTED, Whole, told};
use ladder_review::words::{names, reason, word};
use ladder_review::{Change, Verdict};
use ladder_simulator::value_text;
use serde::Serialize;
use std::collections::BTreeSet;

/// A file that is compared.
#[derive(Serialize)]
#[serde(untagged)]
pub(super) enum File<'c> {
    Program {
        old: Option<&'c str>,
        new: Option<&'c str>,
        same: usize,
        #[serde(skip_serializing_if = "std::ops::Not::not")]
        renamed: bool,
        #[serde(skip_serializing_if = "Vec::is_empty")]
        renames: Vec<Renames<'c>>,
        #[serde(skip_serializing_if = "Option::is_none")]
        values: Option<usize>,
        #[serde(skip_serializing_if = "BTreeSet::is_empty")]
        unread: BTreeSet<String>,
        #[serde(skip_serializing_if = "Vec::is_empty")]
        uses: Vec<Uses<'c>>,
        changes: Vec<Changed<'c>>,
        #[serde(skip_serializing_if = "Option::is_none")]
        whole: Option<Box<WholePrograms<'c>>>,
    },
    Settings {
        old: Option<&'c str>,
        new: Option<&'c str>,
        lines: &'c [String],
    },
}

/// Something that has another name.
#[derive(Serialize)]
pub(super) struct Renames<'c> {
    kind: &'static str,
    old: &'c str,
    new: &'c str,
    places: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    shown_as: Option<&'static str>,
}

/// A file that is used, or a tag that another file declares, and is not the same on both sides.
#[derive(Serialize)]
pub(super) struct Uses<'c> {
    name: &'c str,
    difference: &'static str,
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
    #[serde(skip_serializing_if = "Option::is_none")]
    part: Option<&'c str>,
    text: std::borrow::Cow<'c, str>,
}

/// What is known of both programs.
#[derive(Serialize, Default)]
pub(super) struct WholePrograms<'c> {
    meaning: &'static str,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    reasons: Vec<String>,
    /// The scan after which they differ, from 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    scan: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    interval_ns: Option<i64>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    given: Vec<Given<'c>>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    differs: Vec<Differs<'c>>,
    /// What the old program does.
    #[serde(skip_serializing_if = "Option::is_none")]
    scenario: Option<String>,
}

#[derive(Serialize)]
struct Given<'c> {
    tag: &'c str,
    /// One for each scan.
    values: Vec<String>,
}

#[derive(Serialize)]
struct Differs<'c> {
    tag: &'c str,
    /// One for each scan.
    old: Vec<String>,
    new: Vec<String>,
}

fn whole(whole: &Whole) -> WholePrograms<'_> {
    let of = |meaning, reasons: &[String]| WholePrograms {
        meaning,
        reasons: reasons.to_vec(),
        ..WholePrograms::default()
    };
    let run = match whole {
        Whole::Same => return of("same", &[]),
        Whole::Outputs(names) => return of("other", names),
        Whole::NotDecided(reasons) => return of("unknown", reasons),
        Whole::Refuted => return of("refuted", &[REFUTED.to_owned()]),
        Whole::Differs(run) => run,
    };
    let given = run.given.iter().map(|row| Given {
        tag: &row.name,
        values: texts(&row.values, row.ty),
    });
    let differs = run.differs.iter().map(|row| Differs {
        tag: &row.name,
        old: texts(&row.old, row.ty),
        new: texts(&row.new, row.ty),
    });
    WholePrograms {
        meaning: "other",
        reasons: vec![told(run).0],
        scan: run.scans.checked_sub(1),
        interval_ns: Some(run.interval),
        given: given.collect(),
        differs: differs.collect(),
        scenario: scenario_of_difference("the programs differ", run, Which::Old),
    }
}

fn texts(values: &[Value], ty: Scalar) -> Vec<String> {
    values
        .iter()
        .map(|value| value_text::display(value, ty))
        .collect()
}

impl<'c> File<'c> {
    pub(super) fn program(compared: &'c Compared<'c>) -> File<'c> {
        let comparison = &compared.comparison;
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
            renamed: compared.renamed,
            renames: comparison
                .renames
                .iter()
                .map(|rename| Renames {
                    kind: rename.kind,
                    old: &rename.was,
                    new: &rename.is,
                    places: rename.places,
                    shown_as: rename.shown_as,
                })
                .collect(),
            values: Some(comparison.values()).filter(|count| *count > 0),
            unread: unread(comparison),
            uses: comparison
                .uses
                .iter()
                .map(|used| Uses {
                    name: &used.name,
                    difference: used.difference.word(),
                })
                .collect(),
            changes: shown(comparison).map(changed).collect(),
            whole: comparison.whole.as_ref().map(|it| Box::new(whole(it))),
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
        part: entry.part.as_deref().filter(|part| !part.is_empty()),
        text: outline.text(entry.shown),
    }
}
