//! From a row to the program and back: definition, references, highlights and rename.

use super::file::Scenarios;
use super::place::{AtCursor, place};
use super::row::{named, usage};
use crate::definition::defined;
use crate::highlight::Highlight;
use crate::references::{Reference, of_symbol};
use crate::rename::{Renamable, RenameRefused, Renamed, is_address, no_name, rename_symbol};
use crate::symbol::Symbol;
use crate::target::Target;
use ladder_format::Options;
use ladder_simulator::scenario::Row;
use ladder_syntax::{TextRange, TextSize};
use std::sync::Arc;

/// What is named at an offset: the tag, and where its name is.
fn symbol_at(scenarios: &Scenarios<'_>, offset: TextSize) -> Option<(Symbol, TextRange)> {
    let AtCursor::Tag(row) = place(scenarios, offset)? else {
        return None;
    };
    let named = named(scenarios, &row.name)?;
    let range = named.range(row);
    Some((named.symbol, range))
}

/// Where what is at an offset is defined: a tag in its file, or the program.
pub fn definition(scenarios: &Scenarios<'_>, offset: TextSize) -> Vec<Target> {
    let Some(program) = scenarios.program else {
        return Vec::new();
    };
    if let Some(AtCursor::Program(_)) = place(scenarios, offset) {
        let begin = TextRange::empty(TextSize::new(0));
        return vec![Target {
            file: Arc::clone(&program.name),
            range: begin,
            focus: begin,
        }];
    }
    match symbol_at(scenarios, offset) {
        Some((symbol, _)) => defined(program, &symbol, scenarios.workspace),
        None => Vec::new(),
    }
}

/// All places of the tag at an offset: in the program, the files next to it, and in scenarios.
pub fn references(scenarios: &Scenarios<'_>, offset: TextSize) -> Vec<Reference> {
    match (scenarios.program, symbol_at(scenarios, offset)) {
        (Some(program), Some((symbol, _))) => of_symbol(program, &symbol, scenarios.workspace),
        _ => Vec::new(),
    }
}

/// The rows of the file that are about the tag at an offset.
pub fn highlights(scenarios: &Scenarios<'_>, offset: TextSize) -> Vec<Highlight> {
    let Some(AtCursor::Tag(row)) = place(scenarios, offset) else {
        return Vec::new();
    };
    let Some(wanted) = named(scenarios, &row.name) else {
        return Vec::new();
    };
    let rows = scenarios
        .suite
        .scenarios
        .iter()
        .flat_map(|scenario| &scenario.rows);
    let here = |row: &Row| {
        let found = named(scenarios, &row.name).filter(|it| it.symbol == wanted.symbol)?;
        Some(Highlight {
            range: found.range(row),
            usage: usage(row),
        })
    };
    rows.filter_map(here).collect()
}

/// What is at an offset and can be renamed.
///
/// # Errors
/// It has a name that is not the program's to choose.
pub fn prepare_rename(
    scenarios: &Scenarios<'_>,
    offset: TextSize,
) -> Result<Option<Renamable>, RenameRefused> {
    let Some((symbol, range)) = symbol_at(scenarios, offset) else {
        return Ok(None);
    };
    let name = &scenarios.text[range];
    if matches!(symbol, Symbol::Address(_)) || name.starts_with('%') {
        return Err(is_address(name));
    }
    Ok(Some(Renamable {
        range,
        name: name.to_owned(),
    }))
}

/// The edits that give the tag at an offset another name: in the program, the files next to it, and in all scenarios.
///
/// # Errors
/// The name is refused.
pub fn rename(
    scenarios: &Scenarios<'_>,
    offset: TextSize,
    new: &str,
    options: &Options,
) -> Result<Vec<Renamed>, RenameRefused> {
    prepare_rename(scenarios, offset)?;
    match (scenarios.program, symbol_at(scenarios, offset)) {
        (Some(program), Some((symbol, _))) => {
            rename_symbol(program, &symbol, new, scenarios.workspace, options)
        }
        _ => Err(no_name()),
    }
}
