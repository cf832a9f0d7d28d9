//! Which names of a file mean one direct address: they are one tag (LANGUAGE §4), and what is done with one of them is
//! done with all.
//!
//! Tags are kept by name all the same, each with the places where it is used; rules about use ask here for the others.

use super::scope::{Entry, Scope, TagFacts};
use ladder_syntax::Name;
use rustc_hash::FxHashMap;

/// The tags at addresses that have several names, by address: the declared ones first, then the one that is only used.
#[derive(Debug, Clone, Default)]
pub(crate) struct AtAddress(FxHashMap<Name, Vec<Entry>>);

impl AtAddress {
    /// Of scopes whose shared tags lead to where they are declared.
    pub(crate) fn of(scopes: &[Scope]) -> AtAddress {
        let mut all: FxHashMap<Name, Vec<Entry>> = FxHashMap::default();
        let mut enter = |tag: &TagFacts, entry: Entry| {
            // What another file declares at an address is the tag of that file.
            let is_own = !tag.is_alias() && tag.cold.foreign.is_none();
            if let Some(address) = tag.address().filter(|_| is_own) {
                all.entry(address).or_default().push(entry);
            }
        };
        for (number, scope) in scopes.iter().enumerate() {
            for (index, tag) in scope.tags.iter().enumerate().filter(|(_, tag)| tag.is_declared()) {
                enter(tag, (number, index));
            }
        }
        for (index, tag) in scopes[0].tags.iter().enumerate() {
            if !tag.is_declared() {
                enter(tag, (0, index));
            }
        }
        all.retain(|_, entries| entries.len() > 1);
        AtAddress(all)
    }

    /// All names of a tag's address; none if it has only one.
    pub(crate) fn all(&self, tag: &TagFacts) -> &[Entry] {
        if self.0.is_empty() {
            return &[];
        }
        let entries = tag.address().and_then(|address| self.0.get(&address));
        entries.map_or(&[], Vec::as_slice)
    }
}
