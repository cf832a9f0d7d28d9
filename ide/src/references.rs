//! Every place of a thing in the workspace, with reads and writes distinguished.

use crate::neighbour::Workspace;
use crate::symbol::{Found, Usage, everywhere, find};
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

/// The places of what stands at an offset: those of the file first. Definitions and declarations are among them.
pub fn references(context: &Context, offset: TextSize, workspace: &dyn Workspace) -> Vec<Reference> {
    let Some(Found { symbol, .. }) = find(context, offset) else {
        return Vec::new();
    };
    let mut references = Vec::new();
    for (file, places) in everywhere(context, &symbol, workspace) {
        references.extend(places.into_iter().map(|place| Reference {
            file: Arc::clone(&file),
            range: place.range,
            usage: place.usage,
        }));
    }
    references
}

#[cfg(test)]
mod tests;
