//! Choosing among values, and expressions (LANGUAGE §5.2).

use crate::instruction::{Acts, Group, Instruction, Role, Shape};
use crate::op::Op;
use crate::operand::{Accepts, Operand, TypeClass};
use crate::power::Power;
use crate::profile::{Profile, Profiles};

/// What the rows of this section share.
const BASE: Instruction = Instruction {
    op: Op::Min,
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
        op: Op::Min,
        mnemonic: "MIN",
        profiles: Profiles::OWN,
        title: "Smallest value",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::NumberOrTime), "The result."),
            Operand::input("a", Accepts::Value, "The first value."),
            Operand::input("b", Accepts::Value, "A further value.").repeated(),
        ],
        doc: "Puts the smallest of its operands into y.

All operands are brought to y's type; numbers and times can be compared. IEC 61131-3: MIN.",
        example: "VAR_INPUT
    wanted, allowed : INT;
END_VAR
VAR_OUTPUT
    speed : INT;
END_VAR

+---------------------------------------------[MIN]( speed, wanted, allowed )--+",
        ..BASE
    },
    Instruction {
        op: Op::Max,
        mnemonic: "MAX",
        profiles: Profiles::OWN,
        title: "Largest value",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::NumberOrTime), "The result."),
            Operand::input("a", Accepts::Value, "The first value."),
            Operand::input("b", Accepts::Value, "A further value.").repeated(),
        ],
        doc: "Puts the largest of its operands into y.

All operands are brought to y's type; numbers and times can be compared. IEC 61131-3: MAX.",
        example: "VAR_INPUT
    level : INT;
END_VAR
VAR
    peak : INT;
END_VAR

+--------------------------------------------------[MAX]( peak, peak, level )--+",
        ..BASE
    },
    Instruction {
        op: Op::Limit,
        mnemonic: "LIMIT",
        profiles: Profiles::OWN,
        title: "Limit",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::NumberOrTime), "The result."),
            Operand::input("low", Accepts::Value, "The lower limit."),
            Operand::input("a", Accepts::Value, "The value."),
            Operand::input("high", Accepts::Value, "The upper limit."),
        ],
        doc: "Puts a into y, held between low and high.

It is MIN(MAX(a, low), high): if low is above high by error, the result is high. Numbers and times can be
limited. IEC 61131-3: LIMIT.",
        example: "VAR_INPUT
    wanted : INT;
END_VAR
VAR_OUTPUT
    speed : INT;
END_VAR

+--------------------------------------------[LIMIT]( speed, 10, wanted, 50 )--+",
        ..BASE
    },
    Instruction {
        op: Op::Sel,
        mnemonic: "SEL",
        profiles: Profiles::OWN,
        title: "Select one of two",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Any), "The result."),
            Operand::input("g", Accepts::Bool, "The switch: low takes a, high takes b."),
            Operand::input("a", Accepts::Value, "The value while g is low."),
            Operand::input("b", Accepts::Value, "The value while g is high."),
        ],
        doc: "Puts one of two values into y: a while g is low, b while g is high.

Any elementary type will do; both values are brought to y's type. IEC 61131-3: SEL.",
        example: "VAR_INPUT
    fast : BOOL;
END_VAR
VAR_OUTPUT
    speed : INT;
END_VAR

+------------------------------------------------[SEL]( speed, fast, 10, 50 )--+",
        ..BASE
    },
    Instruction {
        op: Op::Mux,
        mnemonic: "MUX",
        profiles: Profiles::OWN,
        title: "Select one of many",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Any), "The result."),
            Operand::input("k", Accepts::Integer, "Which value, from 0."),
            Operand::input("a", Accepts::Value, "Value 0."),
            Operand::input("b", Accepts::Value, "Value 1, and so on.").repeated(),
        ],
        doc: "Puts the k-th of its values into y, counted from 0.

`[MUX]( y, 0, a, b )` gives a. Any elementary type will do; the values are brought to y's type, k is any
integer. A k outside the list is a fault: y keeps its value and ENO is low.

For a list of fixed numbers see also `[LUT]`. IEC 61131-3: MUX.",
        example: "VAR_INPUT
    recipe : INT;
END_VAR
VAR
    duration : TIME;
END_VAR

+--------------------------------[MUX]( duration, recipe, T#5s, T#8s, T#12s )--+",
        ..BASE
    },
    Instruction {
        op: Op::Calc,
        mnemonic: "CALC",
        profiles: Profiles::OWN,
        differs: &[
            (
                Profile::Click,
                "The formula is computed in the widest type of its parts and of y: 16 bits where all have 16, REAL where one is real, LREAL with a DINT next to it; words as unsigned integers. The result is cut to y's type. What does not fit wraps round and sets SC43, a division by 0 makes all of it 0 and sets SC40, MOD takes the sign of the divisor. A function outside its domain sets SC46, and the scan is the last one.",
            ),
            (
                Profile::Logix,
                "It computes in the widest type of its parts and its result, in 32 bits at least. The result is rounded, half to even, to y's type, and loses its upper bits where it does not fit. An integer divided by 0 gives the dividend.",
            ),
        ],
        title: "Calculate",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Any), "The result."),
            Operand::input(
                "expression",
                Accepts::Expression,
                "The formula, as in `(a + b) / 2`.",
            ),
        ],
        doc: "Evaluates a formula into y.

The operators, from the one that binds loosest:

| operators | meaning |
| --- | --- |
| `OR`, then `XOR`, then `AND` | logical on BOOL, bitwise otherwise |
| `= <>`, then `< <= > >=` | comparison |
| `SHL SHR` | shifts |
| `+ -` | sum, difference |
| `* / MOD` | product, quotient, remainder |
| `^` | power, grouped to the right |
| `-` `NOT` in front of a value | sign, inversion |

Parentheses group. The other instructions that compute a value are called by name, without the y: `SQRT(x)`,
`LIMIT(0, x, 100)`, `LEN(text)`; `SUM(a[1..9])` adds the elements of a range, and `PI` is the number.

- Arithmetic is done in y's type, so `1 / 2` into a DINT is 0. The two sides of a comparison have a type of
  their own.
- The sign binds tightest, as in IEC 61131-3: `-2 ^ 2` is 4.
- Division by zero, an index outside its array and the like are faults: y keeps its value and ENO is low.",
        example: "VAR_INPUT
    width, height : REAL;
END_VAR
VAR
    diagonal : REAL;
END_VAR

+----------------------------[CALC]( diagonal, SQRT(width ^ 2 + height ^ 2) )--+",
        ..BASE
    },
];
