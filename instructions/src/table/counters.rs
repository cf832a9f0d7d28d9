//! Counters (LANGUAGE §5.3).

use crate::instruction::{Acts, Group, Instruction, Role, Shape};
use crate::op::Op;
use crate::operand::{Accepts, Operand, StateType};
use crate::power::Power;
use crate::profile::{Profile, Profiles};

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
    profiles: Profiles::ALL,
    differs: &[(
        Profile::Logix,
        "The power after it is EN, and an EN that is high at the first evaluation is no rise. Programs of Logix have the block `$CTU` in its place, whose state is a structure that `$CTD` shares.",
    )],
    power: Power::Output,
    coil: None,
    eno: "Q",
    title: "",
    doc: "",
    example: "",
};

const PV: Operand = Operand::input("PV", Accepts::Count, "The preset value.");
const RESET: Operand = Operand::input("R", Accepts::Bool, "The reset to 0, while it is high.")
    .named()
    .known_to(Profiles::OWN);
const LOAD: Operand = Operand::input("LD", Accepts::Bool, "Loads PV, while it is high.")
    .named()
    .known_to(Profiles::OWN);
const COUNT_AT_FIRST: Operand = Operand::input(
    "AC",
    Accepts::Count,
    "What it counts from, at first and after a reset, in profile `iot` only.",
)
.named()
.known_to(Profiles::only(Profile::Iot));
const COUNT_DOWN: Operand = Operand::input("CD", Accepts::Bool, "Counts down when it rises.").named();

pub(super) const ROWS: &[Instruction] = &[
    Instruction {
        op: Op::Ctu,
        mnemonic: "CTU",
        differs: &[
            (
                Profile::Ldmicro,
                "CV is an INT: after 32767 comes -32768. Other instructions may write it, and several blocks count in one tag, each with its own memory of EN.",
            ),
            (
                Profile::Iot,
                "CV counts once while EN is high, and wraps. That PV was reached is kept in Q until `(RES)`; the power after the block is EN and Q. `AC` is what CV begins with, and what `(RES)` gives it. CC is high while EN is.",
            ),
            (
                Profile::Click,
                "Q is low while R is high. Other instructions may write CV.",
            ),
        ],
        title: "Up counter",
        operands: &[
            Operand::in_out(
                "c",
                Accepts::State(StateType::Ctu),
                "The counter's tag, of type CTU.",
            ),
            PV,
            RESET,
            COUNT_AT_FIRST,
        ],
        doc: "Counts one up each time EN rises; Q is high while the count has reached PV.

- CV goes on counting past PV, up to the largest DINT, where it stays.
- While R is high CV is 0. R is stronger than counting, and a rise of EN under a high R is used up.
- EN that is high at the first evaluation counts as a rise.
- PV is read at every evaluation, so it may be a tag; it may be 0, then Q is high at once.
- ENO is Q; other rungs read `c.Q` and `c.CV`. Declare the tag in a `RETAIN` section to keep the count over
  a restart.

Each counter tag belongs to one block. IEC 61131-3: CTU, here with DINT.",
        example: "VAR_INPUT
    part_seen, new_box : BOOL;
END_VAR
VAR
    parts : CTU;
END_VAR
VAR_OUTPUT
    box_full : BOOL;
END_VAR

+--[ ]( part_seen )---------[CTU]( parts, 12, R := new_box )--( )( box_full )--+",
        ..BASE
    },
    Instruction {
        op: Op::Ctd,
        mnemonic: "CTD",
        differs: &[
            (
                Profile::Ldmicro,
                "Q is high while CV is PV or more. CV is an INT that wraps; other instructions may write it, and several blocks count in one tag. There is no LD.",
            ),
            (
                Profile::Iot,
                "As CTU, but down: Q is set when CV is PV or less. `AC` is what CV begins with, and what `(RES)` gives it.",
            ),
            (
                Profile::Click,
                "Q is high while CV is PV or less and R is low: a reset gives 0, and then Q is high. Other instructions write the CV that is counted from.",
            ),
            (
                Profile::Logix,
                "The power after it is EN, and an EN that is high at the first evaluation is no rise. Programs of Logix have the block `$CTD` in its place, whose state is a structure that `$CTU` shares.",
            ),
        ],
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
            COUNT_AT_FIRST,
        ],
        doc: "Counts one down each time EN rises; Q is high while the count is 0 or below.

- While LD is high CV is PV: load the counter before it counts. A new counter is at 0, so Q is high
  until then.
- CV goes on counting below 0, down to the smallest DINT, where it stays.
- While R is high CV is 0. R is stronger than LD, LD stronger than counting; a rise of EN under either is
  used up.
- EN that is high at the first evaluation counts as a rise.
- ENO is Q; other rungs read `c.Q` and `c.CV`. Declare the tag in a `RETAIN` section to keep the count over
  a restart.

Each counter tag belongs to one block. IEC 61131-3: CTD, here with DINT and a reset.",
        example: "VAR_INPUT
    part_taken, refilled : BOOL;
END_VAR
VAR
    stock : CTD;
END_VAR
VAR_OUTPUT
    stock_empty : BOOL;
END_VAR

+--[ ]( part_taken )---[CTD]( stock, 50, LD := refilled )--( )( stock_empty )--+",
        ..BASE
    },
    Instruction {
        op: Op::Ctud,
        mnemonic: "CTUD",
        profiles: Profiles::OWN,
        differs: &[(
            Profile::Click,
            "Q is low while R is high. Other instructions may write CV.",
        )],
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
        doc: "Counts one up each time EN rises and one down each time CD rises.

- QU is high while CV has reached PV, QD while CV is 0 or below. Q, and ENO, is QU; other rungs read `c.QU`,
  `c.QD` and `c.CV`.
- If both rise in the same scan the count does not change.
- R is strongest: while it is high CV is 0. Then comes LD: while it is high CV is PV. Rises under either are
  used up.
- CV stays at the largest and the smallest DINT.
- EN or CD that is high at the first evaluation counts as a rise.

Each counter tag belongs to one block. IEC 61131-3: CTUD, here with DINT.",
        example: "VAR_INPUT
    car_in, car_out : BOOL;
END_VAR
VAR
    cars : CTUD;
END_VAR
VAR_OUTPUT
    full, empty : BOOL;
END_VAR

+--[ ]( car_in )---------------[CTUD]( cars, 80, CD := car_out )--( )( full )--+
+--[ ]( cars.QD )------------------------------------------------( )( empty )--+",
        ..BASE
    },
    Instruction {
        op: Op::Ctc,
        mnemonic: "CTC",
        profiles: Profiles::only(Profile::Iec).and(Profile::Ldmicro),
        differs: &[(
            Profile::Ldmicro,
            "The power after it is EN, and so is Q. CV is an INT; other instructions may write it, and several blocks count in one tag.",
        )],
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
        doc: "Counts in a circle each time EN rises: from 0 to PV, then again from 0.

- Q is high while CV is PV. A circle has PV + 1 steps.
- While R is high CV is 0. R is stronger than counting, and a rise of EN under a high R is used up.
- EN that is high at the first evaluation counts as a rise.
- ENO is Q; other rungs read `c.Q` and `c.CV`: with comparisons on `c.CV` it drives a sequence of steps.

Each counter tag belongs to one block. IEC 61131-3 has no such counter.",
        example: "VAR_INPUT
    next_step : BOOL;
END_VAR
VAR
    step : CTC;
END_VAR
VAR_OUTPUT
    fill, stir : BOOL;
END_VAR

+--[ ]( next_step )------------------------------------------[CTC]( step, 3 )--+
+--[EQ]( step.CV, 1 )---------------------------------------------( )( fill )--+
+--[EQ]( step.CV, 2 )---------------------------------------------( )( stir )--+",
        ..BASE
    },
];
