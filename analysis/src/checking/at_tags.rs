//! What is found at the places of tags, kept while no edit concerns the tag.

use super::addresses::Addresses;
use super::latches::Latches;
use super::read_above::ReadAbove;
use super::shelf::{Shelf, Source};
use super::undeclared::UndeclaredTags;
use crate::context::{Change, Context};
use crate::control_flow::ControlFlow;
use crate::diagnostic::Diagnostic;
use crate::findings::Anchored;
use crate::rule::{Rule, Severity};
use crate::rules::tag_summary::PlacesAtAddresses;
use crate::rules::{self, AroundTags, read_before_write, set_and_reset};
use crate::scope::TagFacts;
use crate::still_wanted::StillWanted;
use ladder_syntax::Name;
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::BTreeSet;
use std::sync::Arc;

/// A tag, by its scope and name.
pub(super) type TagKey = (usize, Name);

/// What is found at the places of tags.
#[derive(Debug, Default)]
pub(super) struct AtTags {
    found: FxHashMap<TagKey, Vec<Arc<Anchored>>>,
    /// To look at after each edit.
    volatile: FxHashSet<TagKey>,
    /// Those at which an error is found.
    faulty: FxHashSet<TagKey>,
    addresses: Addresses,
    /// Counted while tags are looked at, of one text.
    at_addresses: PlacesAtAddresses,
    latches: Latches,
    read_above: ReadAbove,
    undeclared: UndeclaredTags,
    around: Option<AroundTags>,
    exchanged: Exchanged,
}

/// What the networks of a file have of program flow.
#[derive(Debug, Clone, Copy)]
pub(super) struct Flow {
    /// All of them together.
    pub(super) any: ControlFlow,
    /// What has come or gone with a network.
    pub(super) changed: ControlFlow,
    /// What the networks have that are new or looked at again, and what those had that are gone.
    pub(super) touched: ControlFlow,
}

/// What a look at tags exchanges.
#[derive(Debug, Default)]
pub(super) struct Exchanged {
    pub(super) gone: Vec<Arc<Anchored>>,
    pub(super) new: Vec<Arc<Anchored>>,
}

impl AtTags {
    /// Looks at the tags that a change concerns, and at all of them without one, or if what decides about all of them
    /// changed. Gives how many that are; nothing if that is not wanted any longer.
    pub(super) fn follow(
        &mut self,
        context: &Context,
        change: Option<&Change>,
        (around, flow): (AroundTags, Flow),
        (shelf, wanted): (&mut Shelf, &StillWanted<'_>),
    ) -> Option<usize> {
        let same = self.around.as_ref() == Some(&around);
        let looked_at = match change.filter(|_| same) {
            Some(change) => self.look_at_changed(context, change, (&around, flow), wanted)?,
            None => {
                *self = AtTags::default();
                shelf.remove_all_of_tags();
                self.look_at_all(context, (&around, flow), wanted)?
            }
        };
        self.around = Some(around);
        self.at_addresses = PlacesAtAddresses::default();
        shelf.exchange(std::mem::take(&mut self.exchanged), Source::of_tag);
        Some(looked_at)
    }

    fn look_at_changed(
        &mut self,
        context: &Context,
        change: &Change,
        around: (&AroundTags, Flow),
        wanted: &StillWanted<'_>,
    ) -> Option<usize> {
        let mut again: FxHashSet<TagKey> = change.tags.iter().chain(&self.volatile).cloned().collect();
        for &index in &change.networks {
            let network = context.networks.at(index);
            let named = network.facts().named.iter();
            again.extend(named.map(|named| key_of(context, network.scope, &named.key)));
        }
        context.at_address.add_names(context, &mut again);
        let asking = self.latches.asking(again.iter()).cloned();
        let asking: Vec<TagKey> = asking.collect();
        again.extend(asking);
        if around.1.changed.has(set_and_reset::DECIDES) {
            again.extend(self.latches.all().cloned());
        }
        self.undeclared.follow(context, change, &mut again);
        let mut count = again.len();
        for key in again {
            wanted.one_more()?;
            self.look(context, key, around);
        }
        let again = self.undeclared.choose_suggested(context);
        count += again.len();
        for key in again {
            self.look(context, key, around);
        }
        Some(count)
    }

    fn look_at_all(
        &mut self,
        context: &Context,
        around: (&AroundTags, Flow),
        wanted: &StillWanted<'_>,
    ) -> Option<usize> {
        self.undeclared = UndeclaredTags::of(context, around.0.declares);
        for (scope, facts) in context.scopes.iter().enumerate() {
            for tag in facts.tags.iter().filter(|tag| !tag.leads_elsewhere()) {
                wanted.one_more()?;
                if let Some(address) = tag.rare.address.as_deref() {
                    self.addresses.set(&(scope, Name::new(&tag.name)), Some(address));
                }
                self.look_at(context, (scope, tag), around);
            }
        }
        Some(context.scopes.iter().map(|scope| scope.tags.len()).sum())
    }

    /// Looks at a tag again, which may be gone.
    fn look(&mut self, context: &Context, key: TagKey, around: (&AroundTags, Flow)) {
        let gone = self.found.remove(&key);
        self.exchanged.gone.extend(gone.into_iter().flatten());
        for tags in [&mut self.volatile, &mut self.faulty] {
            tags.remove(&key);
        }
        self.latches.forget(&key);
        self.read_above.forget(&key);
        self.undeclared.forget(&key);
        let tag = context.find_tag(&key).filter(|tag| !tag.leads_elsewhere());
        let address = tag.and_then(|tag| tag.rare.address.as_deref());
        self.addresses.set(&key, address);
        if let Some(tag) = tag {
            self.look_at(context, (key.0, tag), around);
        }
    }

    fn look_at(
        &mut self,
        context: &Context,
        (scope, tag): (usize, &TagFacts),
        (around, flow): (&AroundTags, Flow),
    ) {
        let mut found = Vec::new();
        let undeclaring = self.undeclared.undeclaring((scope, tag));
        let around = (around, &undeclaring);
        rules::of_tag(context, (scope, tag), around, &self.at_addresses, &mut found);
        let asked =
            set_and_reset::is_latch(tag).then(|| set_and_reset::check(context, flow.any, tag, &mut found));
        let late = read_before_write::Late::of(context, tag);
        if found.is_empty() && asked.is_none() && late.is_none() {
            return;
        }
        let key = (scope, Name::new(&tag.name));
        if found.iter().any(|found| found.rule == Rule::UndeclaredTag) {
            self.undeclared.note(&key);
        }
        if let Some(asked) = asked {
            let asked = asked.into_iter().map(|tag| key_at(context, tag));
            self.latches.note(&key, asked.collect());
        }
        if let Some(late) = late {
            self.read_above.note(&key, late);
        }
        if !found.is_empty() {
            self.keep(context, (key, tag), found);
        }
    }

    /// Keeps what is found at the places of a tag.
    fn keep(&mut self, context: &Context, (key, tag): (TagKey, &TagFacts), found: Vec<Diagnostic>) {
        let anchored = |found| Arc::new(Anchored::at_uses(found, tag, context));
        let found: Vec<Arc<Anchored>> = found.into_iter().map(anchored).collect();
        self.exchanged.new.extend(found.iter().cloned());
        if found.iter().any(|found| found.is_volatile()) {
            self.volatile.insert(key.clone());
        }
        if found.iter().any(|found| found.severity() == Severity::Error) {
            self.faulty.insert(key.clone());
        }
        let kept = self.found.entry(key).or_default();
        kept.reserve_exact(found.len());
        kept.extend(found);
    }

    /// Decides about the tags that are read above the rung that writes them, in a file that is known as a whole. `any` is what its
    /// networks have together of program flow. Gives how many were decided.
    pub(super) fn decide_read_above(
        &mut self,
        context: &Context,
        any: ControlFlow,
        shelf: &mut Shelf,
    ) -> usize {
        let decision = self.read_above.decide(context, any);
        for (key, is_found) in decision.other {
            let Some(tag) = context.find_tag(&key) else {
                continue;
            };
            if is_found {
                let found = read_before_write::found(context, tag);
                self.keep(context, (key, tag), found.into_iter().collect());
                continue;
            }
            let kept = self.found.remove(&key).unwrap_or_default();
            let is_it = |found: &Arc<Anchored>| found.rule() == Rule::ReadBeforeWrite;
            let (gone, kept): (Vec<_>, Vec<_>) = kept.into_iter().partition(is_it);
            self.exchanged.gone.extend(gone);
            if !kept.is_empty() {
                self.found.insert(key, kept);
            }
        }
        shelf.exchange(std::mem::take(&mut self.exchanged), Source::of_tag);
        decision.count
    }

    /// Whether a tag is undeclared that should not be.
    pub(super) fn any_undeclared(&self) -> bool {
        self.undeclared.any()
    }

    /// The errors among what is found.
    pub(super) fn errors(&self) -> impl Iterator<Item = &Arc<Anchored>> {
        let all = self.faulty.iter().filter_map(|key| self.found.get(key));
        all.flatten().filter(|found| found.severity() == Severity::Error)
    }

    /// What is found with places that are true for one text only.
    pub(super) fn volatile(&self) -> impl Iterator<Item = &Arc<Anchored>> {
        let all = self.volatile.iter().filter_map(|key| self.found.get(key));
        all.flatten().filter(|found| found.is_volatile())
    }

    /// The tags whose addresses have to do with others: they are the same, or overlap.
    pub(super) fn addressed<'c>(&self, context: &'c Context) -> impl Iterator<Item = &'c TagFacts> {
        tags_of(context, self.addresses.involved())
    }
}

/// The key of the tag that a name of a scope means: of what leads to a tag of the file that tag's.
fn key_of(context: &Context, scope: usize, name: &Name) -> TagKey {
    let tags = &context.scopes[scope];
    let entry = tags.find(name).map(|tag| &tags.tags[tag]);
    match entry.and_then(|entry| context.leads_to(entry)) {
        Some(tag) => key_at(context, tag),
        None => (scope, name.clone()),
    }
}

/// The key of a tag by its scope and place there.
fn key_at(context: &Context, (scope, tag): (usize, usize)) -> TagKey {
    (scope, Name::new(&context.scopes[scope].tags[tag].name))
}

/// Tags in their order.
fn tags_of<'c, 'k>(
    context: &'c Context,
    keys: impl IntoIterator<Item = &'k TagKey>,
) -> impl Iterator<Item = &'c TagFacts> {
    let places = keys
        .into_iter()
        .filter_map(|(scope, name)| Some((*scope, context.scopes[*scope].find(name)?)));
    let places: BTreeSet<(usize, usize)> = places.collect();
    places
        .into_iter()
        .map(|(scope, tag)| &context.scopes[scope].tags[tag])
}
