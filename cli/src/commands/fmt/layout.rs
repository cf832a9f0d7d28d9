//! From a text to its canonical layout.

use super::selection::Selection;
use ladder_format::{Options, apply, format_ranges, format_text};

/// The text in canonical layout; with a selection only the networks, sections and lines that it touches.
pub(super) fn formatted(text: &str, options: &Options, selection: Option<Selection>) -> String {
    let Some(selection) = selection else {
        return format_text(text, options);
    };
    let parse = ladder_syntax::parse(text);
    apply(text, &format_ranges(&parse, options, &[selection.range_in(text)]))
}
