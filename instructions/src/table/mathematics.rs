//! Functions of one number (LANGUAGE §5.2).

use crate::{Accepts, Acts, Group, Instruction, Op, Operand, Role, Shape, TypeClass};

/// What the rows of this section share.
const BASE: Instruction = Instruction {
    op: Op::Abs,
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
        op: Op::Abs,
        mnemonic: "ABS",
        title: "Absolute value",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Number), "The result."),
            Operand::input("a", Accepts::Value, "The value."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Neg,
        mnemonic: "NEG",
        title: "Negate",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Number), "The result."),
            Operand::input("a", Accepts::Value, "The value."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Trunc,
        mnemonic: "TRUNC",
        title: "Truncate",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Number), "The result."),
            Operand::input("a", Accepts::Number, "The value; a real may go into an integer."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Sqrt,
        mnemonic: "SQRT",
        title: "Square root",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Real), "The result."),
            Operand::input("a", Accepts::Value, "The value, 0 or more."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Ln,
        mnemonic: "LN",
        title: "Natural logarithm",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Real), "The result."),
            Operand::input("a", Accepts::Value, "The value, above 0."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Log,
        mnemonic: "LOG",
        title: "Logarithm to base 10",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Real), "The result."),
            Operand::input("a", Accepts::Value, "The value, above 0."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Expe,
        mnemonic: "EXPE",
        title: "Power of e",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Real), "The result."),
            Operand::input("a", Accepts::Value, "The exponent."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Sin,
        mnemonic: "SIN",
        title: "Sine",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Real), "The result."),
            Operand::input("a", Accepts::Value, "The angle in radians."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Cos,
        mnemonic: "COS",
        title: "Cosine",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Real), "The result."),
            Operand::input("a", Accepts::Value, "The angle in radians."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Tan,
        mnemonic: "TAN",
        title: "Tangent",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Real), "The result."),
            Operand::input("a", Accepts::Value, "The angle in radians."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Asin,
        mnemonic: "ASIN",
        title: "Arc sine",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Real), "The result."),
            Operand::input("a", Accepts::Value, "The sine, from -1 to 1."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Acos,
        mnemonic: "ACOS",
        title: "Arc cosine",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Real), "The result."),
            Operand::input("a", Accepts::Value, "The cosine, from -1 to 1."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Atan,
        mnemonic: "ATAN",
        title: "Arc tangent",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Real), "The result."),
            Operand::input("a", Accepts::Value, "The tangent."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Rad,
        mnemonic: "RAD",
        title: "Degrees to radians",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Real), "The result."),
            Operand::input("a", Accepts::Value, "The angle in degrees."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Deg,
        mnemonic: "DEG",
        title: "Radians to degrees",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Real), "The result."),
            Operand::input("a", Accepts::Value, "The angle in radians."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
];
