//! String functions (LANGUAGE §5.2, as in IEC 61131-3).

use crate::{Accepts, Acts, Group, Instruction, Op, Operand, Role, Shape, TypeClass};

/// What the rows of this section share.
const BASE: Instruction = Instruction {
    op: Op::Len,
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
        op: Op::Len,
        mnemonic: "LEN",
        title: "Length of a string",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Integer), "The result."),
            Operand::input("a", Accepts::String, "The string."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Left,
        mnemonic: "LEFT",
        title: "Left part of a string",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::String), "The result."),
            Operand::input("a", Accepts::String, "The string."),
            Operand::input("n", Accepts::Integer, "How many characters."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Right,
        mnemonic: "RIGHT",
        title: "Right part of a string",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::String), "The result."),
            Operand::input("a", Accepts::String, "The string."),
            Operand::input("n", Accepts::Integer, "How many characters."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Mid,
        mnemonic: "MID",
        title: "Middle part of a string",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::String), "The result."),
            Operand::input("a", Accepts::String, "The string."),
            Operand::input("n", Accepts::Integer, "How many characters."),
            Operand::input("p", Accepts::Integer, "The position of the first one, from 1."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Concat,
        mnemonic: "CONCAT",
        title: "Join strings",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::String), "The result."),
            Operand::input("a", Accepts::String, "The first string."),
            Operand::input("b", Accepts::String, "What is put behind it.").repeated(),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Insert,
        mnemonic: "INSERT",
        title: "Insert into a string",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::String), "The result."),
            Operand::input("a", Accepts::String, "The string."),
            Operand::input("b", Accepts::String, "What is inserted."),
            Operand::input(
                "p",
                Accepts::Integer,
                "The position behind which it is inserted; 0 is the beginning.",
            ),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Delete,
        mnemonic: "DELETE",
        title: "Delete from a string",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::String), "The result."),
            Operand::input("a", Accepts::String, "The string."),
            Operand::input("n", Accepts::Integer, "How many characters."),
            Operand::input("p", Accepts::Integer, "The position of the first one, from 1."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Replace,
        mnemonic: "REPLACE",
        title: "Replace in a string",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::String), "The result."),
            Operand::input("a", Accepts::String, "The string."),
            Operand::input("b", Accepts::String, "What is put in."),
            Operand::input("n", Accepts::Integer, "How many characters it replaces."),
            Operand::input(
                "p",
                Accepts::Integer,
                "The position of the first of them, from 1.",
            ),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Find,
        mnemonic: "FIND",
        title: "Find in a string",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Integer), "The result."),
            Operand::input("a", Accepts::String, "The string that is searched."),
            Operand::input("b", Accepts::String, "The string that is looked for."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
];
