//! What a file does with names that it does not hold itself: tags that may be VAR_GLOBAL tags of the workspace, and
//! functions that it calls. Rules about what nobody uses ask all files for it (LANGUAGE §7).
//!
//! Like all that a file shows to others it follows from the file's own text. Where that cannot be read, every word
//! counts as read, written and called: better no finding than a wrong one.

use crate::by_name::ByName;
use crate::context::Context;
use crate::network::Meaning;
use crate::networks::NetworkAt;
use crate::scope::{Access, Scope, TagFacts, UseRef};
use crate::unread_line::identifiers;
use ladder_instructions::Op;
use ladder_syntax::{LineKind, Name, Part};
use rustc_hash::{FxHashMap, FxHashSet};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// How a tag is used.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct TagUse {
    /// Something reads it.
    pub read: bool,
    /// Something writes it.
    pub written: bool,
}

impl TagUse {
    const BOTH: TagUse = TagUse {
        read: true,
        written: true,
    };

    pub(crate) const fn of(access: Access) -> TagUse {
        TagUse {
            read: access.reads(),
            written: access.writes(),
        }
    }

    pub(crate) const fn with(self, other: TagUse) -> TagUse {
        TagUse {
            read: self.read || other.read,
            written: self.written || other.written,
        }
    }
}

/// What a file does with what other files may hold.
#[derive(Debug, Default)]
pub struct Outward {
    /// Tags that it does not declare for itself, once somebody asks.
    tags: OnceLock<ByName<TagUse>>,
    /// What says which they are, until then.
    context: Mutex<Option<Arc<Context>>>,
    /// The words on lines that cannot be read: tags of these names may be used in any way.
    unread: FxHashSet<Name>,
    /// Functions that it calls and does not hold.
    pub calls: FxHashSet<Name>,
}

impl Outward {
    pub(crate) fn of(context: &Context) -> Outward {
        let outward = Outward::but_tags(context);
        let _ = outward.tags.set(context.outward_tags().clone());
        outward
    }

    /// The same, of a file in which somebody types: as long as no file has VAR_GLOBAL tags nobody asks for its tags.
    pub(crate) fn later_of(context: &Arc<Context>) -> Outward {
        Outward {
            context: Mutex::new(Some(Arc::clone(context))),
            ..Outward::but_tags(context)
        }
    }

    fn but_tags(context: &Context) -> Outward {
        let unread = unread_words(context);
        let mut calls = calls(context);
        calls.extend(unread.iter().cloned());
        Outward {
            unread,
            calls,
            ..Outward::default()
        }
    }

    fn named(&self) -> &ByName<TagUse> {
        self.tags.get_or_init(|| {
            let context = self.context.lock().unwrap_or_else(PoisonError::into_inner).take();
            context.map_or_else(ByName::default, |context| context.outward_tags().clone())
        })
    }

    /// Tags that the file does not declare for itself.
    pub(crate) fn tags(&self) -> impl Iterator<Item = (&Name, TagUse)> {
        let named = self.named().iter();
        let read = named.filter(|(name, _)| !self.unread.contains(*name));
        read.chain(self.unread.iter().map(|name| (name, TagUse::BOTH)))
    }

    /// How the file uses a tag that it does not declare for itself.
    fn tag(&self, name: &Name) -> Option<TagUse> {
        if self.unread.contains(name) {
            return Some(TagUse::BOTH);
        }
        self.named().get(name)
    }

    /// The tags that two texts of a file do not use alike.
    pub(crate) fn differing_tags<'o>(&'o self, other: &'o Outward) -> impl Iterator<Item = &'o Name> {
        let mut names = self.named().differing(other.named());
        names.extend(self.unread.symmetric_difference(&other.unread));
        names.into_iter().filter(|name| self.tag(name) != other.tag(name))
    }

    /// Whether two texts of a file surely use all names alike: said without a look at tags that nobody has asked for.
    pub(crate) fn is_surely(&self, other: &Outward) -> bool {
        self.tags.get().is_some() && other.tags.get().is_some() && self == other
    }

    /// The functions that two texts of a file do not call alike.
    pub(crate) fn differing_calls<'o>(&'o self, other: &'o Outward) -> impl Iterator<Item = &'o Name> {
        self.calls.symmetric_difference(&other.calls)
    }
}

impl PartialEq for Outward {
    fn eq(&self, other: &Outward) -> bool {
        self.calls == other.calls && self.differing_tags(other).next().is_none()
    }
}

/// How the file uses the tags that it does not declare for itself.
pub(crate) fn tags(context: &Context) -> ByName<TagUse> {
    let mut tags: FxHashMap<Name, TagUse> = FxHashMap::default();
    if context.settled {
        let tags_of_all = context.scopes.iter().flat_map(Scope::unusual);
        // What an entry of a body leads to has the body's uses too.
        for (_, tag) in tags_of_all.filter(|(_, tag)| !tag.leads_elsewhere()) {
            if let Some(used) = use_of(context, tag) {
                let entry = tags.entry(Name::new(&tag.name)).or_default();
                *entry = entry.with(used);
            }
        }
    } else {
        for network in &context.networks {
            names(context, network, &mut tags);
        }
    }
    ByName::from(tags)
}

/// How the file uses tags of a name, where an edit has just concerned one. None: it does not, or declares them for itself.
pub(crate) fn tag(context: &Context, name: &Name) -> Option<TagUse> {
    let tags = context.outward_named(name);
    tags.filter_map(|tag| use_of(context, tag)).reduce(TagUse::with)
}

/// The same of one tag.
fn use_of(context: &Context, tag: &TagFacts) -> Option<TagUse> {
    if !tag.is_outward() || tag.name.starts_with('%') {
        return None;
    }
    // What is declared at an address can be named by it.
    let by_name = |place: &&UseRef| {
        tag.rare.address.is_none() || {
            let network = context.networks.at(context.networks.index_of(place.network));
            let named = &network.facts().named[place.named() as usize];
            !named.key.as_str().starts_with('%')
        }
    };
    let used = tag.uses.0.iter().filter(by_name).map(|place| {
        let bound = context.networks.block_of(*place);
        at(context, bound.meaning, place.access())
    });
    used.reduce(TagUse::with)
}

/// What the names of a network add.
fn names(context: &Context, network: NetworkAt<'_>, tags: &mut FxHashMap<Name, TagUse>) {
    let scope = &context.scopes[network.scope];
    for named in &network.named {
        let own = scope
            .find(&named.key)
            .is_some_and(|tag| !scope.tags[tag].is_outward());
        if own || named.key.as_str().starts_with('%') {
            continue;
        }
        let meaning = network.blocks[named.block as usize].meaning;
        let used = at(context, meaning, named.kind.access());
        let entry = tags.entry(named.key.clone()).or_default();
        *entry = entry.with(used);
    }
}

/// How a place uses its tag. What a block of another file does with its operands that file says.
fn at(context: &Context, meaning: Meaning, access: Access) -> TagUse {
    let known = match meaning {
        Meaning::Instruction(_) => true,
        Meaning::User(block) => context.user_blocks[block].import.is_none(),
        Meaning::Unknown | Meaning::UnknownUser => false,
    };
    if known { TagUse::of(access) } else { TagUse::BOTH }
}

/// The functions that it calls and does not hold.
fn calls(context: &Context) -> FxHashSet<Name> {
    let mut calls = FxHashSet::default();
    let networks = context.calling.iter();
    let networks = networks.map(|&id| context.networks.at(context.networks.index_of(id)));
    for bound in networks.flat_map(NetworkAt::blocks) {
        if let (Some(Op::Call), Some((name, _))) = (bound.op(), bound.facts.first_name()) {
            let key = Name::new(name);
            if context.function(&key).is_none() {
                calls.insert(key);
            }
        }
    }
    calls
}

/// The words on lines that cannot be read.
fn unread_words(context: &Context) -> FxHashSet<Name> {
    let unread = |line: &&ladder_syntax::Line| !line.errors.is_empty() || line.kind == LineKind::Stray;
    let faulty = context.parse.lines().of_parts_that(Part::is_faulty);
    let lines = faulty.map(|(_, line)| line).filter(unread);
    lines
        .flat_map(|line| identifiers(line.text()).map(Name::new))
        .collect()
}
