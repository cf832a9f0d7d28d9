//! The things on a row of a network.

use ladder_syntax::{TextRange, TextSize};

/// What a thing on a row is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ItemKind {
    LeftRail,
    RightRail,
    Down,
    Up,
    /// A block; its number in the network's facts, or none for a new one.
    Block(Option<usize>),
    Comment,
    /// A wire that ends at nothing.
    Stub,
    /// A `|` that the wire at either end of a row reaches to.
    Bar,
    /// In a term: a branch ends there, and nothing is drawn.
    Open,
    /// A place that an operation is about; it is gone before anything is drawn.
    Mark(Mark),
}

/// What an operation marks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Mark {
    /// Where something begins, or is put in.
    From,
    /// Where it ends, or goes to.
    To,
}

/// One thing on a row.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Item {
    pub(crate) kind: ItemKind,
    pub(crate) text: String,
    /// Whether wire joins it to the item before it.
    pub(crate) joined: bool,
    /// Where it is in the file, unless it is new.
    pub(crate) at: TextRange,
}

impl Item {
    pub(crate) fn new(kind: ItemKind, text: impl Into<String>, joined: bool) -> Item {
        Item {
            kind,
            text: text.into(),
            joined,
            at: TextRange::empty(TextSize::new(0)),
        }
    }

    pub(crate) fn left_rail() -> Item {
        Item::new(ItemKind::LeftRail, "+", false)
    }

    pub(crate) fn right_rail() -> Item {
        Item::new(ItemKind::RightRail, "+", true)
    }

    pub(crate) fn down() -> Item {
        Item::new(ItemKind::Down, "\\", true)
    }

    pub(crate) fn up(joined: bool) -> Item {
        Item::new(ItemKind::Up, "/", joined)
    }

    pub(crate) fn block(text: impl Into<String>) -> Item {
        Item::new(ItemKind::Block(None), text, true)
    }

    pub(crate) fn is_block(&self) -> bool {
        matches!(self.kind, ItemKind::Block(_))
    }

    /// Whether it is not in the file, or was taken from its place there.
    pub(crate) fn is_new(&self) -> bool {
        self.at.is_empty()
    }

    /// Whether a branch ends there by itself.
    pub(crate) fn is_end(&self) -> bool {
        matches!(
            self.kind,
            ItemKind::RightRail | ItemKind::Stub | ItemKind::Bar | ItemKind::Open
        )
    }

    /// A comment that is not a piece of a wire. It joins nothing, and what is after it is not joined to it.
    pub(crate) fn is_loose(&self, next: Option<&Item>) -> bool {
        self.kind == ItemKind::Comment && !self.joined && next.is_none_or(|next| !next.joined)
    }
}
