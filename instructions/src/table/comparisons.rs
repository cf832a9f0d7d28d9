//! Comparisons (LANGUAGE §5.1).

use crate::{Accepts, Acts, Group, Instruction, Op, Operand, Role, Shape};

/// What the rows of this section share.
const BASE: Instruction = Instruction {
    op: Op::Eq,
    mnemonic: "",
    synonyms: &[],
    aliases: &[],
    shape: Shape::Logical,
    role: Role::Condition,
    acts: Acts::WhenPowered,
    group: Group::Condition,
    operands: &[],
    eno: "EN and the comparison holds",
    title: "",
    doc: "",
    example: "",
};

pub(super) const ROWS: &[Instruction] = &[
    Instruction {
        op: Op::Eq,
        mnemonic: "EQ",
        aliases: &["EQU"],
        title: "Equal",
        operands: &[
            Operand::input("a", Accepts::Compared, "The left side."),
            Operand::input(
                "b",
                Accepts::Compared,
                "The right side; with more operands each is compared with the one before it.",
            )
            .repeated(),
        ],
        eno: "EN and a = b",
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Ne,
        mnemonic: "NE",
        aliases: &["NEQ"],
        title: "Not equal",
        operands: &[
            Operand::input("a", Accepts::Compared, "The left side."),
            Operand::input("b", Accepts::Compared, "The right side."),
        ],
        eno: "EN and a <> b",
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Gt,
        mnemonic: "GT",
        aliases: &["GRT"],
        title: "Greater than",
        operands: &[
            Operand::input("a", Accepts::Compared, "The left side."),
            Operand::input(
                "b",
                Accepts::Compared,
                "The right side; with more operands each is compared with the one before it.",
            )
            .repeated(),
        ],
        eno: "EN and a > b",
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Ge,
        mnemonic: "GE",
        aliases: &["GEQ"],
        title: "Greater or equal",
        operands: &[
            Operand::input("a", Accepts::Compared, "The left side."),
            Operand::input(
                "b",
                Accepts::Compared,
                "The right side; with more operands each is compared with the one before it.",
            )
            .repeated(),
        ],
        eno: "EN and a >= b",
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Lt,
        mnemonic: "LT",
        aliases: &["LES"],
        title: "Less than",
        operands: &[
            Operand::input("a", Accepts::Compared, "The left side."),
            Operand::input(
                "b",
                Accepts::Compared,
                "The right side; with more operands each is compared with the one before it.",
            )
            .repeated(),
        ],
        eno: "EN and a < b",
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Le,
        mnemonic: "LE",
        aliases: &["LEQ"],
        title: "Less or equal",
        operands: &[
            Operand::input("a", Accepts::Compared, "The left side."),
            Operand::input(
                "b",
                Accepts::Compared,
                "The right side; with more operands each is compared with the one before it.",
            )
            .repeated(),
        ],
        eno: "EN and a <= b",
        doc: "",
        example: "",
        ..BASE
    },
];
