//! Bistables (LANGUAGE §5.3).

use crate::{Accepts, Acts, Group, Instruction, Op, Operand, Role, Shape, StateType};

/// What the rows of this section share.
const BASE: Instruction = Instruction {
    op: Op::Sr,
    mnemonic: "",
    synonyms: &[],
    aliases: &[],
    shape: Shape::Logical,
    role: Role::Acting,
    acts: Acts::Always,
    group: Group::State,
    operands: &[],
    eno: "Q1",
    title: "",
    doc: "",
    example: "",
};

pub(super) const ROWS: &[Instruction] = &[
    Instruction {
        op: Op::Sr,
        mnemonic: "SR",
        title: "Set-dominant bistable",
        operands: &[
            Operand::in_out(
                "b",
                Accepts::State(StateType::Sr),
                "The bistable's tag, of type SR.",
            ),
            Operand::input("R", Accepts::Bool, "The reset; the set, EN, is stronger.").named(),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Rs,
        mnemonic: "RS",
        title: "Reset-dominant bistable",
        operands: &[
            Operand::in_out(
                "b",
                Accepts::State(StateType::Rs),
                "The bistable's tag, of type RS.",
            ),
            Operand::input("R", Accepts::Bool, "The reset; it is stronger than the set, EN.").named(),
        ],
        doc: "",
        example: "",
        ..BASE
    },
];
