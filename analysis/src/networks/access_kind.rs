//! What a place does with a tag, as people are told it.

use super::use_kind::Effect;
use crate::program::Access;

/// What a place does with a tag.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[allow(missing_docs)]
pub enum AccessKind {
    Read,
    Write,
    /// `(S)`.
    Set,
    /// `(R)`.
    Reset,
    /// Both: `[ADD]( n, n, 1 )` in one place, a timer, an in-out.
    ReadWrite,
}

impl AccessKind {
    pub(crate) const fn of(access: Access, effect: Effect) -> AccessKind {
        match (effect, access) {
            (Effect::Sets, _) => AccessKind::Set,
            (Effect::Resets, _) => AccessKind::Reset,
            (_, Access::Read) => AccessKind::Read,
            (_, Access::Write) => AccessKind::Write,
            (_, Access::ReadWrite) => AccessKind::ReadWrite,
        }
    }

    /// In words.
    pub const fn words(self) -> &'static str {
        match self {
            AccessKind::Read => "read",
            AccessKind::Write => "write",
            AccessKind::Set => "set",
            AccessKind::Reset => "reset",
            AccessKind::ReadWrite => "read and write",
        }
    }

    /// Whether the tag gets a value.
    pub const fn writes(self) -> bool {
        !matches!(self, AccessKind::Read)
    }

    /// Whether its value is asked for.
    pub const fn reads(self) -> bool {
        matches!(self, AccessKind::Read | AccessKind::ReadWrite)
    }
}
