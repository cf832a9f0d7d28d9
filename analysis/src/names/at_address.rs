//! Which names of a file mean one direct address: they are one tag (LANGUAGE §4), and what is done with one of them is
//! done with all.
//!
//! Tags are kept by name all the same, each with the places where it is used; rules about use ask here for the others.

use crate::context::Context;
use crate::scope::{Scope, TagFacts};
use ladder_syntax::Name;
use rustc_hash::{FxHashMap, FxHashSet};
use std::sync::Arc;

/// The declared tags at addresses that may have several names, by address. An edit of such a declaration is one that is
/// not followed, nor is one that gives an address a second name, so that this stays as it is.
#[derive(Debug, Clone, Default)]
pub(crate) struct AtAddress(Option<Arc<ByAddress>>);

/// Tags by their address, each by its scope and name.
type ByAddress = FxHashMap<Name, Vec<(usize, Name)>>;

impl AtAddress {
    /// Of scopes whose shared tags lead to where they are declared.
    pub(crate) fn of(scopes: &[Scope]) -> AtAddress {
        let mut all = ByAddress::default();
        for (number, scope) in scopes.iter().enumerate() {
            for name in scope.addressed() {
                let Some(tag) = scope.find(name).map(|tag| &scope.tags[tag]) else {
                    continue;
                };
                if let Some(address) = tag.rare.address.as_deref().filter(|_| !tag.leads_elsewhere()) {
                    let names = all.entry(Name::new(address)).or_default();
                    names.push((number, name.clone()));
                }
            }
        }
        // One that the file itself declares is found by its address too.
        all.retain(|_, names| names.len() > 1 || names.iter().any(|(scope, _)| *scope > 0));
        AtAddress((!all.is_empty()).then(|| Arc::new(all)))
    }

    /// Whether an address may have several names in the file.
    pub(crate) fn has_several(&self, address: &Name) -> bool {
        self.0.as_ref().is_some_and(|all| all.contains_key(address))
    }

    /// Whether a tag is the one that stands for all names of its address. One that has no other name is it.
    pub(crate) fn is_first(&self, context: &Context, tag: &TagFacts) -> bool {
        let first = self.first(tag).and_then(|key| context.find_tag(key));
        first.is_none_or(|first| std::ptr::eq(first, tag))
    }

    /// The first tag that is declared at a tag's address, if the address has several names.
    pub(crate) fn first(&self, tag: &TagFacts) -> Option<&(usize, Name)> {
        let (all, address) = self.0.as_ref().zip(tag.rare.address.as_deref())?;
        all.get(&Name::new(address))?.first()
    }

    /// Adds the keys of all names of the addresses that tags have, or had.
    pub(crate) fn add_names(&self, context: &Context, keys: &mut FxHashSet<(usize, Name)>) {
        let Some(all) = &self.0 else { return };
        let address = |key: &(usize, Name)| {
            if key.1.as_str().starts_with('%') {
                return Some(key.1.clone());
            }
            context.find_tag(key).and_then(TagFacts::address)
        };
        let addresses: FxHashSet<Name> = keys.iter().filter_map(address).collect();
        for (address, names) in addresses.iter().filter_map(|address| all.get_key_value(address)) {
            keys.extend(names.iter().cloned());
            keys.insert((0, address.clone()));
        }
    }

    /// The other tags of the file that are at a tag's address.
    pub(crate) fn others<'c>(
        &'c self,
        context: &'c Context,
        tag: &'c TagFacts,
    ) -> impl Iterator<Item = &'c TagFacts> + use<'c> {
        let address = tag.rare.address.as_deref();
        let found = self.0.as_ref().zip(address).and_then(|(all, address)| {
            let address = Name::new(address);
            let names = all.get(&address)?;
            let by_name = names.iter().filter_map(|key| context.find_tag(key));
            // Only used, in the file itself: one that is declared there has a name.
            let bare = context.find_tag(&(0, address)).filter(|bare| !bare.is_declared());
            Some(by_name.chain(bare))
        });
        found
            .into_iter()
            .flatten()
            .filter(|other| !std::ptr::eq(*other, tag))
    }
}
