//! What networks have of program flow: the rules about the whole program look no further where there is none.

use crate::networks::network::{BoundBlock, Meaning};
use ladder_instructions::{Coil, Op, Shape};

/// What in a network moves the program on to another place than the next network, or can, as bits; and its coils.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct ControlFlow(u16);

impl ControlFlow {
    pub(crate) const JUMP: ControlFlow = ControlFlow(1);
    pub(crate) const RETURN: ControlFlow = ControlFlow(1 << 1);
    pub(crate) const END: ControlFlow = ControlFlow(1 << 2);
    pub(crate) const FOR: ControlFlow = ControlFlow(1 << 3);
    pub(crate) const NEXT: ControlFlow = ControlFlow(1 << 4);
    pub(crate) const MCR: ControlFlow = ControlFlow(1 << 5);
    pub(crate) const CALL: ControlFlow = ControlFlow(1 << 6);
    /// A user-defined block in the shape `<$B>`, which may jump, return and end.
    pub(crate) const FLOW_BLOCK: ControlFlow = ControlFlow(1 << 7);
    /// Any other user-defined block.
    pub(crate) const USER_BLOCK: ControlFlow = ControlFlow(1 << 8);
    /// A coil, a set coil, a reset coil.
    pub(crate) const SET: ControlFlow = ControlFlow(1 << 9);
    pub(crate) const RESET: ControlFlow = ControlFlow(1 << 10);
    pub(crate) const COIL: ControlFlow = ControlFlow(1 << 11);
    /// A label, or the beginning of a function.
    pub(crate) const MARK: ControlFlow = ControlFlow(1 << 12);
    /// What can leave a network before its end.
    pub(crate) const LEAVES: ControlFlow = ControlFlow(
        ControlFlow::JUMP.0 | ControlFlow::RETURN.0 | ControlFlow::END.0 | ControlFlow::FLOW_BLOCK.0,
    );

    /// Whether one of these is there.
    pub(crate) const fn has(self, other: ControlFlow) -> bool {
        self.0 & other.0 != 0
    }

    /// Both together.
    pub(crate) const fn with(self, other: ControlFlow) -> ControlFlow {
        ControlFlow(self.0 | other.0)
    }

    /// What one block adds.
    pub(crate) fn of(bound: &BoundBlock) -> ControlFlow {
        match bound.meaning {
            Meaning::Instruction(row) => match row.op {
                Op::Jmp => ControlFlow::JUMP,
                Op::Ret => ControlFlow::RETURN,
                Op::End => ControlFlow::END,
                Op::For => ControlFlow::FOR,
                Op::Next => ControlFlow::NEXT,
                Op::Mcr => ControlFlow::MCR,
                Op::Call => ControlFlow::CALL,
                Op::Lbl | Op::Fun => ControlFlow::MARK,
                _ => match row.coil {
                    Some(Coil::Sets) => ControlFlow::SET,
                    Some(Coil::Resets) => ControlFlow::RESET,
                    Some(Coil::Follows | Coil::Negated) => ControlFlow::COIL,
                    Some(Coil::OnEdge(_)) | None => ControlFlow::default(),
                },
            },
            Meaning::User(_) | Meaning::UnknownUser if bound.facts.shape == Shape::Function => {
                ControlFlow::FLOW_BLOCK
            }
            Meaning::User(_) | Meaning::UnknownUser => ControlFlow::USER_BLOCK,
            Meaning::Unknown => ControlFlow::default(),
        }
    }
}
