//! Functions of one number (LANGUAGE §5.2).

use crate::instruction::{Acts, Group, Instruction, Role, Shape};
use crate::op::Op;
use crate::operand::{Accepts, Operand, TypeClass};
use crate::power::Power;
use crate::profile::Profiles;

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
        op: Op::Abs,
        mnemonic: "ABS",
        profiles: Profiles::OWN,
        title: "Absolute value",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Number), "The result."),
            Operand::input("a", Accepts::Value, "The value."),
        ],
        doc: "Puts the absolute value of a into y.

It works on integers and reals. The smallest number of a signed integer type has no positive partner and
stays as it is (INT: -32768).

IEC 61131-3: ABS.",
        example: "VAR_INPUT
    deviation : INT;
END_VAR
VAR
    distance : INT;
END_VAR

+--------[ABS]( distance, deviation )--+",
        ..BASE
    },
    Instruction {
        op: Op::Neg,
        mnemonic: "NEG",
        profiles: Profiles::WITHOUT_IOT,
        title: "Negate",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Number), "The result."),
            Operand::input("a", Accepts::Value, "The value."),
        ],
        doc: "Puts a with the opposite sign into y.

It works on integers and reals. Integers wrap around: the smallest number of a signed type stays as it is
(INT: -32768), and an unsigned number passes its lower end (UINT: 5 becomes 65531).",
        example: "VAR_INPUT
    speed : INT;
END_VAR
VAR_OUTPUT
    reverse : INT;
END_VAR

+-------------[NEG]( reverse, speed )--+",
        ..BASE
    },
    Instruction {
        op: Op::Trunc,
        mnemonic: "TRUNC",
        profiles: Profiles::OWN,
        title: "Truncate",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Number), "The result."),
            Operand::input("a", Accepts::Number, "The value; a real may go into an integer."),
        ],
        doc: "Cuts the fraction of a off, into y.

It goes toward zero: 2.9 gives 2, -2.9 gives -2. y may be an integer or a real; a number that an integer y
cannot hold is a fault: y keeps its value and ENO is low. To round to the nearest integer use `[TYP]`.

IEC 61131-3: TRUNC.",
        example: "VAR_INPUT
    length : REAL;
END_VAR
VAR_OUTPUT
    whole_metres : DINT;
END_VAR

+-----[TRUNC]( whole_metres, length )--+",
        ..BASE
    },
    Instruction {
        op: Op::Sqrt,
        mnemonic: "SQRT",
        profiles: Profiles::OWN,
        title: "Square root",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Real), "The result."),
            Operand::input("a", Accepts::Value, "The value, 0 or more."),
        ],
        doc: "Puts the square root of a into y.

y is a REAL or LREAL. A negative a is a fault: y keeps its value and ENO is low. IEC 61131-3: SQRT.",
        example: "VAR_INPUT
    pressure_drop : REAL;
END_VAR
VAR_OUTPUT
    flow : REAL;
END_VAR

+-------[SQRT]( flow, pressure_drop )--+",
        ..BASE
    },
    Instruction {
        op: Op::Ln,
        mnemonic: "LN",
        profiles: Profiles::OWN,
        title: "Natural logarithm",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Real), "The result."),
            Operand::input("a", Accepts::Value, "The value, above 0."),
        ],
        doc: "Puts the natural logarithm of a into y.

y is a REAL or LREAL. An a of 0 or below is a fault: y keeps its value and ENO is low. IEC 61131-3: LN.",
        example: "VAR_INPUT
    ratio : REAL;
END_VAR
VAR
    exponent : REAL;
END_VAR

+-------------[LN]( exponent, ratio )--+",
        ..BASE
    },
    Instruction {
        op: Op::Log,
        mnemonic: "LOG",
        profiles: Profiles::OWN,
        title: "Logarithm to base 10",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Real), "The result."),
            Operand::input("a", Accepts::Value, "The value, above 0."),
        ],
        doc: "Puts the logarithm of a to base 10 into y.

y is a REAL or LREAL. An a of 0 or below is a fault: y keeps its value and ENO is low. IEC 61131-3: LOG.",
        example: "VAR_INPUT
    power_ratio : REAL;
END_VAR
VAR
    bels : REAL;
END_VAR

+----------[LOG]( bels, power_ratio )--+",
        ..BASE
    },
    Instruction {
        op: Op::Expe,
        mnemonic: "EXPE",
        profiles: Profiles::OWN,
        title: "Power of e",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Real), "The result."),
            Operand::input("a", Accepts::Value, "The exponent."),
        ],
        doc: "Puts e (2.718...) to the power of a into y.

y is a REAL or LREAL. A result that is not finite is a fault: y keeps its value and ENO is low. For other
bases use `[EXP]`. IEC 61131-3: EXP.",
        example: "VAR_INPUT
    x : REAL;
END_VAR
VAR
    growth : REAL;
END_VAR

+-----------------[EXPE]( growth, x )--+",
        ..BASE
    },
    Instruction {
        op: Op::Sin,
        mnemonic: "SIN",
        profiles: Profiles::OWN,
        title: "Sine",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Real), "The result."),
            Operand::input("a", Accepts::Value, "The angle in radians."),
        ],
        doc: "Puts the sine of a into y.

a is an angle in radians; `[RAD]` makes radians of degrees. y is a REAL or LREAL. IEC 61131-3: SIN.",
        example: "VAR_INPUT
    degrees : REAL;
END_VAR
VAR
    angle, height : REAL;
END_VAR

+---------[RAD]( angle, degrees )--[SIN]( height, angle )--+",
        ..BASE
    },
    Instruction {
        op: Op::Cos,
        mnemonic: "COS",
        profiles: Profiles::OWN,
        title: "Cosine",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Real), "The result."),
            Operand::input("a", Accepts::Value, "The angle in radians."),
        ],
        doc: "Puts the cosine of a into y.

a is an angle in radians; `[RAD]` makes radians of degrees. y is a REAL or LREAL. IEC 61131-3: COS.",
        example: "VAR_INPUT
    degrees : REAL;
END_VAR
VAR
    angle, reach : REAL;
END_VAR

+----------[RAD]( angle, degrees )--[COS]( reach, angle )--+",
        ..BASE
    },
    Instruction {
        op: Op::Tan,
        mnemonic: "TAN",
        profiles: Profiles::OWN,
        title: "Tangent",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Real), "The result."),
            Operand::input("a", Accepts::Value, "The angle in radians."),
        ],
        doc: "Puts the tangent of a into y.

a is an angle in radians; `[RAD]` makes radians of degrees. y is a REAL or LREAL. Near a quarter turn the
result grows very large. IEC 61131-3: TAN.",
        example: "VAR_INPUT
    degrees : REAL;
END_VAR
VAR
    angle, slope : REAL;
END_VAR

+----------[RAD]( angle, degrees )--[TAN]( slope, angle )--+",
        ..BASE
    },
    Instruction {
        op: Op::Asin,
        mnemonic: "ASIN",
        profiles: Profiles::OWN,
        title: "Arc sine",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Real), "The result."),
            Operand::input("a", Accepts::Value, "The sine, from -1 to 1."),
        ],
        doc: "Puts the angle whose sine is a into y, in radians.

The angle lies between -PI/2 and PI/2; `[DEG]` makes degrees of it. y is a REAL or LREAL. An a below -1 or
above 1 is a fault: y keeps its value and ENO is low. IEC 61131-3: ASIN.",
        example: "VAR_INPUT
    height : REAL;
END_VAR
VAR
    angle, degrees : REAL;
END_VAR

+--------[ASIN]( angle, height )--[DEG]( degrees, angle )--+",
        ..BASE
    },
    Instruction {
        op: Op::Acos,
        mnemonic: "ACOS",
        profiles: Profiles::OWN,
        title: "Arc cosine",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Real), "The result."),
            Operand::input("a", Accepts::Value, "The cosine, from -1 to 1."),
        ],
        doc: "Puts the angle whose cosine is a into y, in radians.

The angle lies between 0 and PI; `[DEG]` makes degrees of it. y is a REAL or LREAL. An a below -1 or above 1
is a fault: y keeps its value and ENO is low. IEC 61131-3: ACOS.",
        example: "VAR_INPUT
    reach : REAL;
END_VAR
VAR
    angle, degrees : REAL;
END_VAR

+---------[ACOS]( angle, reach )--[DEG]( degrees, angle )--+",
        ..BASE
    },
    Instruction {
        op: Op::Atan,
        mnemonic: "ATAN",
        profiles: Profiles::OWN,
        title: "Arc tangent",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Real), "The result."),
            Operand::input("a", Accepts::Value, "The tangent."),
        ],
        doc: "Puts the angle whose tangent is a into y, in radians.

The angle lies between -PI/2 and PI/2; `[DEG]` makes degrees of it. y is a REAL or LREAL. IEC 61131-3: ATAN.",
        example: "VAR_INPUT
    slope : REAL;
END_VAR
VAR
    angle, degrees : REAL;
END_VAR

+---------[ATAN]( angle, slope )--[DEG]( degrees, angle )--+",
        ..BASE
    },
    Instruction {
        op: Op::Rad,
        mnemonic: "RAD",
        profiles: Profiles::OWN,
        title: "Degrees to radians",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Real), "The result."),
            Operand::input("a", Accepts::Value, "The angle in degrees."),
        ],
        doc: "Converts an angle from degrees to radians, into y.

y is a REAL or LREAL. The trigonometric functions take radians; `[DEG]` goes the other way.",
        example: "VAR_INPUT
    degrees : REAL;
END_VAR
VAR
    angle, height : REAL;
END_VAR

+---------[RAD]( angle, degrees )--[SIN]( height, angle )--+",
        ..BASE
    },
    Instruction {
        op: Op::Deg,
        mnemonic: "DEG",
        profiles: Profiles::OWN,
        title: "Radians to degrees",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Real), "The result."),
            Operand::input("a", Accepts::Value, "The angle in radians."),
        ],
        doc: "Converts an angle from radians to degrees, into y.

y is a REAL or LREAL. The inverse trigonometric functions give radians; `[RAD]` goes the other way.",
        example: "VAR_INPUT
    slope : REAL;
END_VAR
VAR
    angle, degrees : REAL;
END_VAR

+---------[ATAN]( angle, slope )--[DEG]( degrees, angle )--+",
        ..BASE
    },
];
