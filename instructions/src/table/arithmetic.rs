//! The six operations of arithmetic (LANGUAGE §5.2).

use crate::instruction::{Acts, Group, Instruction, Role, Shape};
use crate::op::Op;
use crate::operand::{Accepts, Operand, TypeClass};
use crate::power::Power;
use crate::profile::{Profile, Profiles};

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
    profiles: Profiles::ALL,
    differs: &[],
    power: Power::PassesIfDone,
    coil: None,
    eno: "EN, low on a fault",
    title: "",
    doc: "",
    example: "",
};

pub(super) const ROWS: &[Instruction] = &[
    Instruction {
        op: Op::Add,
        mnemonic: "ADD",
        differs: &[
            (
                Profile::Iot,
                "Computes as C does: in 32 bits, or in REAL where an operand is real, and cuts the result to the type of y. A REAL may become infinite, and nothing is a fault.",
            ),
            (
                Profile::Click,
                "What does not fit wraps round and sets SC43; a real that is too large is 0.",
            ),
        ],
        title: "Add",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::NumberOrTime), "The result."),
            Operand::input("a", Accepts::Value, "The first summand."),
            Operand::input("b", Accepts::Value, "What is added to it.").repeated(),
        ],
        doc: "Adds its operands into y.

The sum is formed in y's type: all operands are first brought to it. Integers wrap around at the ends of
their range without a fault (INT: 32767 + 1 is -32768); a real result that is not finite is a fault: y keeps
its value and ENO is low. While EN is low y keeps its value: without an edge in front, the block adds in
every scan.

Times add to times, and a TIME to a DT. IEC 61131-3: ADD.",
        example: "VAR_INPUT
    part_seen : BOOL;
END_VAR
VAR
    parts : DINT;
END_VAR

+--[P]( part_seen )----------------------------------[ADD]( parts, parts, 1 )--+",
        ..BASE
    },
    Instruction {
        op: Op::Mul,
        mnemonic: "MUL",
        differs: &[
            (
                Profile::Iot,
                "Computes as C does: in 32 bits, or in REAL where an operand is real, and cuts the result to the type of y. A REAL may become infinite, and nothing is a fault.",
            ),
            (
                Profile::Click,
                "What does not fit wraps round and sets SC43; a real that is too large is 0.",
            ),
        ],
        title: "Multiply",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::NumberOrTime), "The result."),
            Operand::input("a", Accepts::Value, "The first factor."),
            Operand::input("b", Accepts::Value, "What it is multiplied by.").repeated(),
        ],
        doc: "Multiplies its operands into y.

The product is formed in y's type: all operands are first brought to it. Integers wrap around at the ends of
their range without a fault; give y a wider type where the product may be large. A real result that is not
finite is a fault: y keeps its value and ENO is low.

A TIME can be multiplied by a number. IEC 61131-3: MUL.",
        example: "VAR_INPUT
    layers, per_layer : INT;
END_VAR
VAR_OUTPUT
    boxes : DINT;
END_VAR

+-------------------------------------------[MUL]( boxes, layers, per_layer )--+",
        ..BASE
    },
    Instruction {
        op: Op::Sub,
        mnemonic: "SUB",
        differs: &[
            (
                Profile::Iot,
                "Computes as C does: in 32 bits, or in REAL where an operand is real, and cuts the result to the type of y. A REAL may become infinite, and nothing is a fault.",
            ),
            (
                Profile::Click,
                "What does not fit wraps round and sets SC43; a real that is too large is 0.",
            ),
        ],
        title: "Subtract",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::NumberOrTime), "The result."),
            Operand::input("a", Accepts::Value, "The value to subtract from."),
            Operand::input("b", Accepts::Value, "What is subtracted.").repeated(),
        ],
        doc: "Subtracts from a all that follows it, into y.

`[SUB]( y, a, b, c )` is a - b - c. The difference is formed in y's type. Integers wrap around at the ends
of their range without a fault, unsigned ones below 0 too (UINT: 3 - 5 is 65534); a real result that is not
finite is a fault: y keeps its value and ENO is low.

Two times, two TODs or two DTs give a TIME. IEC 61131-3: SUB.",
        example: "VAR_INPUT
    gross, tare : DINT;
END_VAR
VAR_OUTPUT
    net : DINT;
END_VAR

+---------------------------------------------------[SUB]( net, gross, tare )--+",
        ..BASE
    },
    Instruction {
        op: Op::Div,
        mnemonic: "DIV",
        differs: &[
            (
                Profile::Ldmicro,
                "A division by 0 gives 0 and records a fault; this scan runs to its end and is the last one.",
            ),
            (
                Profile::Iot,
                "Computes as C does: two integers give an integer, 7 / 2 is 3, also where y is real. A REAL divided by 0 is infinite; an integer is a fault.",
            ),
            (
                Profile::Click,
                "A division by 0 gives 0 and sets SC40, of reals too.",
            ),
            (
                Profile::Logix,
                "An integer divided by 0 gives the dividend, and is no fault.",
            ),
        ],
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
        doc: "Divides a by all that follows it, into y.

`[DIV]( y, a, b, c )` is a / b / c. The quotient is formed in y's type. Between integers each step cuts the
fraction off toward zero (-7 / 2 is -3). Dividing by zero is a fault: y keeps its value and ENO is low.

A TIME can be divided by a number. IEC 61131-3: DIV.",
        example: "VAR_INPUT
    total, count : DINT;
END_VAR
VAR_OUTPUT
    average  : DINT;
    no_parts : BOOL;
END_VAR

+--[DIV]( average, total, count )--[NOT]----------------------( )( no_parts )--+",
        ..BASE
    },
    Instruction {
        op: Op::Mod,
        mnemonic: "MOD",
        profiles: Profiles::WITHOUT_IOT,
        differs: &[
            (
                Profile::Click,
                "The remainder has the sign of b: -7 MOD 2 is 1. By 0 it is 0, and SC40 is set.",
            ),
            (
                Profile::Logix,
                "The remainder of an integer divided by 0 is 0, and no fault.",
            ),
        ],
        title: "Remainder",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Number), "The result."),
            Operand::input("a", Accepts::Value, "The dividend."),
            Operand::input("b", Accepts::Value, "The divisor."),
        ],
        doc: "Puts the remainder of a divided by b into y.

The remainder has the sign of a: -7 mod 3 is -1. It works on reals too. With b = 0 it is a fault: y keeps
its value and ENO is low.

IEC 61131-3: MOD, which knows integers only.",
        example: "VAR
    parts, rest : DINT;
END_VAR
VAR_OUTPUT
    box_full : BOOL;
END_VAR

+----------------------------------------------------[MOD]( rest, parts, 12 )--+
+--[EQ]( rest, 0 )--------------------------------------------( )( box_full )--+",
        ..BASE
    },
    Instruction {
        op: Op::Exp,
        mnemonic: "EXP",
        aliases: &["EXPT"],
        profiles: Profiles::OWN,
        differs: &[(
            Profile::Click,
            "What does not fit wraps round and sets SC43. A negative power of an integer is what is left of it without fraction.",
        )],
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
        doc: "Raises a to the power of b, into y.

With more operands the powers are taken from the right: `[EXP]( y, a, b, c )` is a ^ (b ^ c). The power is
formed in y's type; integers wrap around. An integer power with a negative exponent, and a real result that
is not finite or does not exist, is a fault: y keeps its value and ENO is low.

For powers of e use `[EXPE]`. IEC 61131-3: EXPT.",
        example: "VAR_INPUT
    speed : REAL;
END_VAR
VAR
    squared : REAL;
END_VAR

+--------------------------------------------------[EXP]( squared, speed, 2 )--+",
        ..BASE
    },
];
