//! From a text to its canonical layout.

use super::selection::Selection;
use crate::outcome::Failure;
use ladder_format::{Options, apply, format_ranges, reformat};
use ladder_simulator::scenario;
use ladder_workspace::{is_scenario, shown};
use std::path::Path;

/// The text of a file in canonical layout, if it is in another; with a selection only the networks, sections and lines that
/// it touches. The name says whether the text is a program or holds scenarios.
///
/// # Errors
/// A part is selected of a file of scenarios.
pub(super) fn formatted(
    name: &Path,
    text: &str,
    options: &Options,
    selection: Option<Selection>,
) -> Result<Option<String>, Failure> {
    if is_scenario(name) {
        if selection.is_some() {
            return Err(Failure::new(format!(
                "{}: --range is for programs; the columns of scenarios are aligned in the whole file",
                shown::path(name)
            )));
        }
        return Ok(Some(scenario::layout(text)).filter(|formatted| formatted != text));
    }
    let Some(selection) = selection else {
        return Ok(reformat(text, options));
    };
    let parse = ladder_syntax::parse(text);
    let edits = format_ranges(&parse, options, &[selection.range_in(text)]);
    Ok((!edits.is_empty()).then(|| apply(text, &edits)))
}
