//! How an operand uses a tag that it names, in a byte: noted with each use, so that the rules about a tag need not go to the
//! blocks that use it, of which each is somewhere else in memory.

use super::network::{BoundBlock, Formal};
use crate::program::Access;
use ladder_instructions::{Accepts, Coil};

/// How an operand uses a tag that it names.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct UseKind(u8);

/// Which part of its tag an operand means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Extent {
    Whole,
    Member,
    Elements,
}

/// What a block does with its operand, as far as it matters to the whole program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Effect {
    /// None of the others.
    Other,
    /// A coil that follows its power, plain or negated.
    Follows,
    /// A set coil.
    Sets,
    /// A reset coil.
    Resets,
    /// A coil that writes on an edge.
    OnEdge,
    /// A timer, counter or bistable that keeps its state there.
    KeepsState,
}

impl UseKind {
    /// This many bits hold one.
    pub(crate) const BITS: u32 = 7;

    const ACCESSES: [Access; 3] = [Access::Read, Access::Write, Access::ReadWrite];
    const EXTENTS: [Extent; 3] = [Extent::Whole, Extent::Member, Extent::Elements];
    const EFFECTS: [Effect; 6] = [
        Effect::Other,
        Effect::Follows,
        Effect::Sets,
        Effect::Resets,
        Effect::OnEdge,
        Effect::KeepsState,
    ];

    /// From its parts.
    pub(crate) const fn new(access: Access, extent: Extent, effect: Effect) -> UseKind {
        UseKind(access as u8 | (extent as u8) << 2 | (effect as u8) << 4)
    }

    /// The one that these bits hold.
    pub(crate) const fn from_bits(bits: u32) -> UseKind {
        UseKind((bits & ((1 << UseKind::BITS) - 1)) as u8)
    }

    /// Its bits.
    pub(crate) const fn bits(self) -> u32 {
        self.0 as u32
    }

    /// Whether the tag is read or written.
    pub(crate) const fn access(self) -> Access {
        UseKind::ACCESSES[(self.0 & 3) as usize]
    }

    /// Which part of the tag is meant.
    pub(crate) const fn extent(self) -> Extent {
        UseKind::EXTENTS[(self.0 >> 2 & 3) as usize]
    }

    /// What the block does.
    pub(crate) const fn effect(self) -> Effect {
        UseKind::EFFECTS[(self.0 >> 4) as usize]
    }
}

impl Effect {
    /// Of a block with an operand that is given for this.
    pub(crate) fn of(bound: &BoundBlock, formal: Formal) -> Effect {
        match (bound.coil(), formal) {
            (Some(Coil::Follows | Coil::Negated), _) => Effect::Follows,
            (Some(Coil::Sets), _) => Effect::Sets,
            (Some(Coil::Resets), _) => Effect::Resets,
            (Some(Coil::OnEdge(_)), _) => Effect::OnEdge,
            (None, Formal::Operand(row)) if matches!(row.accepts, Accepts::State(_)) => Effect::KeepsState,
            (None, Formal::Instance) => Effect::KeepsState,
            (None, _) => Effect::Other,
        }
    }

    /// Whether it is that of a coil.
    pub(crate) const fn is_coil(self) -> bool {
        matches!(
            self,
            Effect::Follows | Effect::Sets | Effect::Resets | Effect::OnEdge
        )
    }
}

#[cfg(test)]
mod tests {
    use super::UseKind;
    use ladder_instructions::{Accepts, TABLE};

    #[test]
    fn it_gives_its_parts_back() {
        for access in UseKind::ACCESSES {
            for extent in UseKind::EXTENTS {
                for effect in UseKind::EFFECTS {
                    let kind = UseKind::from_bits(UseKind::new(access, extent, effect).bits());
                    assert_eq!(
                        (kind.access(), kind.extent(), kind.effect()),
                        (access, extent, effect)
                    );
                }
            }
        }
    }

    #[test]
    fn no_coil_keeps_a_state() {
        let keeps = |accepts| matches!(accepts, Accepts::State(_));
        for row in TABLE.iter().filter(|row| row.coil.is_some()) {
            assert!(
                !row.operands.iter().any(|operand| keeps(operand.accepts)),
                "{row:?}"
            );
        }
    }
}
