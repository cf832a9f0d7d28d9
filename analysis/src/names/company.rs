//! Which tags have another type behind an edit besides those that it names.
//!
//! A tag whose type no place gives has that of its company: of what it is compared with, or of what is written to
//! it ([`infer`]). So it depends on the tags of its blocks, and through those of them that have
//! no type by their places either on the tags of their blocks. No tag has a say beyond these.

use crate::context::Context;
use crate::infer::{self, Entry};
use crate::types::Type;
use rustc_hash::FxHashSet;

/// More places are not looked at one by one.
const MOST_PLACES: usize = 2_000;

/// Gives a type to the tags that have none, and to all that are in their company or in that of `changed`: tags that are new
/// or have another type now. Gives those of the company that have got another type. None if these are too many to be looked at.
pub(crate) fn infer_again(context: &mut Context, changed: &[Entry]) -> Option<Vec<Entry>> {
    let company = around(context, changed)?;
    let before: Vec<(Entry, Option<Type>)> = company
        .into_iter()
        .map(|(scope, tag)| ((scope, tag), context.scopes[scope].tags[tag].ty))
        .collect();
    let entries: Vec<Entry> = before.iter().map(|(entry, _)| *entry).collect();
    for &(scope, tag) in &entries {
        context.scopes[scope].tags[tag].ty = None;
    }
    infer::settle(context, &entries);
    let is_other =
        |((scope, tag), before): &(Entry, Option<Type>)| context.scopes[*scope].tags[*tag].ty != *before;
    Some(
        before
            .into_iter()
            .filter(is_other)
            .map(|(entry, _)| entry)
            .collect(),
    )
}

/// The tags without a type by their places whose types depend on each other and on those of `changed`.
fn around(context: &Context, changed: &[Entry]) -> Option<FxHashSet<Entry>> {
    let mut places = 0;
    let mut found: FxHashSet<Entry> = FxHashSet::default();
    let mut blocks: FxHashSet<(usize, usize)> = FxHashSet::default();
    let mut next: Vec<Entry> = changed.to_vec();
    while let Some((scope, tag)) = next.pop() {
        let facts = &context.scopes[scope].tags[tag];
        if facts.depends_on_company() && !found.insert((scope, tag)) {
            continue;
        }
        places += facts.uses.len();
        if places > MOST_PLACES {
            return None;
        }
        for place in context.uses(facts) {
            if !blocks.insert((place.network, place.block)) {
                continue;
            }
            let network = context.networks.at(place.network);
            let names = network.facts().named.iter();
            let names = names.filter(|named| named.block as usize == place.block);
            let scope = network.scope;
            let tags = names.filter_map(|named| context.scopes[scope].find(&named.key));
            let depends = |tag: &usize| context.scopes[scope].tags[*tag].depends_on_company();
            let company = tags.filter(depends).map(|tag| (scope, tag));
            next.extend(company.filter(|entry| !found.contains(entry)));
        }
    }
    Some(found)
}
