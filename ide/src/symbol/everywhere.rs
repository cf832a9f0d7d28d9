//! From a symbol to its places in the whole workspace.

use super::{Occurrence, Symbol, occurrences};
use crate::neighbour::{Which, Workspace, in_each, named};
use ladder_analysis::context::Context;
use ladder_analysis::library_analysis;
use ladder_syntax::Name;
use std::sync::Arc;

/// Looks into the other files in which symbols may have places, into each once; what is found, in the order of the
/// workspace.
pub(crate) fn in_files_of<T: Send>(
    context: &Context,
    symbols: &[Symbol],
    workspace: &dyn Workspace,
    look: impl Fn(&Context) -> T + Sync,
) -> Vec<T> {
    let mut at_home: Vec<&Arc<str>> = symbols.iter().filter_map(only_in).collect();
    if at_home.len() == symbols.len() {
        at_home.retain(|file| context.name != **file);
        at_home.sort_unstable();
        at_home.dedup();
        let files = at_home.into_iter().filter_map(|file| named(workspace, file));
        return files.map(|file| look(&file)).collect();
    }
    let names: Option<Vec<Name>> = symbols.iter().map(|symbol| symbol.name().cloned()).collect();
    let which = names.as_deref().map_or(Which::All, Which::Mentioning);
    let mut found = in_each(workspace, which, &look);
    // What is the library's is in its file too, which is none of the workspace.
    let of_library = symbols
        .iter()
        .filter_map(Symbol::file)
        .find_map(|file| library_analysis(file));
    found.extend(of_library.map(|analysis| look(&analysis.context)));
    found
}

/// The file that has all places of a symbol, where only one does.
fn only_in(symbol: &Symbol) -> Option<&Arc<str>> {
    match symbol {
        // Only a block's own tags can be named outside of their file: as named operands.
        Symbol::Tag { file, scope: 0, .. } | Symbol::Label { file, .. } => Some(file),
        Symbol::Member { of, .. } => only_in(of),
        _ => None,
    }
}

/// The places of a symbol by file: the one that is asked first, then the others in the order of the workspace.
pub(crate) fn everywhere(
    context: &Context,
    symbol: &Symbol,
    workspace: &dyn Workspace,
) -> Vec<(Arc<str>, Vec<Occurrence>)> {
    let places = |file: &Context| (Arc::clone(&file.name), occurrences(file, symbol));
    let symbols = std::slice::from_ref(symbol);
    let others = in_files_of(context, symbols, workspace, places);
    std::iter::once(places(context))
        .chain(others)
        .filter(|(_, places)| !places.is_empty())
        .collect()
}
