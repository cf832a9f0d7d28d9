//! Instructions on array ranges (LANGUAGE §5.2).

use crate::{Accepts, Acts, Group, Instruction, Op, Operand, Role, Shape, TypeClass};

/// What the rows of this section share.
const BASE: Instruction = Instruction {
    op: Op::Bmov,
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
        op: Op::Bmov,
        mnemonic: "BMOV",
        title: "Move a range",
        operands: &[
            Operand::output("y", Accepts::Range, "The range that is written."),
            Operand::input(
                "a",
                Accepts::Range,
                "The range that is copied, of the same length.",
            ),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Fill,
        mnemonic: "FILL",
        title: "Fill a range",
        operands: &[
            Operand::output("y", Accepts::Range, "The range that is written."),
            Operand::input("a", Accepts::Value, "The value for every element."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Pack,
        mnemonic: "PACK",
        title: "Pack a range",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Any), "The result."),
            Operand::input(
                "a",
                Accepts::RangeOrValue,
                "The bits or words to put together, or a string that holds a number.",
            ),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Unpack,
        mnemonic: "UNPACK",
        title: "Unpack into a range",
        operands: &[
            Operand::output(
                "y",
                Accepts::RangeOrValue,
                "The bits or words that are written, or a string for a number.",
            ),
            Operand::input("a", Accepts::Convertible, "The value that is taken apart."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Shift,
        mnemonic: "SHIFT",
        title: "Shift register",
        operands: &[
            Operand::in_out("y", Accepts::Range, "The register; its elements move up."),
            Operand::input("d", Accepts::Value, "What enters at the first element."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Search,
        mnemonic: "SEARCH",
        title: "Search a range",
        operands: &[
            Operand::in_out(
                "y",
                Accepts::Result(TypeClass::Integer),
                "The index of the element that was found, or -1.",
            ),
            Operand::input(
                "op",
                Accepts::SearchOperator,
                "The comparison: EQ, NE, GT, GE, LT or LE.",
            ),
            Operand::input("a", Accepts::Compared, "What the elements are compared with."),
            Operand::input("t", Accepts::Range, "The range that is searched."),
            Operand::input("NEXT", Accepts::Bool, "High: go on behind the index in y.").named(),
            Operand::output("FOUND", Accepts::Bool, "High if an element was found.").named(),
        ],
        doc: "",
        example: "",
        ..BASE
    },
];
