//! Moving and converting a value (LANGUAGE §5.2).

use crate::instruction::{Acts, Group, Instruction, Role, Shape};
use crate::op::Op;
use crate::operand::{Accepts, Operand, TypeClass};
use crate::power::Power;
use crate::profile::{Profile, Profiles};

/// What the rows of this section share.
const BASE: Instruction = Instruction {
    op: Op::Mov,
    mnemonic: "",
    synonyms: &[],
    aliases: &[],
    shape: Shape::Logical,
    role: Role::Acting,
    acts: Acts::WhenPowered,
    group: Group::Data,
    operands: &[],
    profiles: Profiles::ALL,
    differs: &[],
    power: Power::PassesIfDone,
    coil: None,
    eno: "EN, low on a fault",
    title: "",
    doc: "",
    example: "",
};

pub(super) const ROWS: &[Instruction] = &[
    Instruction {
        op: Op::Mov,
        power: Power::Passes,
        mnemonic: "MOV",
        synonyms: &["SET"],
        aliases: &["MOVE"],
        differs: &[
            (
                Profile::Iot,
                "The value is cut to the type of y as in C: a real loses its fraction, an integer its upper bits.",
            ),
            (
                Profile::Click,
                "An index outside its array sets SC44, and nothing is written.",
            ),
        ],
        title: "Move",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Any), "The tag that is written."),
            Operand::input("a", Accepts::Value, "The value."),
        ],
        doc: "Copies a value into y.

Any elementary type will do. The value must be of y's type or pass to it without loss, as INT passes to DINT
and to REAL; for everything else use `[TYP]`. While EN is low y keeps its value.

`[MOV]` and `[SET]` are two names of the same instruction. To latch a single bit write the coil `(S)`. IEC
61131-3: MOVE.",
        example: "VAR_INPUT
    fast : BOOL;
END_VAR
VAR
    speed : INT := 10;
END_VAR

+--[ ]( fast )---------------------------------------------[MOV]( speed, 50 )--+",
        ..BASE
    },
    Instruction {
        op: Op::Typ,
        mnemonic: "TYP",
        profiles: Profiles::OWN,
        differs: &[
            (
                Profile::Click,
                "A number that does not fit is held at the limit, in a WORD it loses its upper bits, and SC43 is set; a real loses its fraction. None of it is a fault.",
            ),
            (
                Profile::Logix,
                "What does not fit loses its upper bits, and is no fault.",
            ),
        ],
        title: "Convert type",
        operands: &[
            Operand::output(
                "y",
                Accepts::Result(TypeClass::Any),
                "The tag that is written; its type is the target.",
            ),
            Operand::input("a", Accepts::Convertible, "The value, of any elementary type."),
        ],
        doc: "Converts a value to the type of y.

- A real becomes an integer by rounding to the nearest; a half goes to the even neighbour (2.5 gives 2, 3.5
  gives 4). To cut the fraction off instead, use `[TRUNC]`.
- BOOL and numbers: FALSE is 0, TRUE is 1.
- A string is read as a number or a time; a number or a time can be written as a string.
- TIME and numbers: the number is milliseconds.
- A DT goes into its DATE or its TOD, a DATE into the DT of its midnight. A TIME is none of them: take the
  difference of two DTs or TODs with `[SUB]`.

A value that y's type cannot hold, or a string that cannot be read, is a fault: y keeps its value and ENO is
low.

IEC 61131-3: the conversion functions such as REAL_TO_INT.",
        example: "VAR_INPUT
    temperature : REAL;
END_VAR
VAR_OUTPUT
    display : INT;
    invalid : BOOL;
END_VAR

+--[TYP]( display, temperature )--[NOT]------------------------( )( invalid )--+",
        ..BASE
    },
    Instruction {
        op: Op::Wrap,
        mnemonic: "WRAP",
        profiles: Profiles::OWN,
        title: "Cut to fit",
        operands: &[
            Operand::output(
                "y",
                Accepts::Result(TypeClass::BitsOrInteger),
                "The tag that is written; its type is the target.",
            ),
            Operand::input("a", Accepts::Wrapped, "The value: an integer or a bit string."),
        ],
        doc: "Brings an integer or a bit string to the type of y, whatever its value is.

The value is extended by its sign if its type has one, else by zeros, and cut to the bits of y. So 300 gives
44 in a USINT, and -1 gives 65535 in a UINT. It is never a fault: for a value that must fit use `[TYP]`. A
literal is a LINT.

It is what the conversions between integers do in most controllers, and in Structured Text.",
        example: "VAR_INPUT
    total : DINT;
END_VAR
VAR_OUTPUT
    low : USINT;
END_VAR

+--------------------------------------------------------[WRAP]( low, total )--+",
        ..BASE
    },
];
