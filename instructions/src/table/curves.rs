//! Values from a list and from a curve (LANGUAGE §5.2).

use crate::instruction::{Acts, Group, Instruction, Role, Shape};
use crate::op::Op;
use crate::operand::{Accepts, Operand, TypeClass};
use crate::power::Power;
use crate::profile::{Profile, Profiles};

/// What the rows of this section share.
const BASE: Instruction = Instruction {
    op: Op::Lut,
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
        op: Op::Lut,
        mnemonic: "LUT",
        profiles: Profiles::WITHOUT_IOT,
        differs: &[
            (Profile::Ldmicro, "An index outside the table writes nothing, and is not a fault."),
        ],
        title: "Look-up table",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Any), "The result."),
            Operand::input("i", Accepts::Integer, "Which value, from 0."),
            Operand::input("v0", Accepts::Value, "The value for 0."),
            Operand::input("v1", Accepts::Value, "The value for 1, and so on.").repeated(),
        ],
        doc: "Puts the i-th value of a list into y, counted from 0.

An i outside the list is a fault: y keeps its value and ENO is low. For values between the entries see
`[PWL]`.",
        example: "VAR_INPUT
    digit : INT;
END_VAR
VAR_OUTPUT
    segments : BYTE;
END_VAR

+-----------------[LUT]( segments, digit, 16#3F, 16#06, 16#5B, 16#4F, 16#66 )--+",
        ..BASE
    },
    Instruction {
        op: Op::Pwl,
        mnemonic: "PWL",
        profiles: Profiles::WITHOUT_IOT,
        differs: &[
            (Profile::Ldmicro, "Left of the first point the first line goes on; right of the last point nothing is written. It computes in the type of y, and wraps."),
        ],
        title: "Piecewise linear",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Number), "The result."),
            Operand::input("x", Accepts::Value, "The input of the curve."),
            Operand::input("x0", Accepts::Value, "Where the first point is."),
            Operand::input("y0", Accepts::Value, "The result at the first point."),
            Operand::input(
                "x1",
                Accepts::Value,
                "Where the next point is, right of the one before.",
            )
            .repeated_pair(),
            Operand::input("y1", Accepts::Value, "The result at that point.").repeated_pair(),
        ],
        doc: "Puts the height of a curve at x into y; the curve is given by points and straight lines between them.

The points come in pairs, x0, y0, x1, y1, ..., with x rising. Left of the first point the result is the
first y, right of the last the last y: it is never extended beyond its ends. Between integers the result is
cut off toward zero.

Use it to straighten the curve of a sensor or to scale an analog value.",
        example: "VAR_INPUT
    raw : INT;
END_VAR
VAR_OUTPUT
    percent : INT;
END_VAR

+-----------------------------[PWL]( percent, raw, 0, 0, 400, 25, 1000, 100 )--+",
        ..BASE
    },
];
