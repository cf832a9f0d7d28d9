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
pub struct Outward {
    /// Tags that it does not declare for itself.
    pub tags: FxHashMap<Name, TagUse>,
    /// Functions that it calls and does not hold.
    pub calls: FxHashSet<Name>,
}

impl Outward {
    pub(crate) fn of(context: &Context) -> Outward {
        let mut outward = Outward::default();
        let calls = |network: &NetworkAt<'_>| network.control_flow.has(ControlFlow::CALL);
        if context.may_call {
            for network in context.networks.iter().filter(calls) {
                outward.blocks(context, network);
            }
        }
        if context.settled {
            outward.found(context);
        } else {
            for network in &context.networks {
                outward.names(context, network, &network.named);
            }
        }
        let unread = |line: &&ladder_syntax::Line| !line.errors.is_empty() || line.kind == LineKind::Stray;
        let faulty = context.parse.lines().of_parts_that(Part::is_faulty);
        for line in faulty.map(|(_, line)| line).filter(unread) {
            for word in identifiers(line.text()) {
                outward.anything(Name::new(word));
            }
        }
        outward
    }

    /// As [`Outward::names`] of all networks, where every tag is the file's own but those that uses have brought in.
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

    /// The names that two texts of a file do not use alike.
    pub(crate) fn differing<'o>(&'o self, other: &'o Outward) -> impl Iterator<Item = &'o Name> {
        let one_way = |a: &'o Outward, b: &'o Outward| {
            let tags = a
                .tags
                .iter()
                .filter(|(name, used)| b.tags.get(*name) != Some(*used));
            let calls = a.calls.iter().filter(|name| !b.calls.contains(*name));
            tags.map(|(name, _)| name).chain(calls)
        };
        one_way(self, other).chain(one_way(other, self))
    }
}
