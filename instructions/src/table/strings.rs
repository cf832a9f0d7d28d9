//! String functions (LANGUAGE §5.2, as in IEC 61131-3).

use crate::instruction::{Acts, Group, Instruction, Role, Shape};
use crate::op::Op;
use crate::operand::{Accepts, Operand, TypeClass};
use crate::power::Power;
use crate::profile::Profiles;

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
        op: Op::Len,
        mnemonic: "LEN",
        profiles: Profiles::OWN,
        title: "Length of a string",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Integer), "The result."),
            Operand::input("a", Accepts::String, "The string."),
        ],
        doc: "Puts the number of characters of a string into y.

y is any integer; the empty string has length 0. IEC 61131-3: LEN.",
        example: "VAR_INPUT
    code : STRING;
END_VAR
VAR
    length : INT;
END_VAR

+-------------------------------------------------------[LEN]( length, code )--+",
        ..BASE
    },
    Instruction {
        op: Op::Left,
        mnemonic: "LEFT",
        profiles: Profiles::OWN,
        title: "Left part of a string",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::String), "The result."),
            Operand::input("a", Accepts::String, "The string."),
            Operand::input("n", Accepts::Integer, "How many characters."),
        ],
        doc: "Puts the first n characters of a string into y.

A negative n, or more characters than the string has, is a fault: y keeps its value and ENO is low. IEC
61131-3: LEFT.",
        example: "VAR_INPUT
    code : STRING;
END_VAR
VAR
    maker : STRING;
END_VAR

+----------------------------------------------------[LEFT]( maker, code, 3 )--+",
        ..BASE
    },
    Instruction {
        op: Op::Right,
        mnemonic: "RIGHT",
        profiles: Profiles::OWN,
        title: "Right part of a string",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::String), "The result."),
            Operand::input("a", Accepts::String, "The string."),
            Operand::input("n", Accepts::Integer, "How many characters."),
        ],
        doc: "Puts the last n characters of a string into y.

A negative n, or more characters than the string has, is a fault: y keeps its value and ENO is low. IEC
61131-3: RIGHT.",
        example: "VAR_INPUT
    code : STRING;
END_VAR
VAR
    serial : STRING;
END_VAR

+--------------------------------------------------[RIGHT]( serial, code, 6 )--+",
        ..BASE
    },
    Instruction {
        op: Op::Mid,
        mnemonic: "MID",
        profiles: Profiles::OWN,
        title: "Middle part of a string",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::String), "The result."),
            Operand::input("a", Accepts::String, "The string."),
            Operand::input("n", Accepts::Integer, "How many characters."),
            Operand::input("p", Accepts::Integer, "The position of the first one, from 1."),
        ],
        doc: "Puts n characters of a string, from position p on, into y.

Positions count from 1. A negative n, or characters that the string does not have, are a fault: y keeps its
value and ENO is low. Mind the order, which is that of IEC 61131-3's MID: first how many, then from where.",
        example: "VAR_INPUT
    code : STRING;
END_VAR
VAR
    batch : STRING;
END_VAR

+--------------------------------------------------[MID]( batch, code, 4, 3 )--+",
        ..BASE
    },
    Instruction {
        op: Op::Concat,
        mnemonic: "CONCAT",
        profiles: Profiles::OWN,
        title: "Join strings",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::String), "The result."),
            Operand::input("a", Accepts::String, "The first string."),
            Operand::input("b", Accepts::String, "What is put after it.").repeated(),
        ],
        doc: "Joins its strings, in order, into y.

IEC 61131-3: CONCAT.",
        example: "VAR_INPUT
    batch, serial : STRING;
END_VAR
VAR
    label : STRING;
END_VAR

+---------------------------------------[CONCAT]( label, batch, '-', serial )--+",
        ..BASE
    },
    Instruction {
        op: Op::Insert,
        mnemonic: "INSERT",
        profiles: Profiles::OWN,
        title: "Insert into a string",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::String), "The result."),
            Operand::input("a", Accepts::String, "The string."),
            Operand::input("b", Accepts::String, "What is inserted."),
            Operand::input(
                "p",
                Accepts::Integer,
                "The position after which it is inserted; 0 is the beginning.",
            ),
        ],
        doc: "Puts b into a after position p, and the whole into y.

Position 0 is before the first character. A p outside the string is a fault: y keeps its value and ENO is
low. IEC 61131-3: INSERT.",
        example: "VAR_INPUT
    code : STRING;
END_VAR
VAR
    label : STRING;
END_VAR

+---------------------------------------------[INSERT]( label, code, '-', 3 )--+",
        ..BASE
    },
    Instruction {
        op: Op::Delete,
        mnemonic: "DELETE",
        profiles: Profiles::OWN,
        title: "Delete from a string",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::String), "The result."),
            Operand::input("a", Accepts::String, "The string."),
            Operand::input("n", Accepts::Integer, "How many characters."),
            Operand::input("p", Accepts::Integer, "The position of the first one, from 1."),
        ],
        doc: "Puts a without n of its characters, from position p on, into y.

Positions count from 1. A negative n, or characters that the string does not have, are a fault: y keeps its
value and ENO is low. Mind the order, which is that of IEC 61131-3's DELETE: first how many, then from
where.",
        example: "VAR_INPUT
    code : STRING;
END_VAR
VAR
    digits : STRING;
END_VAR

+----------------------------------------------[DELETE]( digits, code, 2, 1 )--+",
        ..BASE
    },
    Instruction {
        op: Op::Replace,
        mnemonic: "REPLACE",
        profiles: Profiles::OWN,
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
        doc: "Puts a into y, with b in the place of n of its characters from position p on.

Positions count from 1; b may be longer or shorter than what it replaces. A negative n, or characters that
the string does not have, are a fault: y keeps its value and ENO is low. Mind the order, which is that of
IEC 61131-3's REPLACE: first how many, then from where.",
        example: "VAR_INPUT
    code : STRING;
END_VAR
VAR
    label : STRING;
END_VAR

+-----------------------------------------[REPLACE]( label, code, 'X', 1, 3 )--+",
        ..BASE
    },
    Instruction {
        op: Op::Find,
        mnemonic: "FIND",
        profiles: Profiles::OWN,
        title: "Find in a string",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Integer), "The result."),
            Operand::input("a", Accepts::String, "The string that is searched."),
            Operand::input("b", Accepts::String, "The string that is looked for."),
        ],
        doc: "Puts the position at which b first occurs in a into y.

Positions count from 1; where b does not occur the result is 0. y is any integer. IEC 61131-3: FIND.",
        example: "VAR_INPUT
    code : STRING;
END_VAR
VAR
    dash : INT;
END_VAR

+---------------------------------------------------[FIND]( dash, code, '-' )--+",
        ..BASE
    },
];
