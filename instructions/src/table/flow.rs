//! Program flow (LANGUAGE §5.5).

use crate::{Accepts, Acts, Group, Instruction, Op, Operand, Role, Shape};

/// What the rows of this section share.
const BASE: Instruction = Instruction {
    op: Op::Lbl,
    mnemonic: "",
    synonyms: &[],
    aliases: &[],
    shape: Shape::Function,
    role: Role::Acting,
    acts: Acts::WhenPowered,
    group: Group::Flow,
    operands: &[],
    eno: "EN",
    title: "",
    doc: "",
    example: "",
};

pub(super) const ROWS: &[Instruction] = &[
    Instruction {
        op: Op::Lbl,
        mnemonic: "LBL",
        role: Role::Condition,
        title: "Label",
        operands: &[Operand::input("name", Accepts::Label, "The name that jumps use.")],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Jmp,
        mnemonic: "JMP",
        title: "Jump",
        operands: &[Operand::input("name", Accepts::Label, "The label to go on at.")],
        eno: "EN, if it does not jump",
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Fun,
        mnemonic: "FUN",
        role: Role::Condition,
        title: "Function",
        operands: &[Operand::input(
            "name",
            Accepts::Function,
            "The name that calls use.",
        )],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Call,
        mnemonic: "CALL",
        title: "Call a function",
        operands: &[Operand::input(
            "name",
            Accepts::Function,
            "The function that is run.",
        )],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Ret,
        mnemonic: "RET",
        title: "Return",
        eno: "EN, if it does not return",
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::End,
        mnemonic: "END",
        title: "End of the program",
        eno: "EN, if the program goes on",
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::For,
        mnemonic: "FOR",
        title: "Loop",
        operands: &[Operand::input(
            "n",
            Accepts::Integer,
            "How many times; read once.",
        )],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Next,
        mnemonic: "NEXT",
        title: "End of a loop",
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Mcr,
        mnemonic: "MCR",
        acts: Acts::Always,
        title: "Master control relay",
        doc: "",
        example: "",
        ..BASE
    },
];
