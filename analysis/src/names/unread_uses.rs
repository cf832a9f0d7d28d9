//! What the unread parts that a file defines or holds may do with its tags (LANGUAGE §5.9): such a tag counts as read, and it may be
//! as written.

use crate::names::scope::TagFacts;
use crate::networks::Networks;
use crate::networks::network::{BoundBlock, Meaning};
use crate::other_files::outward::TagUse;
use crate::program::{Unread, root_of};
use crate::written::user_block::UserBlockFacts;
use ladder_syntax::Name;
use rustc_hash::FxHashSet;

/// See the module.
#[derive(Debug, Clone, Default)]
pub(crate) struct UnreadUses {
    /// In the order of the scopes; empty if there is no unread part.
    scopes: Vec<Seen>,
    /// What is done with tags that several scopes or files share.
    shared: Seen,
}

/// What is done with the tags of a scope.
#[derive(Debug, Clone, Default)]
struct Seen {
    /// An unread part is there, which may read all of them.
    any: bool,
    /// One is there that does not say what it writes.
    writes_all: bool,
    /// What those write that say it.
    writes: FxHashSet<Name>,
}

impl Seen {
    fn add(&mut self, unread: &Unread) {
        self.any = true;
        match &unread.directive.writes {
            None => self.writes_all = true,
            Some(paths) => self
                .writes
                .extend(paths.iter().map(|path| Name::new(root_of(path)))),
        }
    }

    fn done_with(&self, tag: &TagFacts) -> TagUse {
        let is_named = || self.writes.contains(&Name::new(&tag.name));
        let has_named_address = || {
            tag.address()
                .is_some_and(|address| self.writes.contains(&address))
        };
        TagUse {
            read: self.any,
            written: self.writes_all || (!self.writes.is_empty() && (is_named() || has_named_address())),
        }
    }
}

impl UnreadUses {
    /// Of a file with so many scopes, the first blocks of which are its own.
    pub(crate) fn of(
        scopes: usize,
        (blocks, own): (&[UserBlockFacts], usize),
        networks: &Networks,
    ) -> UnreadUses {
        let mut uses = UnreadUses::default();
        if blocks.iter().all(|block| block.unread.is_none()) {
            return uses;
        }
        uses.scopes.resize_with(scopes, Seen::default);
        let own = blocks[..own].iter().enumerate();
        for (item, unread) in own.filter_map(|(item, block)| Some((item, block.unread.as_deref()?))) {
            let body = &mut uses.scopes[item + 1];
            (body.any, body.writes_all) = (true, true);
            uses.shared.add(unread);
            if unread.directive.at_any_time {
                uses.scopes[0].add(unread);
            }
        }
        for network in networks {
            for unread in network.blocks.iter().filter_map(|block| part(block, blocks)) {
                uses.scopes[network.scope].add(unread);
                uses.shared.add(unread);
            }
        }
        uses
    }

    /// Whether there is an unread part at all.
    pub(crate) fn any(&self) -> bool {
        self.shared.any
    }

    /// What unread parts may do with a tag of a scope.
    pub(crate) fn done_with(&self, scope: usize, tag: &TagFacts) -> TagUse {
        let Some(seen) = self.scopes.get(scope) else {
            return TagUse::default();
        };
        let own = seen.done_with(tag);
        if tag.is_outward() || tag.cold.address.is_some() {
            own.with(self.shared.done_with(tag))
        } else {
            own
        }
    }

    /// Whether one says by name that it writes a tag of a scope.
    pub(crate) fn names(&self, scope: usize, tag: &TagFacts) -> bool {
        let seen = self.scopes.get(scope);
        seen.is_some_and(|seen| !seen.writes.is_empty() && seen.writes.contains(&Name::new(&tag.name)))
    }
}

/// What is known of a block that is an unread part.
pub(crate) fn part<'b>(block: &BoundBlock, all: &'b [UserBlockFacts]) -> Option<&'b Unread> {
    match block.meaning {
        Meaning::User(index) => all[index].unread.as_deref(),
        _ => None,
    }
}
