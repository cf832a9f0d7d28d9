//! Instructions on array ranges (LANGUAGE §5.2).

use crate::instruction::{Acts, Group, Instruction, Role, Shape};
use crate::op::Op;
use crate::operand::{Accepts, Operand, TypeClass};
use crate::power::Power;
use crate::profile::{Profile, Profiles};

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
        op: Op::Bmov,
        mnemonic: "BMOV",
        profiles: Profiles::OWN,
        title: "Move a range",
        operands: &[
            Operand::output("y", Accepts::Range, "The range that is written."),
            Operand::input(
                "a",
                Accepts::Range,
                "The range that is copied, of the same length.",
            ),
        ],
        doc: "Copies a range of an array into another range.

Both ranges have the same length and their elements the same type. If one operand is a single element, the
range begins there and is as long as the other. The copy is made as if through a buffer, so the two ranges
may overlap. An index outside its array is a fault: nothing is written and ENO is low.",
        example: "VAR_INPUT
    load : BOOL;
END_VAR
VAR
    recipes : ARRAY[1..40] OF INT;
    active  : ARRAY[1..4] OF INT;
END_VAR

+--[P]( load )-----------------------------[BMOV]( active[1..4], recipes[9] )--+",
        ..BASE
    },
    Instruction {
        op: Op::Fill,
        mnemonic: "FILL",
        profiles: Profiles::OWN,
        title: "Fill a range",
        operands: &[
            Operand::output("y", Accepts::Range, "The range that is written."),
            Operand::input("a", Accepts::Value, "The value for every element."),
        ],
        doc: "Writes one value into every element of a range.

The value must be of the elements' type or pass to it without loss. An index outside the array is a fault:
nothing is written and ENO is low.",
        example: "VAR_INPUT
    clear : BOOL;
END_VAR
VAR
    counts : ARRAY[1..8] OF INT;
END_VAR

+--[P]( clear )-------------------------------------[FILL]( counts[1..8], 0 )--+",
        ..BASE
    },
    Instruction {
        op: Op::Pack,
        mnemonic: "PACK",
        profiles: Profiles::OWN,
        differs: &[(
            Profile::Click,
            "A text that is not a number sets SC43, and nothing is written.",
        )],
        title: "Pack a range",
        operands: &[
            Operand::output("y", Accepts::Result(TypeClass::Any), "The result."),
            Operand::input(
                "a",
                Accepts::RangeOrValue,
                "The bits or words to put together, or a string that holds a number.",
            ),
        ],
        doc: "Puts the elements of a range together into one value.

- A range of BOOL gives the bits of y, the first one bit 0.
- A range of words gives a wider word, the first one the lowest part.
- A REAL or LREAL is made of its bits as IEEE 754 has them; those of no finite number are a fault.
- A string is read as a number.

`[UNPACK]` takes the value apart again. A string that cannot be read is a fault: y keeps its value and ENO
is low.",
        example: "VAR_INPUT
    switches : ARRAY[0..7] OF BOOL;
END_VAR
VAR
    setting : BYTE;
END_VAR

+-------------------------------------------[PACK]( setting, switches[0..7] )--+",
        ..BASE
    },
    Instruction {
        op: Op::Unpack,
        mnemonic: "UNPACK",
        profiles: Profiles::OWN,
        title: "Unpack into a range",
        operands: &[
            Operand::output(
                "y",
                Accepts::RangeOrValue,
                "The bits or words that are written, or a string for a number.",
            ),
            Operand::input("a", Accepts::Convertible, "The value that is taken apart."),
        ],
        doc: "Takes a value apart into the elements of a range.

- Into a range of BOOL go the bits of the value, bit 0 first.
- Into a range of words go its parts, the lowest first.
- The bits of a REAL or LREAL are those of IEEE 754.
- Into a string goes a number, written out.

`[PACK]` is the reverse.",
        example: "VAR_INPUT
    status : BYTE;
END_VAR
VAR_OUTPUT
    lamps : ARRAY[0..7] OF BOOL;
END_VAR

+---------------------------------------------[UNPACK]( lamps[0..7], status )--+",
        ..BASE
    },
    Instruction {
        op: Op::Shift,
        mnemonic: "SHIFT",
        profiles: Profiles::WITHOUT_IOT,
        title: "Shift register",
        operands: &[
            Operand::in_out("y", Accepts::Range, "The register; its elements move up."),
            Operand::input("d", Accepts::Value, "What enters at the first element."),
        ],
        doc: "Moves every element of a range one place up when EN rises, and takes d in at the first.

What stood in the last element is lost. One rise of EN is one step, however long EN stays high; EN that is
high at the first evaluation counts as a rise. ENO is EN, not the edge. The elements may be of any type:
with BOOL it follows parts along a conveyor, with numbers their data.",
        example: "VAR_INPUT
    step, part_seen : BOOL;
END_VAR
VAR
    belt : ARRAY[1..8] OF BOOL;
END_VAR
VAR_OUTPUT
    eject : BOOL;
END_VAR

+--[ ]( step )-------------------------------[SHIFT]( belt[1..8], part_seen )--+
+--[ ]( belt[8] )------------------------------------------------( )( eject )--+",
        ..BASE
    },
    Instruction {
        op: Op::Search,
        mnemonic: "SEARCH",
        profiles: Profiles::OWN,
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
            Operand::input("NEXT", Accepts::Bool, "High: go on after the index in y.").named(),
            Operand::output("FOUND", Accepts::Bool, "High if an element was found.").named(),
        ],
        doc:
            "Looks for the first element of a range that compares with a as asked, and puts its index into y.

The comparison reads `element op a`: with GT, the first element greater than a. The index is the array's
own. If there is none, y is -1; `FOUND` receives whether there was one.

With `NEXT` high the search goes on after the index in y, so one element after the other is found; once y
is -1 it stays -1, and any other y below the first index begins at the first. `NEXT` cannot be used on an
array with a negative bound.",
        example: "VAR
    weights     : ARRAY[1..20] OF INT;
    first_heavy : INT;
END_VAR
VAR_OUTPUT
    heavy : BOOL;
END_VAR

+------------[SEARCH]( first_heavy, GT, 500, weights[1..20], FOUND => heavy )--+",
        ..BASE
    },
];
