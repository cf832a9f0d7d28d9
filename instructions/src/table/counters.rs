//! Counters (LANGUAGE §5.3).

use crate::{Accepts, Acts, Group, Instruction, Op, Operand, Role, Shape, StateType};

/// What the rows of this section share.
const BASE: Instruction = Instruction {
    op: Op::Ctu,
    mnemonic: "",
    synonyms: &[],
    aliases: &[],
    shape: Shape::Logical,
    role: Role::Acting,
    acts: Acts::Always,
    group: Group::State,
    operands: &[],
    eno: "Q",
    title: "",
    doc: "",
    example: "",
};

const PV: Operand = Operand::input("PV", Accepts::Count, "The preset value.");
const RESET: Operand = Operand::input("R", Accepts::Bool, "The reset to 0, while it is high.").named();
const LOAD: Operand = Operand::input("LD", Accepts::Bool, "Loads PV, while it is high.").named();
const COUNT_DOWN: Operand = Operand::input("CD", Accepts::Bool, "Counts down when it rises.").named();

pub(super) const ROWS: &[Instruction] = &[
    Instruction {
        op: Op::Ctu,
        mnemonic: "CTU",
        title: "Up counter",
        operands: &[
            Operand::in_out(
                "c",
                Accepts::State(StateType::Ctu),
                "The counter's tag, of type CTU.",
            ),
            PV,
            RESET,
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Ctd,
        mnemonic: "CTD",
        title: "Down counter",
        operands: &[
            Operand::in_out(
                "c",
                Accepts::State(StateType::Ctd),
                "The counter's tag, of type CTD.",
            ),
            PV,
            LOAD,
            RESET,
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Ctud,
        mnemonic: "CTUD",
        title: "Up-down counter",
        operands: &[
            Operand::in_out(
                "c",
                Accepts::State(StateType::Ctud),
                "The counter's tag, of type CTUD.",
            ),
            PV,
            COUNT_DOWN,
            RESET,
            LOAD,
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Ctc,
        mnemonic: "CTC",
        title: "Circular counter",
        operands: &[
            Operand::in_out(
                "c",
                Accepts::State(StateType::Ctc),
                "The counter's tag, of type CTC.",
            ),
            PV,
            RESET,
        ],
        doc: "",
        example: "",
        ..BASE
    },
];
