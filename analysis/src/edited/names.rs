//! The tags of a text behind an edit of networks: what the new ones name comes, and what the others named goes.

use super::networks::Edited;
use super::tags::EditedTags;
use crate::context::Context;
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
use std::collections::{BTreeMap, BTreeSet};
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
        // Tags that nobody has named before, by their scopes and in their order.
        let mut new: BTreeMap<usize, Vec<TagFacts>> = BTreeMap::new();
        let mut new_names: FxHashMap<(usize, Name), usize> = FxHashMap::default();
        for &index in &self.added {
            let network = self.context.networks.at(index);
            let scope = network.scope;
            let id = self.context.networks.id(index);
            for (number, named) in (0..).zip(network.named.iter()) {
                let place = UseRef::new(id, number, named.kind);
                if let Some(tag) = self.context.scopes[scope].find(&named.key) {
                    for entry in self.with_lead((scope, tag)) {
                        touched.entry(entry).or_default().push(place);
                    }
                    continue;
                }
                let new = new.entry(scope).or_default();
                let at = match new_names.get(&(scope, named.key.clone())) {
                    Some(at) => *at,
                    None => {
                        let spelled = uses::spelling(network.facts(), named);
                        new.push(if scope == 0 {
                            shared::brought_in(&self.context, spelled)?
                        } else {
                            shared::brought_into_body(&self.context, spelled)?
                        });
                        new_names.insert((scope, named.key.clone()), new.len() - 1);
                        new.len() - 1
                    }
                };
                new[at].uses.0.push(place);
            }
        }
        let context = &mut self.context;
        let mut found: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        let mut edited = EditedTags::default();
        for ((scope, tag), places) in touched {
            let is_found = tag >= context.scopes[scope].declared;
            let facts = &mut context.scopes[scope].tags[tag];
            // The places of one whose declaration says no type decide about that. One that a body declares in VAR_EXTERNAL has its
            // place among the tags by that.
            if facts.mistyped || is_found && facts.origin == Origin::Shared && !facts.may_move() {
                return None;
            }
            edited.used.push((scope, Name::new(&facts.name)));
            facts.uses.0.retain(|place| !gone.contains(&place.network));
            if !places.is_empty() {
                facts.uses.0.extend(places);
                let networks = &context.networks;
                facts.uses.0.sort_by_key(|place| networks.order_of(*place));
            }
            if is_found {
                found.entry(scope).or_default().push(tag);
            }
        }
        let mut before: Vec<(usize, SmolStr, Option<Type>)> = Vec::new();
        for (scope, tag) in found
            .iter()
            .flat_map(|(scope, tags)| tags.iter().map(|tag| (*scope, *tag)))
        {
            let facts = &context.scopes[scope].tags[tag];
            if facts.leads_elsewhere() {
                entry_stays(context, facts)?;
                continue;
            }
            if is_left_to_a_body(context, facts) {
                return None;
            }
            before.push((scope, facts.name.clone(), facts.ty));
            if !facts.uses.is_empty() {
                respelled(context, (scope, tag));
                let typed = typed(context, scope, &context.scopes[scope].tags[tag]);
                context.scopes[scope].tags[tag] = typed;
            }
        }
        let in_bodies = new_names.keys().filter(|(scope, _)| *scope > 0);
        let in_bodies: Vec<Name> = in_bodies.map(|(_, name)| name.clone()).collect();
        if !in_bodies.is_empty() {
            Arc::make_mut(&mut context.named_in_bodies).extend(in_bodies);
        }
        let scopes: BTreeSet<usize> = found.keys().chain(new.keys()).copied().collect();
        for scope in scopes {
            let new = new.remove(&scope).unwrap_or_default();
            let new = new.iter().map(|tag| Arc::new(typed(context, scope, tag)));
            let new: Vec<Arc<TagFacts>> = new.collect();
            // Another first use may mean another place among the tags.
            let found = found.remove(&scope).unwrap_or_default();
            place_found(&mut context.scopes[scope], found, new, &context.networks);
        }
        edited.infer_again(context, &before, new_names.keys().cloned().collect())?;
        edited.used.extend(new_names.into_keys());
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

/// Whether a body's entry for a tag of another scope stays as it is but for its uses. None: it is gone, or spelled in another way.
fn entry_stays(context: &Context, entry: &TagFacts) -> Option<()> {
    let first = entry.uses.0.first()?;
    (spelled_at(context, *first) == entry.name).then_some(())
}

/// Whether only bodies still use a tag of another file, and one declares it in VAR_EXTERNAL: it lies there now.
fn is_left_to_a_body(context: &Context, tag: &TagFacts) -> bool {
    if tag.rare.foreign.is_none() {
        return false;
    }
    let scope_of = |place: &UseRef| {
        context
            .networks
            .at(context.networks.index_of(place.network))
            .scope
    };
    if tag.uses.0.iter().any(|place| scope_of(place) == 0) {
        return false;
    }
    let key = Name::new(&tag.name);
    let mut in_bodies = (1..context.scopes.len()).filter_map(|body| context.find_tag(&(body, key.clone())));
    in_bodies.any(TagFacts::is_declared)
}

/// A tag without a declaration is spelled as where it is first.
fn respelled(context: &mut Context, (scope, tag): Entry) {
    let facts = &context.scopes[scope].tags[tag];
    let Some(place) = facts.uses.0.first() else { return };
    if facts.rare.foreign.is_some() {
        return;
    }
    let name = spelled_at(context, *place);
    if *facts.name != *name {
        let spelled = uses::undeclared(name, context.profile.law());
        let facts = &mut context.scopes[scope].tags[tag];
        facts.name = spelled.name;
        // To write it makes room for it.
        if facts.rare.address != spelled.rare.address {
            facts.rare.address.clone_from(&spelled.rare.address);
        }
    }
}

/// A tag with the type and the role that its places give it, if neither a declaration nor its name says them. It has no type yet
/// if that follows from its company. In a body it is neither an input nor an output.
pub(crate) fn typed(context: &Context, scope: usize, tag: &TagFacts) -> TagFacts {
    let mut tag = tag.clone();
    if !tag.is_inferred() {
        return tag;
    }
    tag.by_company = false;
    tag.ty = infer::answer(context, &tag);
    if tag.origin == Origin::Undeclared && scope == 0 {
        tag.role = if tag.ty == Some(Type::BOOL) {
            uses::role(&tag.uses)
        } else {
            Role::Internal
        };
    }
    tag
}
