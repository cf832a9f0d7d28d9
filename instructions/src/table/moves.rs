//! Moving and converting a value (LANGUAGE §5.2).

use crate::{Accepts, Acts, Group, Instruction, Op, Operand, Role, Shape, TypeClass};

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
    eno: "EN, low on a fault",
    title: "",
    doc: "",
    example: "",
};

pub(super) const ROWS: &[Instruction] = &[
    Instruction {
        op: Op::Mov,
        mnemonic: "MOV",
        synonyms: &["SET"],
        aliases: &["MOVE"],
        title: "Move",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Any), "The tag that is written."),
            Operand::input("a", Accepts::Value, "The value."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Typ,
        mnemonic: "TYP",
        title: "Convert type",
        operands: &[
            Operand::output(
                "y",
                Accepts::Result(TypeClass::Any),
                "The tag that is written; its type is the target.",
            ),
            Operand::input("a", Accepts::Convertible, "The value, of any elementary type."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
];
