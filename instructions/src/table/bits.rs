//! Bitwise logic, shifts and rotates (LANGUAGE §5.2).

use crate::{Accepts, Acts, Group, Instruction, Op, Operand, Role, Shape, TypeClass};

/// What the rows of this section share.
const BASE: Instruction = Instruction {
    op: Op::Not,
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
        op: Op::Not,
        mnemonic: "NOT",
        title: "Bitwise not",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::BoolBitsOrInteger), "The result."),
            Operand::input("a", Accepts::Value, "The value whose bits are inverted."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::And,
        mnemonic: "AND",
        title: "Bitwise and",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::BoolBitsOrInteger), "The result."),
            Operand::input("a", Accepts::Value, "The first value."),
            Operand::input("b", Accepts::Value, "What it is combined with.").repeated(),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Or,
        mnemonic: "OR",
        title: "Bitwise or",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::BoolBitsOrInteger), "The result."),
            Operand::input("a", Accepts::Value, "The first value."),
            Operand::input("b", Accepts::Value, "What it is combined with.").repeated(),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Xor,
        mnemonic: "XOR",
        title: "Bitwise exclusive or",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::BoolBitsOrInteger), "The result."),
            Operand::input("a", Accepts::Value, "The first value."),
            Operand::input("b", Accepts::Value, "What it is combined with.").repeated(),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Shl,
        mnemonic: "SHL",
        title: "Shift left",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::BitsOrInteger), "The result."),
            Operand::input("a", Accepts::Value, "The value whose bits are moved."),
            Operand::input("n", Accepts::Integer, "How many places, 0 or more."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Shr,
        mnemonic: "SHR",
        title: "Shift right",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::BitsOrInteger), "The result."),
            Operand::input("a", Accepts::Value, "The value whose bits are moved."),
            Operand::input("n", Accepts::Integer, "How many places, 0 or more."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Rol,
        mnemonic: "ROL",
        title: "Rotate left",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::BitsOrInteger), "The result."),
            Operand::input("a", Accepts::Value, "The value whose bits are moved."),
            Operand::input("n", Accepts::Integer, "How many places, 0 or more."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Ror,
        mnemonic: "ROR",
        title: "Rotate right",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::BitsOrInteger), "The result."),
            Operand::input("a", Accepts::Value, "The value whose bits are moved."),
            Operand::input("n", Accepts::Integer, "How many places, 0 or more."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
];
