//! How a block uses a tag.

/// How a block uses a tag.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Access {
    Read,
    Write,
    ReadWrite,
}

impl Access {
    /// Whether the block reads it.
    pub const fn reads(self) -> bool {
        !matches!(self, Access::Write)
    }

    /// Whether the block writes it.
    pub const fn writes(self) -> bool {
        !matches!(self, Access::Read)
    }
}
