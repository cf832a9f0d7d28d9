//! Parsing loses nothing, and parsing an edited text is parsing that text.
//!
//! The first part of the input is a text. Each other one is an edit: where it begins (two bytes), how much goes (one), and
//! what comes.

use crate::input::{Numbers, floor, parts, text};
use invariants::check_same;
use ladder_syntax::{TextRange, TextSize, parse};

#[path = "../../../syntax/tests/properties/invariants.rs"]
mod invariants;

/// More edits tell nothing new.
const MOST_EDITS: usize = 12;

pub(crate) fn check(data: &[u8]) {
    let parts = parts(data);
    let mut now = text(parts[0]);
    let mut edited = invariants::check(&now);
    for part in parts.iter().skip(1).take(MOST_EDITS) {
        let mut numbers = Numbers(part);
        let start = floor(&now, numbers.large() % (now.len() + 1));
        let end = floor(&now, start + numbers.small()).max(start);
        let new = text(numbers.0);
        let old = now.clone();
        now.replace_range(start..end, &new);
        let range = TextRange::new(TextSize::new(start as u32), TextSize::new(end as u32));
        let before = edited;
        edited = before.edited(&now, range, TextSize::of(new.as_str()));
        check_same(&edited, &now);
        check_same(&parse(&old).updated(&old, &now), &now);
    }
}
