//! From a text to its canonical layout.

use super::selection::Selection;
use ladder_format::{Options, apply, format_ranges, reformat};

/// The text in canonical layout, if it is in another; with a selection only the networks, sections and lines that it
/// touches.
pub(super) fn formatted(text: &str, options: &Options, selection: Option<Selection>) -> Option<String> {
    let Some(selection) = selection else {
        return reformat(text, options);
    };
    let parse = ladder_syntax::parse(text);
    let edits = format_ranges(&parse, options, &[selection.range_in(text)]);
    (!edits.is_empty()).then(|| apply(text, &edits))
}
