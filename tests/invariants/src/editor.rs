//! Whatever an editor asks at whatever place, there is an answer.
//!
//! The first part of the input is a text, the second one two bytes for each place. Without it the middle is asked about.

use crate::features::{FEATURES, whole};
use crate::input::{Numbers, floor, parts, text};
use ladder_analysis::analyze;
use ladder_syntax::{TextSize, parse};
use std::sync::Arc;

/// More places tell nothing new.
const MOST_PLACES: usize = 4;

pub(crate) fn check(data: &[u8]) {
    let parts = parts(data);
    let text = text(parts[0]);
    let analysis = analyze(&Arc::new(parse(&text)), "main.clad");
    whole(&analysis);
    let end = TextSize::of(text.as_str());
    let mut numbers = Numbers(parts.get(1).copied().unwrap_or_default());
    let mut places = Vec::new();
    while !numbers.0.is_empty() && places.len() < MOST_PLACES {
        places.push(floor(&text, numbers.large() % (text.len() + 1)));
    }
    if places.is_empty() {
        places.push(floor(&text, text.len() / 2));
    }
    for place in places {
        for (_, ask) in FEATURES {
            ask(&analysis, TextSize::new(place as u32), end);
        }
    }
}
