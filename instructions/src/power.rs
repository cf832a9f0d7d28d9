//! What a block does with power, as data: what leaves it, and what a coil writes.

/// What power leaves a block. A fault of an operand, such as an index outside its array, takes it away from any block.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Power {
    /// EN.
    Passes,
    /// EN, unless what the block does fails or is not done yet.
    PassesIfDone,
    /// EN while the first operand has this level; of a range, while every bit has it.
    Level {
        /// High, or low.
        high: bool,
    },
    /// EN in a scan in which the first operand changed.
    TagEdge(Edge),
    /// EN while the comparison holds.
    Compares,
    /// The opposite of EN.
    Inverts,
    /// High in a scan in which EN changed.
    EnEdge(Edge),
    /// The output of the timer, counter or bistable, whatever EN is.
    Output,
    /// The tag that the coil sets, or EN: [`Semantics::set_power`](crate::Semantics::set_power).
    SetTag,
}

impl Power {
    /// Whether it is that of a contact: it asks for nothing but the level, or a change, of its operand.
    pub const fn is_contact(self) -> bool {
        matches!(self, Power::Level { .. } | Power::TagEdge(_))
    }
}

/// A change of a bit from one scan to the next.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Edge {
    Rising,
    Falling,
}

/// What a coil writes into its bits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Coil {
    /// EN.
    Follows,
    /// The opposite of EN.
    Negated,
    /// High while EN is; nothing otherwise.
    Sets,
    /// Low while EN is high; nothing otherwise.
    Resets,
    /// High in a scan in which EN changed, low otherwise.
    OnEdge(Edge),
}
