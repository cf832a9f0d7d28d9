//! The places where tags are in operands.

use super::access_kind::AccessKind;
use super::use_kind::{Effect, Extent, UseKind};
use crate::program::Access;
use ladder_syntax::TextRange;
use smallvec::SmallVec;

/// One place where a tag is in an operand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Use {
    /// The network, as in the structure.
    pub network: usize,
    /// The block in it.
    pub block: usize,
    /// The operand in it.
    pub operand: usize,
    /// Where the tag's name is, from the start of the file.
    pub range: TextRange,
    /// How it is used.
    pub access: Access,
    /// Whether the tag as a whole is meant, not a member, bit or element.
    pub whole: bool,
    /// Whether an index or a range is after it.
    pub indexed: bool,
}

/// A use as a tag keeps it: it stays true when other networks are above it, and says without a look at its block how the tag
/// is used.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct UseRef {
    /// The number of the network; see [`Networks`](crate::networks::Networks).
    pub(crate) network: u32,
    /// Which of the names in it, and in the lowest bits how it is used.
    named: u32,
}

impl UseRef {
    /// A name of a network, which has fewer than 2^25 of them: each takes two bytes of a file of at most 64 MiB.
    pub(crate) const fn new(network: u32, named: u32, kind: UseKind) -> UseRef {
        UseRef {
            network,
            named: named << UseKind::BITS | kind.bits(),
        }
    }

    /// Which of the names in its network.
    pub(crate) const fn named(self) -> u32 {
        self.named >> UseKind::BITS
    }

    /// Whether it reads or writes the tag.
    pub(crate) const fn access(self) -> Access {
        UseKind::from_bits(self.named).access()
    }

    /// Which part of the tag is meant.
    pub(crate) const fn extent(self) -> Extent {
        UseKind::from_bits(self.named).extent()
    }

    /// What people are told that it does with the tag.
    pub(crate) const fn access_kind(self) -> AccessKind {
        AccessKind::of(self.access(), self.effect())
    }

    /// What its block does with the operand.
    pub(crate) const fn effect(self) -> Effect {
        UseKind::from_bits(self.named).effect()
    }
}

/// Where a tag is used, from top to bottom. Most tags are used once or twice.
#[derive(Debug, Clone, Default)]
pub struct Uses(pub(crate) SmallVec<[UseRef; 2]>);

impl Uses {
    /// How many places there are.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether it is used nowhere.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The places that write it.
    pub(crate) fn writers(&self) -> impl Iterator<Item = UseRef> {
        self.0.iter().copied().filter(|place| place.access().writes())
    }

    /// What each place does with it.
    pub fn access_kinds(&self) -> impl Iterator<Item = AccessKind> {
        self.0.iter().map(|place| place.access_kind())
    }

    /// How each place uses it.
    pub fn accesses(&self) -> impl Iterator<Item = Access> {
        self.0.iter().map(|place| place.access())
    }
}
