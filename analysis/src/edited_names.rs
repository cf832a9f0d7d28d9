//! The tags of a text behind an edit of networks: what the new ones name comes, and what the others named goes.

use crate::context::Context;
use crate::edited::{Edited, EditedTags};
use crate::infer::{self, Entry};
use crate::networks::Networks;
use crate::program::Role;
use crate::scope::{MOST_EXCHANGED, Origin, Scope, TagFacts, UseRef};
use crate::shared;
use crate::types::Type;
use crate::uses;
use ladder_syntax::Name;
use rustc_hash::{FxHashMap, FxHashSet};
use smol_str::SmolStr;
use std::sync::Arc;

impl Edited {
    /// A tag of a scope, and the tag of the file that it leads to.
    fn with_lead(&self, (scope, tag): Entry) -> impl Iterator<Item = Entry> + use<> {
        let facts = &self.context.scopes[scope].tags[tag];
        [Some((scope, tag)), self.context.leads_to(facts)]
            .into_iter()
            .flatten()
    }

    /// Enters what the new networks name, and takes out what the others did. Gives the tags that this concerns.
    pub(crate) fn names(&mut self) -> Option<EditedTags> {
        let gone: FxHashSet<u32> = self.removed.iter().map(|network| network.id).collect();
        let mut touched: FxHashMap<Entry, Vec<UseRef>> = FxHashMap::default();
        for removed in &self.removed {
            for named in &removed.facts.named {
                let tag = self.context.scopes[removed.scope].find(&named.key)?;
                for entry in self.with_lead((removed.scope, tag)) {
                    touched.entry(entry).or_default();
                }
            }
        }
        // Tags that nobody has named before, in their order.
        let mut new: Vec<TagFacts> = Vec::new();
        let mut new_names: FxHashMap<Name, usize> = FxHashMap::default();
        for &index in &self.added {
            let network = self.context.networks.at(index);
            let id = self.context.networks.id(index);
            for (number, named) in (0..).zip(network.named.iter()) {
                let place = UseRef::new(id, number, named.kind);
                if let Some(tag) = self.context.scopes[network.scope].find(&named.key) {
                    for entry in self.with_lead((network.scope, tag)) {
                        touched.entry(entry).or_default().push(place);
                    }
                    continue;
                }
                if network.scope > 0 {
                    return None;
                }
                let at = match new_names.get(&named.key) {
                    Some(at) => *at,
                    None => {
                        let spelled = uses::spelling(network.facts(), named);
                        new.push(shared::brought_in(&self.context, spelled)?);
                        new_names.insert(named.key.clone(), new.len() - 1);
                        new.len() - 1
                    }
                };
                new[at].uses.0.push(place);
            }
        }
        let context = &mut self.context;
        // Tags of the file, and entries of bodies.
        let mut found: Vec<usize> = Vec::new();
        let mut in_bodies: Vec<Entry> = Vec::new();
        let mut edited = EditedTags::default();
        for ((scope, tag), places) in touched {
            let is_found = tag >= context.scopes[scope].declared;
            // The places of one whose declaration says no type decide about that.
            if context.scopes[scope].tags[tag].mistyped {
                return None;
            }
            let facts = &mut context.scopes[scope].tags[tag];
            edited.used.push((scope, Name::new(&facts.name)));
            facts.uses.0.retain(|place| !gone.contains(&place.network));
            if !places.is_empty() {
                facts.uses.0.extend(places);
                let networks = &context.networks;
                facts.uses.0.sort_by_key(|place| networks.order_of(*place));
            }
            if is_found && scope > 0 {
                in_bodies.push((scope, tag));
            } else if is_found {
                found.push(tag);
            }
        }
        for (scope, tag) in in_bodies {
            entry_stays(context, scope, tag)?;
        }
        let mut before: Vec<(usize, SmolStr, Option<Type>)> = Vec::new();
        for &tag in &found {
            let facts = &context.scopes[0].tags[tag];
            before.push((0, facts.name.clone(), facts.ty));
            if !facts.uses.is_empty() {
                respelled(context, tag);
                let typed = typed(context, &context.scopes[0].tags[tag]);
                context.scopes[0].tags[tag] = typed;
            }
        }
        let new: Vec<Arc<TagFacts>> = new.iter().map(|tag| Arc::new(typed(context, tag))).collect();
        // Another first use may mean another place among the tags.
        place_found(&mut context.scopes[0], found, new, &context.networks);
        let fresh = new_names.keys().map(|name| (0, name.clone())).collect();
        edited.infer_again(context, &before, fresh)?;
        edited.used.extend(new_names.into_keys().map(|name| (0, name)));
        Some(edited)
    }
}

/// Puts tags that are only used to their places, by their first uses: some that are there, which may be used no more, and
/// new ones.
pub(crate) fn place_found(
    scope: &mut Scope,
    mut touched: Vec<usize>,
    new: Vec<Arc<TagFacts>>,
    networks: &Networks,
) {
    let first_use = |tag: &TagFacts| tag.uses.0.first().map(|place| networks.order_of(*place));
    if touched.len() > MOST_EXCHANGED {
        scope.exchange_found(&touched, new, first_use);
        return;
    }
    touched.sort_unstable();
    let is_touched = |tag: &usize| touched.binary_search(tag).is_ok();
    let key = |tag: usize| first_use(&scope.tags[tag]);
    // Between those that nothing has happened to.
    let is_in_place = |tag: usize| {
        let mut above = (scope.declared..tag).rev().filter(|tag| !is_touched(tag));
        let mut below = (tag + 1..scope.tags.len()).filter(|tag| !is_touched(tag));
        let own = key(tag);
        own.is_some()
            && above.next().is_none_or(|above| key(above) < own)
            && below.next().is_none_or(|below| own < key(below))
    };
    let (stay, mut moved): (Vec<usize>, Vec<usize>) = touched.iter().partition(|tag| is_in_place(**tag));
    if !stay.is_sorted_by_key(|tag| key(*tag)) {
        moved.extend(stay);
        moved.sort_unstable();
    }
    if moved.is_empty() && new.is_empty() {
        return;
    }
    scope.exchange_found(&moved, new, first_use);
}

/// How a tag is spelled at a place.
pub(crate) fn spelled_at(context: &Context, place: UseRef) -> &str {
    let network = context.networks.index_of(place.network);
    let network = context.networks.at(network).facts();
    uses::spelling(network, &network.named[place.named() as usize])
}

/// Whether a body's entry for a tag of the file stays as it is but for its uses. None: it is gone, is spelled in another way, or is in
/// another place among those of the body.
fn entry_stays(context: &Context, scope: usize, tag: usize) -> Option<()> {
    let body = &context.scopes[scope];
    let entry = &body.tags[tag];
    let first = entry.uses.0.first()?;
    let first_uses = body.tags.from(body.declared).map(|tag| tag.uses.0.first());
    let in_order = first_uses.is_sorted_by_key(|first| first.map(|place| context.networks.order_of(*place)));
    (in_order && spelled_at(context, *first) == entry.name).then_some(())
}

/// A tag of the file is spelled as where it is first.
fn respelled(context: &mut Context, tag: usize) {
    let facts = &context.scopes[0].tags[tag];
    let Some(place) = facts.uses.0.first() else { return };
    if facts.rare.foreign.is_some() {
        return;
    }
    let name = spelled_at(context, *place);
    if *facts.name != *name {
        let spelled = uses::undeclared(name, context.profile.law());
        let facts = &mut context.scopes[0].tags[tag];
        facts.name = spelled.name;
        // To write it makes room for it.
        if facts.rare.address != spelled.rare.address {
            facts.rare.address.clone_from(&spelled.rare.address);
        }
    }
}

/// A tag with the type and the role that its places give it, if neither a declaration nor its name says them. It has no type yet
/// if that follows from its company.
pub(crate) fn typed(context: &Context, tag: &TagFacts) -> TagFacts {
    let mut tag = tag.clone();
    if !tag.is_inferred() {
        return tag;
    }
    tag.by_company = false;
    tag.ty = infer::answer(context, &tag);
    if tag.origin == Origin::Undeclared {
        tag.role = if tag.ty == Some(Type::BOOL) {
            uses::role(&tag.uses)
        } else {
            Role::Internal
        };
    }
    tag
}
