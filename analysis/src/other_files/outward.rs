//! What a file does with names that it does not hold itself: tags that may be VAR_GLOBAL tags of the workspace, and
//! functions that it calls. Rules about what nobody uses ask all files for it (LANGUAGE §7).
//!
//! Like all that a file shows to others it follows from the file's own text. Where that cannot be read, every word
//! counts as read, written and called: better no finding than a wrong one.

use crate::program::Access;
use ladder_syntax::Name;
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
    pub(crate) const BOTH: TagUse = TagUse {
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

/// The operands of a block that another file defines.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(crate) struct Handed {
    /// How many are given by their place.
    pub(crate) by_place: usize,
    pub(crate) by_name: Vec<Name>,
}

impl Handed {
    /// Whether the block's state may be a tag, and keep the parameter of this number and name. Which of the first operands is a state
    /// is known where the block is.
    pub(crate) fn may_keep(&self, number: usize, name: &Name) -> bool {
        (1..=number + 1).contains(&self.by_place) && !self.by_name.contains(name)
    }
}

/// What a file does with what other files may hold.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Outward {
    /// Tags that it does not declare for itself. The words on lines that cannot be read are among them: tags of these names may
    /// be used in any way.
    pub(crate) tags: FxHashMap<Name, TagUse>,
    /// What the unread parts that it defines may do with all tags that they see.
    pub(crate) all_tags: TagUse,
    /// Functions that it calls and does not hold.
    pub(crate) calls: FxHashSet<Name>,
    /// User-defined blocks that it uses and does not hold, with what they are handed. Nothing is known of a word on a line that
    /// cannot be read.
    pub(crate) blocks: FxHashMap<Name, FxHashSet<Handed>>,
    /// Members of whatever structures, and the words on lines that cannot be read.
    pub(crate) members: FxHashMap<Name, TagUse>,
    /// Tags that may be structures and are used as a whole, or an element of them.
    pub(crate) wholes: FxHashSet<Name>,
}

impl Outward {
    /// Whether two texts of a file use members and whole structures alike.
    pub(crate) fn uses_parts_like(&self, other: &Outward) -> bool {
        self.members == other.members && self.wholes == other.wholes
    }

    /// The blocks that two texts of a file do not use alike.
    pub(crate) fn differing_blocks<'o>(&'o self, other: &'o Outward) -> impl Iterator<Item = &'o Name> {
        differing(&self.blocks, &other.blocks)
    }

    /// The tags that two texts of a file do not use alike.
    pub(crate) fn differing_tags<'o>(&'o self, other: &'o Outward) -> impl Iterator<Item = &'o Name> {
        differing(&self.tags, &other.tags)
    }
}

/// The names that only one of two maps has, or that mean something else there.
fn differing<'m, T: PartialEq>(
    one: &'m FxHashMap<Name, T>,
    other: &'m FxHashMap<Name, T>,
) -> impl Iterator<Item = &'m Name> {
    let only_here = one
        .iter()
        .filter(|(name, value)| other.get(*name) != Some(*value));
    let only_there = other.keys().filter(|name| !one.contains_key(*name));
    only_here.map(|(name, _)| name).chain(only_there)
}
