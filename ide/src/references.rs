//! Every place of a thing in the workspace, with reads and writes distinguished.

use crate::neighbour::Workspace;
use crate::scenario::Scenarios;
use crate::scenario::navigate::symbol_at;
use crate::scenario::row::places;
use crate::symbol::{Found, Symbol, Usage, everywhere, find};
use ladder_analysis::context::Context;
use ladder_syntax::{TextRange, TextSize};
use std::sync::Arc;

/// A place of a thing.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Reference {
    /// The file.
    pub file: Arc<str>,
    /// Its name there.
    pub range: TextRange,
    /// What is done with it.
    pub usage: Usage,
}

/// The places of what is at an offset: those of the file first, those in scenarios last. Definitions and
/// declarations are among them.
pub fn references(context: &Context, offset: TextSize, workspace: &dyn Workspace) -> Vec<Reference> {
    let Some(Found { symbol, .. }) = find(context, offset) else {
        return Vec::new();
    };
    of_symbol(context, &symbol, workspace)
}

/// The places of a symbol, in programs and in scenarios.
pub(crate) fn of_symbol(context: &Context, symbol: &Symbol, workspace: &dyn Workspace) -> Vec<Reference> {
    let mut references = in_programs(context, symbol, workspace);
    for file in workspace.scenarios() {
        let found = places(symbol, &file, context, workspace).into_iter();
        references.extend(found.map(|(range, usage)| Reference {
            file: Arc::clone(&file.name),
            range,
            usage,
        }));
    }
    references
}

/// The places of a symbol in programs.
pub(crate) fn in_programs(context: &Context, symbol: &Symbol, workspace: &dyn Workspace) -> Vec<Reference> {
    let mut references = Vec::new();
    for (file, places) in everywhere(context, symbol, workspace) {
        references.extend(places.into_iter().map(|place| Reference {
            file: Arc::clone(&file),
            range: place.range,
            usage: place.usage,
        }));
    }
    references
}

/// All places of what is named at an offset: in the program, the files next to it, and in scenarios.
pub fn scenario_references(scenarios: &Scenarios<'_>, offset: TextSize) -> Vec<Reference> {
    match (scenarios.program, symbol_at(scenarios, offset)) {
        (Some(program), Some((symbol, _))) => of_symbol(program, &symbol, scenarios.workspace),
        _ => Vec::new(),
    }
}

#[cfg(test)]
mod tests;
