//! A change in words.

use crate::comparison::{Change, Comparison};
use crate::outline::{Entry, Kind};
use crate::verdict::Verdict;
use ladder_prover::Meaning;

/// What happened to an entry and where, on one line: `edited network, line 12 (was line 10), writes run`.
pub fn heading(comparison: &Comparison<'_>, change: &Change<'_>) -> String {
    let entry = change.entry();
    let mut heading = String::new();
    match (change.moved, change.verdict) {
        (true, Verdict::Same) => heading.push_str("moved"),
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
    let entry = change.entry();
    if entry.kind == Kind::Unread && change.verdict == Verdict::Edited {
        return Some(format!(
            "whether it does the same is not decided: {}",
            entry.title
        ));
    }
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
