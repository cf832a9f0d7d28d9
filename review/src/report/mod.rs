//! A comparison for people: one file for each form.

pub mod html;
pub mod markdown;
pub mod text;

use crate::comparison::{Change, Comparison};
use crate::outline::{Entry, Kind};
use crate::whole::{Whole, is_harmless, said};
use ladder_prover::Meaning;

/// Two files that are compared, by the names that they go by.
#[derive(Debug)]
pub struct Compared<'c> {
    /// What the old one is called. None: there was none.
    pub old: Option<&'c str>,
    /// What the new one is called. None: there is none any more.
    pub new: Option<&'c str>,
    /// What changed.
    pub comparison: Comparison<'c>,
}

impl Compared<'_> {
    /// The file as it is called now, or was.
    pub fn name(&self) -> &str {
        self.new.or(self.old).unwrap_or_default()
    }
}

/// What happened to an entry and where, on one line: `edited network, line 12 (was line 10), writes run`.
pub fn heading(comparison: &Comparison<'_>, change: &Change<'_>) -> String {
    let entry = change.entry();
    let mut heading = String::new();
    match (change.moved, change.verdict) {
        (true, crate::Verdict::Same) => heading.push_str("moved"),
        (true, verdict) => heading.push_str(&format!("moved, {}", verdict.text())),
        (false, verdict) => heading.push_str(verdict.text()),
    }
    heading.push_str(match &change.meaning {
        Some(Meaning::Same) => ", does the same",
        Some(Meaning::Other(_)) => ", does another thing",
        Some(Meaning::Declared(_) | Meaning::NotDecided(_)) | None => "",
    });
    heading.push_str(": ");
    heading.push_str(entry.kind.text());
    if matches!(entry.kind, Kind::Declaration | Kind::Structure | Kind::Block) && !entry.title.is_empty() {
        heading.push_str(&format!(" of {}", shortened(&entry.title)));
    }
    let line = match (change.old, change.new) {
        (Some(old), Some(new)) => {
            let (was, is) = (comparison.old.line(old), comparison.new.line(new));
            if was == is {
                format!(", line {is}")
            } else {
                format!(", line {is} (was line {was})")
            }
        }
        (None, Some(new)) => format!(", line {}", comparison.new.line(new)),
        (Some(old), None) => format!(", was line {}", comparison.old.line(old)),
        (None, None) => String::new(),
    };
    heading.push_str(&line);
    if !entry.place.is_empty() {
        heading.push_str(&format!(", in {}", entry.place));
    }
    if entry.kind == Kind::Network && !entry.title.is_empty() {
        heading.push_str(&format!(", writes {}", shortened(&entry.title)));
    }
    heading
}

/// What is known of what an edited network does, besides its heading: the values that show a difference, or why it is not
/// known.
pub fn reason(change: &Change<'_>) -> Option<String> {
    match change.meaning.as_ref()? {
        Meaning::Same => None,
        Meaning::Other(difference) => Some(difference.to_string()),
        Meaning::Declared(tags) => Some(match tags.as_slice() {
            [tag] => format!("{tag} is declared differently"),
            tags => format!("{} are declared differently", tags.join(", ")),
        }),
        Meaning::NotDecided(cause) => Some(format!("whether it does the same is not decided: {cause}")),
    }
}

/// What an edited network does, as it is called in JSON: one word.
pub const fn word(meaning: &Meaning) -> &'static str {
    match meaning {
        Meaning::Same => "same",
        Meaning::Other(_) => "other",
        Meaning::Declared(_) => "declared",
        Meaning::NotDecided(_) => "unknown",
    }
}

/// The tags that an entry writes, or the names that it declares, as they are written.
pub fn names(entry: &Entry) -> Vec<&str> {
    match entry.kind {
        Kind::Network | Kind::Declaration | Kind::Structure | Kind::Block => {
            entry.title.split(", ").filter(|name| !name.is_empty()).collect()
        }
        _ => Vec::new(),
    }
}

/// What is known of the whole programs, for who has read what changed in them: a sentence, and the rows of a run that shows it.
/// None: nothing, or nothing new.
pub fn of_whole(comparison: &Comparison<'_>) -> Option<(String, Vec<String>)> {
    match comparison.whole.as_ref()? {
        // What each network says for itself needs no more words.
        Whole::Same if comparison.changes.iter().all(is_harmless) => None,
        Whole::Same => Some(("the programs do the same in every run".to_owned(), Vec::new())),
        Whole::Differs(run) => Some(said(run)),
        Whole::Outputs(_) | Whole::NotDecided(_) => None,
    }
}

/// A list of names that fits on the line.
fn shortened(names: &str) -> String {
    const MOST: usize = 40;
    match names.char_indices().nth(MOST) {
        None => names.to_owned(),
        Some((end, _)) => {
            let end = names[..end].rfind(", ").unwrap_or(end);
            format!("{}, ...", &names[..end])
        }
    }
}

/// How many of each, as a sentence: `1 edited, 2 new, 7 the same`.
pub fn summary(comparison: &Comparison<'_>) -> String {
    let counts = comparison.counts();
    let counts = counts.iter().map(|(what, count)| match *what {
        "same" => format!("{count} the same"),
        what => format!("{count} {what}"),
    });
    let counts: Vec<String> = counts.collect();
    if counts.is_empty() {
        "nothing in it".to_owned()
    } else {
        counts.join(", ")
    }
}
