//! Timers (LANGUAGE §5.3).

use crate::{Accepts, Acts, Group, Instruction, Op, Operand, Role, Shape, StateType};

/// What the rows of this section share.
const BASE: Instruction = Instruction {
    op: Op::Ton,
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

const PT: Operand = Operand::input(
    "PT",
    Accepts::Duration,
    "The preset time; a plain integer is milliseconds.",
);
const RESET: Operand = Operand::input("R", Accepts::Bool, "The reset, while it is high.").named();
const BASE_TIME: Operand = Operand::input(
    "B",
    Accepts::Time,
    "The time base that PT and ET count, in profile `iot` only.",
)
.named();

pub(super) const ROWS: &[Instruction] = &[
    Instruction {
        op: Op::Ton,
        mnemonic: "TON",
        title: "On-delay timer",
        operands: &[
            Operand::in_out(
                "t",
                Accepts::State(StateType::Ton),
                "The timer's tag, of type TON.",
            ),
            PT,
            RESET,
            BASE_TIME,
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Tof,
        mnemonic: "TOF",
        title: "Off-delay timer",
        operands: &[
            Operand::in_out(
                "t",
                Accepts::State(StateType::Tof),
                "The timer's tag, of type TOF.",
            ),
            PT,
            RESET,
            BASE_TIME,
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Tp,
        mnemonic: "TP",
        title: "Pulse timer",
        operands: &[
            Operand::in_out("t", Accepts::State(StateType::Tp), "The timer's tag, of type TP."),
            PT,
            RESET,
            BASE_TIME,
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Rto,
        mnemonic: "RTO",
        title: "Retentive on-delay timer",
        operands: &[
            Operand::in_out(
                "t",
                Accepts::State(StateType::Rto),
                "The timer's tag, of type RTO.",
            ),
            PT,
            RESET,
            BASE_TIME,
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Rtof,
        mnemonic: "RTOF",
        title: "Retentive off-delay timer",
        operands: &[
            Operand::in_out(
                "t",
                Accepts::State(StateType::Rtof),
                "The timer's tag, of type RTOF.",
            ),
            PT,
            RESET,
            BASE_TIME,
        ],
        doc: "",
        example: "",
        ..BASE
    },
];
