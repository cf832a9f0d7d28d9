//! A comparison for people: one file for each form.

pub mod html;
pub mod markdown;
pub mod text;

use crate::by_networks::is_harmless;
use crate::comparison::{Change, Comparison};
use crate::used::Used;
use crate::verdict::Verdict;
use crate::whole::{REFUTED, Whole, other_unread, told, unread_of};
use ladder_analysis::program::unread_note;
use std::collections::BTreeSet;

/// Two files that are compared, by the names that they go by.
#[derive(Debug)]
pub struct Compared<'c> {
    /// What the old one is called. None: there was none.
    pub old: Option<&'c str>,
    /// What the new one is called. None: there is none any more.
    pub new: Option<&'c str>,
    /// It is one file of two folders, under another name.
    pub renamed: bool,
    /// What changed.
    pub comparison: Comparison<'c>,
}

impl Compared<'_> {
    /// A file that is new, gone or renamed is a difference, whatever is in it.
    pub fn is_different(&self) -> bool {
        self.comparison.differs() || self.renamed || self.old.is_some() != self.new.is_some()
    }

    /// The file as it is called now, or was.
    pub fn name(&self) -> &str {
        self.new.or(self.old).unwrap_or_default()
    }
}

/// What is known of the whole programs, for who has read what changed in them: a sentence, and the rows of a run that shows it.
/// None: nothing, or nothing new.
pub fn of_whole(comparison: &Comparison<'_>) -> Option<(String, Vec<String>)> {
    match comparison.whole.as_ref()? {
        Whole::Same if comparison.renames.iter().any(|rename| rename.shown_as.is_some()) => Some((
            "the programs do the same in every run, but for the names".to_owned(),
            Vec::new(),
        )),
        // What each network says for itself needs no more words.
        Whole::Same
            if comparison.renames.is_empty()
                && comparison.uses.is_empty()
                && comparison.changes.iter().all(is_harmless) =>
        {
            None
        }
        Whole::Same => Some(("the programs do the same in every run".to_owned(), Vec::new())),
        Whole::Differs(run) => Some(told(run)),
        Whole::Refuted => Some((REFUTED.to_owned(), Vec::new())),
        // What has changed is not in the text: this is all that the report has of it.
        Whole::NotDecided(why)
            if !comparison.changes.iter().any(Change::is_change) || !other_unread(comparison).is_empty() =>
        {
            let told = "whether the programs do the same is not decided";
            Some((told.to_owned(), why.clone()))
        }
        Whole::Outputs(_) | Whole::NotDecided(_) => None,
    }
}

/// The names of the unread parts of both programs, each once.
pub fn unread(comparison: &Comparison<'_>) -> BTreeSet<String> {
    let parts = [comparison.old, comparison.new].map(unread_of);
    parts.into_iter().flatten().map(|part| part.name).collect()
}

/// What the report has on both programs before their changes, a line each.
fn notes(comparison: &Comparison<'_>) -> Vec<String> {
    let renames = comparison.renames.iter();
    let mut notes: Vec<String> = renames.map(|rename| format!("renamed: {rename}")).collect();
    match comparison.values() {
        0 => {}
        1 => notes.push("1 value differs; --values shows it".to_owned()),
        count => notes.push(format!("{count} values differ; --values shows them")),
    }
    let unread = unread(comparison);
    notes.extend(unread_note(unread.iter().map(String::as_str)));
    notes
}

/// The changes that are shown, each by itself.
pub fn shown<'c, 'o>(comparison: &'c Comparison<'o>) -> impl Iterator<Item = &'c Change<'o>> {
    let changes = comparison.changes.iter();
    changes.filter(|change| change.is_change() && change.verdict != Verdict::Value)
}

/// How many of each, as a sentence: `1 edited, 2 new, 7 the same`.
pub fn summary(comparison: &Comparison<'_>) -> String {
    let counts = comparison.counts();
    let counts = counts.iter().map(|(what, count)| match *what {
        "same" => format!("{count} the same"),
        what => format!("{count} {what}"),
    });
    let mut counts: Vec<String> = counts.collect();
    counts.extend(comparison.uses.iter().map(Used::to_string));
    if !comparison.renames.is_empty() {
        counts.push(format!("{} renamed", comparison.renames.len()));
    }
    if counts.is_empty() {
        "nothing in it".to_owned()
    } else {
        counts.join(", ")
    }
}
