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
    /// User-defined blocks that it uses and does not hold.
    pub(crate) blocks: FxHashSet<Name>,
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
