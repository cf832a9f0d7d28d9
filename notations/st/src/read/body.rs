//! What becomes of a body.

use super::tree::Span;
use ladder_format::program::{Declaration, Item};
use ladder_notation::{Entry, LineColumn, Outcome, Reading};
use std::collections::HashSet;

/// So much of a statement is shown in a report.
const SHOWN: usize = 60;

/// The networks of a body.
#[derive(Debug, Default)]
pub struct Body {
    /// Networks, and the directives above them.
    pub items: Vec<Item>,
    /// The tags that they need besides those that are declared.
    pub tags: Vec<Declaration>,
    /// Where in the text each origin is.
    pub origins: Vec<usize>,
    /// What became of each statement.
    pub entries: Vec<(Span, Outcome)>,
    /// The tags that are in the networks.
    pub used: HashSet<String>,
    /// Of a text among others: the tags that it assigns or calls, in small letters.
    pub writes: HashSet<String>,
    /// The tags that it calls.
    pub calls: HashSet<String>,
    /// The highest number that a label has.
    pub last_label: u32,
    /// Why the body cannot be read but as a whole.
    pub unread: Option<String>,
}

impl Body {
    /// Adds to a reading where the elements come from, and what became of each statement of the text. `place` is where a byte
    /// of it is in the file.
    pub fn note(&self, text: &str, place: impl Fn(usize) -> LineColumn, reading: &mut Reading) {
        for at in &self.origins {
            reading.origin(place(*at));
        }
        for (span, outcome) in &self.entries {
            let first = text[span.clone()].lines().next().unwrap_or_default();
            reading.report.entries.push(Entry {
                place: place(span.start),
                element: first.chars().take(SHOWN).collect(),
                outcome: outcome.clone(),
            });
        }
    }
}
