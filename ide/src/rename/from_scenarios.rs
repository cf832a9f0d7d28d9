//! Renaming what a row or a property of a scenario file names.

use super::{Renamable, RenameRefused, Renamed, fixed, is_address, no_name, rename_symbol};
use crate::scenario::Scenarios;
use crate::scenario::navigate::symbol_at;
use crate::symbol::Symbol;
use ladder_format::Options;
use ladder_syntax::TextSize;

/// What is at an offset and can be renamed.
///
/// # Errors
/// It has a name that is not the program's to choose.
pub fn prepare_scenario_rename(
    scenarios: &Scenarios<'_>,
    offset: TextSize,
) -> Result<Option<Renamable>, RenameRefused> {
    let found = symbol_at(scenarios, offset).filter(|(_, range)| range.contains_inclusive(offset));
    let Some((symbol, range)) = found else {
        return Ok(None);
    };
    let name = &scenarios.text[range];
    if matches!(symbol, Symbol::Address(_)) || name.starts_with('%') {
        return Err(is_address(name));
    }
    if let Some(program) = scenarios.program {
        fixed(program, &symbol)?;
    }
    Ok(Some(Renamable {
        range,
        name: name.to_owned(),
    }))
}

/// The edits that give what is at an offset another name: in the program, the files next to it, and in all scenarios.
///
/// # Errors
/// The name is refused.
pub fn rename_in_scenario(
    scenarios: &Scenarios<'_>,
    offset: TextSize,
    new: &str,
    options: &Options,
) -> Result<Vec<Renamed>, RenameRefused> {
    if prepare_scenario_rename(scenarios, offset)?.is_none() {
        return Err(no_name());
    }
    match (scenarios.program, symbol_at(scenarios, offset)) {
        (Some(program), Some((symbol, _))) => {
            rename_symbol(program, &symbol, new, scenarios.workspace, options)
        }
        _ => Err(no_name()),
    }
}
