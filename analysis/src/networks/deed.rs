//! What a place does with a tag, as people are told it.

use super::access::Access;
use super::use_kind::Effect;

/// What a place does with a tag.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[allow(missing_docs)]
pub enum Deed {
    Read,
    Write,
    /// `(S)`.
    Set,
    /// `(R)`.
    Reset,
    /// Both: `[ADD]( n, n, 1 )` in one place, a timer, an in-out.
    ReadWrite,
}

impl Deed {
    pub(crate) const fn of(access: Access, effect: Effect) -> Deed {
        match (effect, access) {
            (Effect::Sets, _) => Deed::Set,
            (Effect::Resets, _) => Deed::Reset,
            (_, Access::Read) => Deed::Read,
            (_, Access::Write) => Deed::Write,
            (_, Access::ReadWrite) => Deed::ReadWrite,
        }
    }

    /// In words.
    pub const fn words(self) -> &'static str {
        match self {
            Deed::Read => "read",
            Deed::Write => "write",
            Deed::Set => "set",
            Deed::Reset => "reset",
            Deed::ReadWrite => "read and write",
        }
    }

    /// Whether the tag gets a value.
    pub const fn writes(self) -> bool {
        !matches!(self, Deed::Read)
    }

    /// Whether its value is asked for.
    pub const fn reads(self) -> bool {
        matches!(self, Deed::Read | Deed::ReadWrite)
    }
}
