//! From a symbol to its places in the whole workspace.

use super::{Occurrence, Symbol, occurrences};
use crate::neighbour::Workspace;
use ladder_analysis::context::Context;
use std::sync::Arc;

/// The other files in which a symbol may have places.
pub(crate) fn files_of(context: &Context, symbol: &Symbol, workspace: &dyn Workspace) -> Vec<Arc<Context>> {
    match symbol {
        // Only a block's own tags can be named outside of their file: as named operands.
        Symbol::Tag { file, scope: 0, .. } | Symbol::Label { file, .. } => {
            elsewhere(context, file, workspace)
        }
        Symbol::Instruction(_) | Symbol::System(_) => workspace.all(),
        Symbol::Member { of, .. } => files_of(context, of, workspace),
        _ => symbol
            .name()
            .map_or_else(Vec::new, |name| workspace.mentioning(name)),
    }
}

fn elsewhere(context: &Context, file: &Arc<str>, workspace: &dyn Workspace) -> Vec<Arc<Context>> {
    if context.name == *file {
        return Vec::new();
    }
    workspace.file(file).into_iter().collect()
}

/// The places of a symbol by file: the one that is asked first, then the others in the order of the workspace.
pub(crate) fn everywhere(
    context: &Context,
    symbol: &Symbol,
    workspace: &dyn Workspace,
) -> Vec<(Arc<str>, Vec<Occurrence>)> {
    let own = (Arc::clone(&context.name), occurrences(context, symbol));
    let neighbours = files_of(context, symbol, workspace);
    let others = neighbours.iter().map(|neighbour| {
        let file = &neighbour;
        (Arc::clone(&file.name), occurrences(file, symbol))
    });
    std::iter::once(own)
        .chain(others)
        .filter(|(_, places)| !places.is_empty())
        .collect()
}
