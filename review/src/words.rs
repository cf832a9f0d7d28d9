//! A change in words.

use crate::comparison::{Change, Comparison};
use crate::outline::{Entry, Kind, Outline};
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
    // The other system's own name says what it is: `rung 3 of ..`.
    let is_named = entry.kind == Kind::Network && entry.part.as_ref().is_some_and(|part| !part.is_empty());
    if !is_named {
        heading.push_str(entry.kind.text());
    }
    if matches!(entry.kind, Kind::Declaration | Kind::Structure | Kind::Block) && !entry.title.is_empty() {
        heading.push_str(&format!(" of {}", shortened(&entry.title)));
    }
    let was = change.old.and_then(|old| spot(comparison.old, old));
    let is = change.new.and_then(|new| spot(comparison.new, new));
    let place = match (was, is) {
        (Some(was), Some(is)) if was != is => format!("{is} (was {was})"),
        (_, Some(is)) => is,
        (Some(was), None) if is_named => was,
        (Some(was), None) => format!("was {was}"),
        (None, None) => String::new(),
    };
    if !is_named && !place.is_empty() {
        heading.push_str(", ");
    }
    heading.push_str(&place);
    if !entry.place.is_empty() && entry.part.is_none() {
        heading.push_str(&format!(", in {}", entry.place));
    }
    if entry.kind == Kind::Network && !entry.title.is_empty() {
        heading.push_str(&format!(", writes {}", shortened(&entry.title)));
    }
    heading
}

/// Where an entry is: its line, or what the other system calls its place. None: that has no name for it.
fn spot(outline: &Outline, entry: &Entry) -> Option<String> {
    match entry.part.as_deref() {
        None => Some(format!("line {}", outline.line(entry))),
        Some("") => None,
        Some(part) => Some(part.to_owned()),
    }
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
