//! Bitwise logic, shifts and rotates (LANGUAGE §5.2).

use crate::instruction::{Acts, Group, Instruction, Role, Shape};
use crate::op::Op;
use crate::operand::{Accepts, Operand, TypeClass};
use crate::power::Power;
use crate::profile::{Profile, Profiles};

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
        op: Op::Not,
        mnemonic: "NOT",
        differs: &[(
            Profile::Iot,
            "Inverts all bits of a number: of a BOOL, 0 gives 255 and 1 gives 254, so that a BOOL y is always high.",
        )],
        title: "Bitwise not",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::BoolBitsOrInteger), "The result."),
            Operand::input("a", Accepts::Value, "The value whose bits are inverted."),
        ],
        doc: "Inverts every bit of a, into y.

It works on bit strings, on integers (in two's complement: NOT 0 is -1) and on BOOL, in y's width. Without
operands, `[NOT]` is the inverter of a wire.

IEC 61131-3: NOT.",
        example: "VAR_INPUT
    inputs : WORD;
END_VAR
VAR
    inverted : WORD;
END_VAR

+---------------------------------------------------[NOT]( inverted, inputs )--+",
        ..BASE
    },
    Instruction {
        op: Op::And,
        mnemonic: "AND",
        differs: &[(
            Profile::Iot,
            "Works on the bits of numbers, a BOOL being 0 or 1; a BOOL y is high unless the lower eight bits are 0.",
        )],
        title: "Bitwise and",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::BoolBitsOrInteger), "The result."),
            Operand::input("a", Accepts::Value, "The first value."),
            Operand::input("b", Accepts::Value, "What it is combined with.").repeated(),
        ],
        doc: "Combines its operands bit by bit: a bit of y is 1 where all of them have a 1.

It works on bit strings, integers and BOOL, in y's width. Use it with a mask to keep some bits and clear the
rest.

IEC 61131-3: AND.",
        example: "VAR_INPUT
    status : WORD;
END_VAR
VAR
    error_code : WORD;
END_VAR

+----------------------------------------[AND]( error_code, status, 16#00FF )--+",
        ..BASE
    },
    Instruction {
        op: Op::Or,
        mnemonic: "OR",
        differs: &[(
            Profile::Iot,
            "Works on the bits of numbers, a BOOL being 0 or 1; a BOOL y is high unless the lower eight bits are 0.",
        )],
        title: "Bitwise or",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::BoolBitsOrInteger), "The result."),
            Operand::input("a", Accepts::Value, "The first value."),
            Operand::input("b", Accepts::Value, "What it is combined with.").repeated(),
        ],
        doc: "Combines its operands bit by bit: a bit of y is 1 where at least one of them has a 1.

It works on bit strings, integers and BOOL, in y's width. Use it with a mask to set some bits and keep the
rest.

IEC 61131-3: OR.",
        example: "VAR
    control : WORD;
END_VAR

+-------------------------------------------[OR]( control, control, 16#8000 )--+",
        ..BASE
    },
    Instruction {
        op: Op::Xor,
        mnemonic: "XOR",
        differs: &[(
            Profile::Iot,
            "Works on the bits of numbers, a BOOL being 0 or 1; a BOOL y is high unless the lower eight bits are 0.",
        )],
        title: "Bitwise exclusive or",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::BoolBitsOrInteger), "The result."),
            Operand::input("a", Accepts::Value, "The first value."),
            Operand::input("b", Accepts::Value, "What it is combined with.").repeated(),
        ],
        doc: "Combines its operands bit by bit: a bit of y is 1 where an odd number of them have a 1.

With two operands these are the bits in which they differ; with a mask, the bits of the mask are inverted.
It works on bit strings, integers and BOOL, in y's width.

IEC 61131-3: XOR.",
        example: "VAR_INPUT
    inputs : WORD;
END_VAR
VAR
    before, changed : WORD;
END_VAR

+-------------------[XOR]( changed, inputs, before )--[MOV]( before, inputs )--+",
        ..BASE
    },
    Instruction {
        op: Op::Shl,
        mnemonic: "SHL",
        profiles: Profiles::WITHOUT_IOT,
        title: "Shift left",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::BitsOrInteger), "The result."),
            Operand::input("a", Accepts::Value, "The value whose bits are moved."),
            Operand::input("n", Accepts::Integer, "How many places, 0 or more."),
        ],
        doc: "Shifts the bits of a to the left by n places, into y.

The shift is made in y's width; zeros come in at the right, and what leaves at the left is lost. n past the
width gives 0; a negative n is a fault: y keeps its value and ENO is low. While EN is high it shifts in
every scan, so put an edge in front of a shift of y itself.

IEC 61131-3: SHL.",
        example: "VAR_INPUT
    forward : BOOL;
END_VAR
VAR
    pattern : BYTE := 1;
END_VAR

+--[P]( forward )--------------------------------[SHL]( pattern, pattern, 1 )--+",
        ..BASE
    },
    Instruction {
        op: Op::Shr,
        mnemonic: "SHR",
        profiles: Profiles::WITHOUT_IOT,
        title: "Shift right",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::BitsOrInteger), "The result."),
            Operand::input("a", Accepts::Value, "The value whose bits are moved."),
            Operand::input("n", Accepts::Integer, "How many places, 0 or more."),
        ],
        doc: "Shifts the bits of a to the right by n places, into y.

The shift is made in y's width; zeros come in at the left, also for signed integers, so it is not a division
of a negative number. n past the width gives 0; a negative n is a fault: y keeps its value and ENO is low.

IEC 61131-3: SHR.",
        example: "VAR_INPUT
    both : WORD;
END_VAR
VAR
    high_byte : WORD;
END_VAR

+-------------------------------------------------[SHR]( high_byte, both, 8 )--+",
        ..BASE
    },
    Instruction {
        op: Op::Rol,
        mnemonic: "ROL",
        profiles: Profiles::WITHOUT_IOT,
        title: "Rotate left",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::BitsOrInteger), "The result."),
            Operand::input("a", Accepts::Value, "The value whose bits are moved."),
            Operand::input("n", Accepts::Integer, "How many places, 0 or more."),
        ],
        doc: "Rotates the bits of a to the left by n places, into y.

What leaves at the left comes in again at the right, in y's width. n counts modulo the width; a negative n
is a fault: y keeps its value and ENO is low. While EN is high it rotates in every scan, so put an edge in
front of a rotation of y itself.

IEC 61131-3: ROL.",
        example: "VAR_INPUT
    forward : BOOL;
END_VAR
VAR
    lamps : BYTE := 16#11;
END_VAR

+--[P]( forward )------------------------------------[ROL]( lamps, lamps, 1 )--+",
        ..BASE
    },
    Instruction {
        op: Op::Ror,
        mnemonic: "ROR",
        profiles: Profiles::WITHOUT_IOT,
        title: "Rotate right",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::BitsOrInteger), "The result."),
            Operand::input("a", Accepts::Value, "The value whose bits are moved."),
            Operand::input("n", Accepts::Integer, "How many places, 0 or more."),
        ],
        doc: "Rotates the bits of a to the right by n places, into y.

What leaves at the right comes in again at the left, in y's width. n counts modulo the width; a negative n
is a fault: y keeps its value and ENO is low. While EN is high it rotates in every scan, so put an edge in
front of a rotation of y itself.

IEC 61131-3: ROR.",
        example: "VAR_INPUT
    forward : BOOL;
END_VAR
VAR
    lamps : BYTE := 16#11;
END_VAR

+--[P]( forward )------------------------------------[ROR]( lamps, lamps, 1 )--+",
        ..BASE
    },
];
