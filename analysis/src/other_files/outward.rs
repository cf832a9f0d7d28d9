//! What a file does with names that it does not hold itself: tags that may be VAR_GLOBAL tags of the workspace, and
//! functions that it calls. Rules about what nobody uses ask all files for it (LANGUAGE §7).
//!
//! Like all that a file shows to others it follows from the file's own text. Where that cannot be read, every word
//! counts as read, written and called: better no finding than a wrong one.

use crate::context::Context;
use crate::control_flow::ControlFlow;
use crate::network::Meaning;
use crate::networks::NetworkAt;
use crate::scope::Access;
use crate::unread_line::identifiers;
use ladder_instructions::Op;
use ladder_syntax::{LineKind, Name, Part};
use rustc_hash::{FxHashMap, FxHashSet};

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
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Outward {
    /// Tags that it does not declare for itself. The words on lines that cannot be read are among them: tags of these names may
    /// be used in any way.
    pub(crate) tags: FxHashMap<Name, TagUse>,
    /// Functions that it calls and does not hold.
    pub(crate) calls: FxHashSet<Name>,
}

impl Outward {
    pub(crate) fn of(context: &Context) -> Outward {
        let mut outward = Outward::default();
        for network in &context.networks {
            names(context, network, &mut outward.tags);
            if network.control_flow.has(ControlFlow::CALL) {
                calls(context, network, &mut outward.calls);
            }
        }
        for word in unread_words(context) {
            outward.tags.insert(word.clone(), TagUse::BOTH);
            outward.calls.insert(word);
        }
        outward
    }

    /// The tags that two texts of a file do not use alike.
    pub(crate) fn differing_tags<'o>(&'o self, other: &'o Outward) -> impl Iterator<Item = &'o Name> {
        let only_here = self
            .tags
            .iter()
            .filter(|(name, used)| other.tags.get(*name) != Some(*used));
        let only_there = other.tags.keys().filter(|name| !self.tags.contains_key(*name));
        only_here.map(|(name, _)| name).chain(only_there)
    }
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

/// The functions that a network calls and the file does not hold.
fn calls(context: &Context, network: NetworkAt<'_>, calls: &mut FxHashSet<Name>) {
    for bound in network.blocks().filter(|bound| bound.op() == Some(Op::Call)) {
        if let Some((name, _)) = bound.facts.first_name() {
            let key = Name::new(name);
            if context.function(&key).is_none() {
                calls.insert(key);
            }
        }
    }
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
