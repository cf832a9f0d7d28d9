//! Choosing among values, and expressions (LANGUAGE §5.2).

use crate::{Accepts, Acts, Group, Instruction, Op, Operand, Role, Shape, TypeClass};

/// What the rows of this section share.
const BASE: Instruction = Instruction {
    op: Op::Min,
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
        op: Op::Min,
        mnemonic: "MIN",
        title: "Smallest value",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::NumberOrTime), "The result."),
            Operand::input("a", Accepts::Value, "The first value."),
            Operand::input("b", Accepts::Value, "A further value.").repeated(),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Max,
        mnemonic: "MAX",
        title: "Largest value",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::NumberOrTime), "The result."),
            Operand::input("a", Accepts::Value, "The first value."),
            Operand::input("b", Accepts::Value, "A further value.").repeated(),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Limit,
        mnemonic: "LIMIT",
        title: "Limit",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::NumberOrTime), "The result."),
            Operand::input("low", Accepts::Value, "The lower limit."),
            Operand::input("a", Accepts::Value, "The value."),
            Operand::input("high", Accepts::Value, "The upper limit."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Sel,
        mnemonic: "SEL",
        title: "Select one of two",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Any), "The result."),
            Operand::input("g", Accepts::Bool, "The switch: low takes a, high takes b."),
            Operand::input("a", Accepts::Value, "The value while g is low."),
            Operand::input("b", Accepts::Value, "The value while g is high."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Mux,
        mnemonic: "MUX",
        title: "Select one of many",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Any), "The result."),
            Operand::input("k", Accepts::Integer, "Which value, from 0."),
            Operand::input("a", Accepts::Value, "Value 0."),
            Operand::input("b", Accepts::Value, "Value 1, and so on.").repeated(),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Calc,
        mnemonic: "CALC",
        title: "Calculate",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Any), "The result."),
            Operand::input(
                "expression",
                Accepts::Expression,
                "The formula, as in `(a + b) / 2`.",
            ),
        ],
        doc: "",
        example: "",
        ..BASE
    },
];
