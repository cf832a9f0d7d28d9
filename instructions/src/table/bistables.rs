//! Bistables (LANGUAGE §5.3).

use crate::instruction::{Acts, Group, Instruction, Role, Shape};
use crate::op::Op;
use crate::operand::{Accepts, Operand, StateType};
use crate::power::Power;
use crate::profile::Profiles;

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
    profiles: Profiles::ALL,
    differs: &[],
    power: Power::Output,
    coil: None,
    eno: "Q1",
    title: "",
    doc: "",
    example: "",
};

pub(super) const ROWS: &[Instruction] = &[
    Instruction {
        op: Op::Sr,
        mnemonic: "SR",
        profiles: Profiles::OWN,
        title: "Set-dominant bistable",
        operands: &[
            Operand::in_out(
                "b",
                Accepts::State(StateType::Sr),
                "The bistable's tag, of type SR.",
            ),
            Operand::input("R", Accepts::Bool, "The reset; the set, EN, is stronger.").named(),
        ],
        doc: "Q1 goes high with EN and stays high until R; if both are high, Q1 is high.

The set, EN, is the stronger. ENO is Q1; other rungs read `b.Q1`. Use `[RS]` where the reset must win, as
for a stop button.

IEC 61131-3: SR.",
        example: "VAR_INPUT
    too_hot, acknowledge : BOOL;
END_VAR
VAR
    hot : SR;
END_VAR
VAR_OUTPUT
    alarm : BOOL;
END_VAR

+--[ ]( too_hot )-----------------[SR]( hot, R := acknowledge )--( )( alarm )--+",
        ..BASE
    },
    Instruction {
        op: Op::Rs,
        mnemonic: "RS",
        profiles: Profiles::OWN,
        title: "Reset-dominant bistable",
        operands: &[
            Operand::in_out(
                "b",
                Accepts::State(StateType::Rs),
                "The bistable's tag, of type RS.",
            ),
            Operand::input("R", Accepts::Bool, "The reset; it is stronger than the set, EN.").named(),
        ],
        doc: "Q1 goes high with EN and stays high until R; if both are high, Q1 is low.

The reset, R, is the stronger. ENO is Q1; other rungs read `b.Q1`. Use `[SR]` where the set must win, as for
an alarm that still is.

IEC 61131-3: RS.",
        example: "VAR_INPUT
    start, stop : BOOL;
END_VAR
VAR
    motor : RS;
END_VAR
VAR_OUTPUT
    run : BOOL;
END_VAR

+--[ ]( start )------[RS]( motor, R := stop )--( )( run )--+",
        ..BASE
    },
];
