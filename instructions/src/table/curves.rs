//! Values from a list and from a curve (LANGUAGE §5.2).

use crate::{Accepts, Acts, Group, Instruction, Op, Operand, Role, Shape, TypeClass};

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
    eno: "EN, low on a fault",
    title: "",
    doc: "",
    example: "",
};

pub(super) const ROWS: &[Instruction] = &[
    Instruction {
        op: Op::Lut,
        mnemonic: "LUT",
        title: "Look-up table",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Any), "The result."),
            Operand::input("i", Accepts::Integer, "Which value, from 0."),
            Operand::input("v0", Accepts::Value, "The value for 0."),
            Operand::input("v1", Accepts::Value, "The value for 1, and so on.").repeated(),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Pwl,
        mnemonic: "PWL",
        title: "Piecewise linear",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Number), "The result."),
            Operand::input("x", Accepts::Value, "The input of the curve."),
            Operand::input("x0", Accepts::Value, "Where the first point stands."),
            Operand::input("y0", Accepts::Value, "The result at the first point."),
            Operand::input(
                "x1",
                Accepts::Value,
                "Where the next point stands, right of the one before.",
            )
            .repeated_pair(),
            Operand::input("y1", Accepts::Value, "The result at that point.").repeated_pair(),
        ],
        doc: "",
        example: "",
        ..BASE
    },
];
