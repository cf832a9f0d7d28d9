//! Coils (LANGUAGE §5.4).

use crate::instruction::{Acts, Group, Instruction, Role, Shape};
use crate::op::Op;
use crate::operand::{Accepts, Operand};
use crate::power::{Coil, Edge, Power};
use crate::profile::{Profile, Profiles};

/// What the rows of this section share.
const BASE: Instruction = Instruction {
    op: Op::Coil,
    mnemonic: "",
    synonyms: &[],
    aliases: &[],
    shape: Shape::Coil,
    role: Role::Acting,
    acts: Acts::Always,
    group: Group::Coil,
    operands: &[],
    profiles: Profiles::ALL,
    differs: &[],
    power: Power::Passes,
    coil: Some(Coil::Follows),
    eno: "EN",
    title: "",
    doc: "",
    example: "",
};

pub(super) const ROWS: &[Instruction] = &[
    Instruction {
        op: Op::Coil,
        mnemonic: " ",
        differs: &[
            (Profile::Iot, "A number becomes 1 or 0."),
        ],
        title: "Coil",
        operands: &[Operand::output(
            "tag",
            Accepts::BoolOrRange,
            "The bit, or the bits, that follow EN.",
        )],
        doc: "Makes its tag high while power reaches it, and low otherwise.

With a range of BOOLs (`a[1..8]`) all its bits follow. The tag is written at every evaluation, so a second
`( )` on the same tag would overwrite this one: join the conditions of one output in one network. The coil
passes EN on, so several can be in a row.

A coil that is jumped over, or in a function that is not called, leaves the tag as it is.

IEC 61131-3: coil.",
        example: r"VAR_INPUT
    start, stop : BOOL;
END_VAR
VAR_OUTPUT
    run : BOOL;
END_VAR

+--\--[ ]( start )--\--[/]( stop )---------------------------------( )( run )--+
|  /--[ ]( run )----/                                                          |",
        ..BASE
    },
    Instruction {
        op: Op::NegatedCoil,
        coil: Some(Coil::Negated),
        mnemonic: "/",
        differs: &[
            (Profile::Iot, "A number becomes 0 or 1."),
        ],
        title: "Negated coil",
        operands: &[Operand::output(
            "tag",
            Accepts::Bool,
            "The bit that is the opposite of EN.",
        )],
        doc: "Makes its tag low while power reaches it, and high otherwise.

The tag is written at every evaluation. The coil passes EN on, not the value of the tag.

IEC 61131-3: negated coil.",
        example: "VAR_INPUT
    pressure_ok : BOOL;
END_VAR
VAR_OUTPUT
    alarm : BOOL;
END_VAR

+--[ ]( pressure_ok )--------------------------------------------(/)( alarm )--+",
        ..BASE
    },
    Instruction {
        op: Op::SetCoil,
        power: Power::SetTag,
        coil: Some(Coil::Sets),
        mnemonic: "S",
        differs: &[
            (Profile::Ldmicro, "The power after it is EN."),
            (Profile::Iot, "The power after it is EN. A number becomes 1."),
(Profile::Logix, "The power after it is EN."),
],
        title: "Set coil",
        operands: &[Operand::output(
            "tag",
            Accepts::BoolOrRange,
            "The bit, or the bits, that are set.",
        )],
        eno: "the tag",
        doc: "Makes its tag high when power reaches it; without power the tag keeps its value.

The tag stays high until something else clears it, usually `(R)`. If `(S)` and `(R)` on one tag both have
power, the one that runs later decides. With a range of BOOLs (`a[1..8]`) all bits are set.

ENO is the tag itself (of a range: all of it), not EN: what is after the block has power as long as the
tag is high.

IEC 61131-3: set (latch) coil.",
        example: "VAR_INPUT
    start, stop : BOOL;
END_VAR
VAR_OUTPUT
    run : BOOL;
END_VAR

+--[ ]( start )----------------------------------------------------(S)( run )--+
+--[ ]( stop )-----------------------------------------------------(R)( run )--+",
        ..BASE
    },
    Instruction {
        op: Op::ResetCoil,
        coil: Some(Coil::Resets),
        mnemonic: "R",
        differs: &[
            (Profile::Iot, "A number becomes 0."),
        ],
        title: "Reset coil",
        operands: &[Operand::output(
            "tag",
            Accepts::BoolRangeOrState,
            "The bits that are cleared, or a timer or counter.",
        )],
        doc: "Makes its tag low when power reaches it; without power the tag keeps its value.

If `(S)` and `(R)` on one tag both have power, the one that runs later decides: put the reset last where
stopping must win. With a range of BOOLs (`a[1..8]`) all bits are cleared. On the tag of a timer or counter
it acts as `(RES)`.

The coil passes EN on.

IEC 61131-3: reset (unlatch) coil.",
        example: "VAR_INPUT
    start, stop : BOOL;
END_VAR
VAR_OUTPUT
    run : BOOL;
END_VAR

+--[ ]( start )----------------------------------------------------(S)( run )--+
+--[ ]( stop )-----------------------------------------------------(R)( run )--+",
        ..BASE
    },
    Instruction {
        op: Op::RisingCoil,
        coil: Some(Coil::OnEdge(Edge::Rising)),
        mnemonic: "P",
        profiles: Profiles::WITHOUT_LDMICRO,
        differs: &[
            (Profile::Iot, "Its memory is that of all edges of the tag."),
(Profile::Logix, "An EN that is high at the first evaluation has not risen."),
],
        title: "Rising-edge coil",
        operands: &[Operand::output(
            "tag",
            Accepts::Bool,
            "The bit that is high for one scan when EN rises.",
        )],
        doc: "Makes its tag high when EN rises, and low at the next evaluation.

Where the coil runs in every scan the tag is high for one scan. Power that is already there at the first
evaluation counts as a rise. The coil passes EN on, not the edge.

IEC 61131-3: positive transition-sensing coil.",
        example: "VAR_INPUT
    start : BOOL;
END_VAR
VAR
    start_pulse : BOOL;
END_VAR

+--[ ]( start )--------------------------------------------(P)( start_pulse )--+",
        ..BASE
    },
    Instruction {
        op: Op::FallingCoil,
        coil: Some(Coil::OnEdge(Edge::Falling)),
        mnemonic: "N",
        profiles: Profiles::WITHOUT_LDMICRO,
        differs: &[
            (Profile::Iot, "Its memory is that of all edges of the tag."),
        ],
        title: "Falling-edge coil",
        operands: &[Operand::output(
            "tag",
            Accepts::Bool,
            "The bit that is high for one scan when EN falls.",
        )],
        doc: "Makes its tag high when EN falls, and low at the next evaluation.

Where the coil runs in every scan the tag is high for one scan. The first evaluation never reports a fall.
The coil passes EN on, not the edge.

IEC 61131-3: negative transition-sensing coil.",
        example: "VAR_INPUT
    run : BOOL;
END_VAR
VAR
    stop_pulse : BOOL;
END_VAR

+--[ ]( run )-----------------------------------------------(N)( stop_pulse )--+",
        ..BASE
    },
    Instruction {
        op: Op::RetentiveCoil,
        mnemonic: "M",
        profiles: Profiles::WITHOUT_LDMICRO,
        title: "Retentive coil",
        operands: &[Operand::output(
            "tag",
            Accepts::BoolOrRange,
            "The bit, or the bits, that follow EN and are retentive.",
        )],
        doc: "Makes its tag high while power reaches it and low otherwise, as `( )` does, and the tag retentive.

A retentive tag keeps its value over a warm restart; any other starts with its initial value. The first
evaluation after the restart writes the tag again, so the kept value is only seen by what runs before.
Declaring the tag in a `RETAIN` section does the same.

From the ladder diagrams of the first edition of IEC 61131-3.",
        example: "VAR_INPUT
    auto_switch : BOOL;
END_VAR
VAR
    auto_mode : BOOL;
END_VAR

+--[ ]( auto_switch )----------------------------------------(M)( auto_mode )--+",
        ..BASE
    },
    Instruction {
        op: Op::RetentiveSet,
        power: Power::SetTag,
        coil: Some(Coil::Sets),
        mnemonic: "SM",
        profiles: Profiles::WITHOUT_LDMICRO,
        differs: &[
            (Profile::Iot, "The power after it is EN. A number becomes 1."),
        ],
        title: "Set retentive coil",
        operands: &[Operand::output(
            "tag",
            Accepts::BoolOrRange,
            "The bit, or the bits, that are set and are retentive.",
        )],
        eno: "the tag",
        doc: "Makes its tag high when power reaches it, as `(S)` does, and the tag retentive.

A retentive tag keeps its value over a warm restart: what was latched before a power failure is still
latched after it. ENO is the tag itself. Declaring the tag in a `RETAIN` section and writing `(S)` does the
same.

From the ladder diagrams of the first edition of IEC 61131-3.",
        example: "VAR_INPUT
    jam, acknowledge : BOOL;
END_VAR
VAR
    jammed : BOOL;
END_VAR

+--[ ]( jam )--------------------------------------------------(SM)( jammed )--+
+--[ ]( acknowledge )------------------------------------------(RM)( jammed )--+",
        ..BASE
    },
    Instruction {
        op: Op::RetentiveReset,
        coil: Some(Coil::Resets),
        mnemonic: "RM",
        profiles: Profiles::WITHOUT_LDMICRO,
        differs: &[
            (Profile::Iot, "A number becomes 0."),
        ],
        title: "Reset retentive coil",
        operands: &[Operand::output(
            "tag",
            Accepts::BoolRangeOrState,
            "The bits that are cleared and are retentive, or a timer or counter.",
        )],
        doc: "Makes its tag low when power reaches it, as `(R)` does, and the tag retentive.

A retentive tag keeps its value over a warm restart. The coil passes EN on. Declaring the tag in a `RETAIN`
section and writing `(R)` does the same.

From the ladder diagrams of the first edition of IEC 61131-3.",
        example: "VAR_INPUT
    jam, acknowledge : BOOL;
END_VAR
VAR
    jammed : BOOL;
END_VAR

+--[ ]( jam )--------------------------------------------------(SM)( jammed )--+
+--[ ]( acknowledge )------------------------------------------(RM)( jammed )--+",
        ..BASE
    },
    Instruction {
        op: Op::Res,
        coil: None,
        mnemonic: "RES",
        differs: &[
            (Profile::Ldmicro, "ET or CV becomes 0. Q follows when the block is next evaluated."),
            (Profile::Iot, "ET becomes 0, CV the counter's `AC`; Q and IN become low."),
        ],
        title: "Reset timer or counter",
        operands: &[Operand::in_out(
            "tag",
            Accepts::TimerOrCounter,
            "The timer or counter that is cleared.",
        )],
        doc: "Clears a timer or a counter when power reaches it.

A timer's ET becomes 0 and its Q low, a counter's CV becomes 0; Q follows at once, so the rungs further down
already see it. It acts like a reset R that ends with it: if the timer's EN is high when the timer is next
reached, a TON or RTO starts again, a TOF or RTOF has Q high, a TP waits for a new rise.

The coil passes EN on.",
        example: "VAR_INPUT
    part_seen, new_box : BOOL;
END_VAR
VAR
    parts : CTU;
END_VAR
VAR_OUTPUT
    box_full : BOOL;
END_VAR

+--[ ]( part_seen )-----------------------[CTU]( parts, 12 )--( )( box_full )--+
+--[ ]( new_box )----------------------------------------------(RES)( parts )--+",
        ..BASE
    },
];
