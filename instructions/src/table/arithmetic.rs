//! The six operations of arithmetic (LANGUAGE §5.2).

use crate::{Accepts, Acts, Group, Instruction, Op, Operand, Role, Shape, TypeClass};

/// What the rows of this section share.
const BASE: Instruction = Instruction {
    op: Op::Add,
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
        op: Op::Add,
        mnemonic: "ADD",
        title: "Add",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::NumberOrTime), "The result."),
            Operand::input("a", Accepts::Value, "The first summand."),
            Operand::input("b", Accepts::Value, "What is added to it.").repeated(),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Mul,
        mnemonic: "MUL",
        title: "Multiply",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::NumberOrTime), "The result."),
            Operand::input("a", Accepts::Value, "The first factor."),
            Operand::input("b", Accepts::Value, "What it is multiplied by.").repeated(),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Sub,
        mnemonic: "SUB",
        title: "Subtract",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::NumberOrTime), "The result."),
            Operand::input("a", Accepts::Value, "The value to subtract from."),
            Operand::input("b", Accepts::Value, "What is subtracted.").repeated(),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Div,
        mnemonic: "DIV",
        title: "Divide",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::NumberOrTime), "The result."),
            Operand::input("a", Accepts::Value, "The dividend."),
            Operand::input(
                "b",
                Accepts::Value,
                "The divisor; with more of them, the quotient is divided again.",
            )
            .repeated(),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Mod,
        mnemonic: "MOD",
        title: "Remainder",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Number), "The result."),
            Operand::input("a", Accepts::Value, "The dividend."),
            Operand::input("b", Accepts::Value, "The divisor."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Exp,
        mnemonic: "EXP",
        aliases: &["EXPT"],
        title: "Power",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Number), "The result."),
            Operand::input("a", Accepts::Value, "The base."),
            Operand::input(
                "b",
                Accepts::Value,
                "The exponent; with more of them, each is the exponent of the one before it.",
            )
            .repeated(),
        ],
        doc: "",
        example: "",
        ..BASE
    },
];
