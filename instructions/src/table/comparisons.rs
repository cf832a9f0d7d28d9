//! Comparisons (LANGUAGE §5.1).

use crate::instruction::{Acts, Group, Instruction, Role, Shape};
use crate::op::Op;
use crate::operand::{Accepts, Operand};
use crate::power::Power;
use crate::profile::Profiles;

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
    profiles: Profiles::ALL,
    differs: &[],
    power: Power::Compares,
    coil: None,
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
        doc: "Passes power while its operands are equal.

With more than two operands every neighbouring pair must be equal. Integers of any two types are compared by
value; an untyped literal takes the type of the other side. Values of different kinds, as a TIME and a
number, must first be converted with `[TYP]`.

Reals are compared exactly, to the last bit. For a measured value ask with `[GE]` and `[LE]` whether it lies
within a band.

IEC 61131-3: EQ.",
        example: "VAR
    step : INT;
END_VAR
VAR_OUTPUT
    filling : BOOL;
END_VAR

+--[EQ]( step, 3 )---------------------------------------------( )( filling )--+",
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
        doc: "Passes power while its two operands differ.

Integers of any two types are compared by value; an untyped literal takes the type of the other side. Values
of different kinds, as a TIME and a number, must first be converted with `[TYP]`. It takes exactly two
operands.

IEC 61131-3: NE.",
        example: "VAR_INPUT
    recipe : INT;
END_VAR
VAR
    loaded : INT;
END_VAR
VAR_OUTPUT
    load : BOOL;
END_VAR

+--[NE]( recipe, loaded )-----------------------------------------( )( load )--+",
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
        doc: "Passes power while the first operand is greater than the second.

With more than two operands each must be greater than the one after it, so the list falls: `[GT]( a, b, c
)` is a > b and b > c. Integers of any two types are compared by value; an untyped literal takes the type of
the other side. BOOL has no order: it can only be compared with `[EQ]` and `[NE]`.

IEC 61131-3: GT.",
        example: "VAR_INPUT
    level : INT;
END_VAR
VAR_OUTPUT
    alarm : BOOL;
END_VAR

+--[GT]( level, 80 )---------------------------------------------( )( alarm )--+",
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
        doc: "Passes power while the first operand is greater than the second or equal to it.

With more than two operands this must hold for every neighbouring pair: `[GE]( high, x, low )` asks whether
x lies between two limits, limits included. Integers of any two types are compared by value; an untyped
literal takes the type of the other side. BOOL has no order: it can only be compared with `[EQ]` and `[NE]`.

IEC 61131-3: GE.",
        example: "VAR_INPUT
    pressure : REAL;
END_VAR
VAR_OUTPUT
    pressure_ok : BOOL;
END_VAR

+--[GE]( 6.5, pressure, 5.5 )------------------------------( )( pressure_ok )--+",
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
        doc: "Passes power while the first operand is less than the second.

With more than two operands each must be less than the one after it, so the list rises: `[LT]( a, b, c )`
is a < b and b < c. Integers of any two types are compared by value; an untyped literal takes the type of
the other side. BOOL has no order: it can only be compared with `[EQ]` and `[NE]`.

IEC 61131-3: LT.",
        example: "VAR_INPUT
    temperature : REAL;
END_VAR
VAR_OUTPUT
    heater : BOOL;
END_VAR

+--[LT]( temperature, 21.5 )------------------------------------( )( heater )--+",
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
        doc: "Passes power while the first operand is less than the second or equal to it.

With more than two operands this must hold for every neighbouring pair: `[LE]( low, x, high )` asks whether
x lies between two limits, limits included. Integers of any two types are compared by value; an untyped
literal takes the type of the other side. BOOL has no order: it can only be compared with `[EQ]` and `[NE]`.

IEC 61131-3: LE.",
        example: "VAR_INPUT
    level : INT;
END_VAR
VAR_OUTPUT
    level_ok : BOOL;
END_VAR

+--[LE]( 20, level, 80 )--------------------------------------( )( level_ok )--+",
        ..BASE
    },
];
