//! What a file does with names that it does not hold itself: tags that may be VAR_GLOBAL tags of the workspace, and
//! functions that it calls. Rules about what nobody uses ask all files for it (LANGUAGE §7).
//!
//! Like all that a file shows to others it follows from the file's own text. Where that cannot be read, every word
//! counts as read, written and called: better no finding than a wrong one.

use crate::context::Context;
use crate::control_flow::ControlFlow;
use crate::facts::NodeKind;
use crate::network::Meaning;
use crate::networks::NetworkAt;
use crate::scope::{Access, Origin, SectionKind};
use crate::unread_line::identifiers;
use crate::uses::Named;
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
    tags: OnceLock<FxHashMap<Name, TagUse>>,
    /// What says which they are, until then.
    context: Mutex<Option<Arc<Context>>>,
    /// Functions that it calls and does not hold.
    pub calls: FxHashSet<Name>,
}

impl Outward {
    pub(crate) fn of(context: &Context) -> Outward {
        let (tags, calls) = all(context);
        Outward {
            tags: OnceLock::from(tags),
            context: Mutex::default(),
            calls,
        }
    }

    /// The same, of a file in which somebody types: as long as no file has VAR_GLOBAL tags nobody asks for its tags.
    pub(crate) fn later_of(context: &Arc<Context>) -> Outward {
        if !context.settled {
            return Outward::of(context);
        }
        let mut found = Found::default();
        found.calls(context);
        found.unread_words(context);
        Outward {
            tags: OnceLock::new(),
            context: Mutex::new(Some(Arc::clone(context))),
            calls: found.calls,
        }
    }

    /// Tags that the file does not declare for itself.
    pub fn tags(&self) -> &FxHashMap<Name, TagUse> {
        self.tags.get_or_init(|| {
            let context = self.context.lock().unwrap_or_else(PoisonError::into_inner).take();
            context.map(|context| all(&context).0).unwrap_or_default()
        })
    }

    /// Whether two texts of a file surely use all names alike: said without a look at tags that nobody has asked for.
    pub(crate) fn is_surely(&self, other: &Outward) -> bool {
        let tags = self.tags.get().zip(other.tags.get());
        self.calls == other.calls && tags.is_some_and(|(tags, others)| tags == others)
    }

    /// The functions that two texts of a file do not call alike.
    pub(crate) fn differing_calls<'o>(&'o self, other: &'o Outward) -> impl Iterator<Item = &'o Name> {
        self.calls.symmetric_difference(&other.calls)
    }
}

impl PartialEq for Outward {
    fn eq(&self, other: &Outward) -> bool {
        self.calls == other.calls && self.tags() == other.tags()
    }
}

/// The tags and the functions.
fn all(context: &Context) -> (FxHashMap<Name, TagUse>, FxHashSet<Name>) {
    let mut found = Found::default();
    found.calls(context);
    if context.settled {
        found.found(context);
    } else {
        for network in &context.networks {
            found.names(context, network, &network.named);
        }
    }
    found.unread_words(context);
    (found.tags, found.calls)
}

/// What is being gathered.
#[derive(Default)]
struct Found {
    tags: FxHashMap<Name, TagUse>,
    calls: FxHashSet<Name>,
}

impl Found {
    fn calls(&mut self, context: &Context) {
        let calls = |network: &NetworkAt<'_>| network.control_flow.has(ControlFlow::CALL);
        if context.may_call {
            for network in context.networks.iter().filter(calls) {
                self.blocks(context, network);
            }
        }
    }

    fn unread_words(&mut self, context: &Context) {
        let unread = |line: &&ladder_syntax::Line| !line.errors.is_empty() || line.kind == LineKind::Stray;
        let faulty = context.parse.lines().of_parts_that(Part::is_faulty);
        for line in faulty.map(|(_, line)| line).filter(unread) {
            for word in identifiers(line.text()) {
                self.anything(Name::new(word));
            }
        }
    }

    /// As [`Found::names`] of all networks, where every tag is the file's own but those that uses have brought in.
    fn found(&mut self, context: &Context) {
        let found = context
            .scopes
            .iter()
            .flat_map(|scope| scope.tags.from(scope.declared));
        for tag in found.filter(|tag| !tag.name.starts_with('%')) {
            let used = tag.uses.0.iter().map(|place| {
                let known = match context.networks.block_of(*place).meaning {
                    Meaning::Instruction(_) => true,
                    Meaning::User(block) => context.user_blocks[block].import.is_none(),
                    Meaning::Unknown | Meaning::UnknownUser => false,
                };
                if known {
                    TagUse::of(place.access())
                } else {
                    TagUse::BOTH
                }
            });
            self.tags
                .insert(Name::new(&tag.name), used.fold(TagUse::default(), TagUse::with));
        }
    }

    fn names(&mut self, context: &Context, network: NetworkAt<'_>, named: &[Named]) {
        let scope = &context.scopes[network.scope];
        for named in named {
            let own = scope.find(&named.key).is_some_and(|tag| {
                matches!(
                    scope.tags[tag].origin,
                    Origin::Implicit
                        | Origin::Declared(
                            SectionKind::Var | SectionKind::Input | SectionKind::Output | SectionKind::InOut
                        )
                )
            });
            if own || named.key.as_str().starts_with('%') {
                continue;
            }
            // What a block of another file does with its operands that file says.
            let is_known = match network.blocks[named.block as usize].meaning {
                Meaning::Instruction(_) => true,
                Meaning::User(block) => context.user_blocks[block].import.is_none(),
                Meaning::Unknown | Meaning::UnknownUser => false,
            };
            let used = if is_known {
                TagUse::of(named.access)
            } else {
                TagUse::BOTH
            };
            let entry = self.tags.entry(named.key.clone()).or_default();
            *entry = entry.with(used);
        }
    }

    fn blocks(&mut self, context: &Context, network: NetworkAt<'_>) {
        for bound in network.blocks() {
            let name = bound.facts.operands.first().map(|operand| &operand.value.kind);
            if let (Some(Op::Call), Some(NodeKind::Name(name))) = (bound.op(), name) {
                let key = Name::new(name);
                if context.function(&key).is_none() {
                    self.calls.insert(key);
                }
            }
        }
    }

    fn anything(&mut self, word: Name) {
        self.tags.insert(word.clone(), TagUse::BOTH);
        self.calls.insert(word);
    }
}
