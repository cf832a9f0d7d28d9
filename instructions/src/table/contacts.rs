//! Contacts, edges and the inverter (LANGUAGE §5.1).

use crate::instruction::{Acts, Group, Instruction, Role, Shape};
use crate::op::Op;
use crate::operand::{Accepts, Operand};
use crate::power::{Edge, Power};
use crate::profile::{Profile, Profiles};

/// What the rows of this section share.
const BASE: Instruction = Instruction {
    op: Op::Contact,
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
    power: Power::Level { high: true },
    coil: None,
    eno: "EN and tag",
    title: "",
    doc: "",
    example: "",
};

pub(super) const ROWS: &[Instruction] = &[
    Instruction {
        op: Op::Contact,
        mnemonic: " ",
        differs: &[(
            Profile::Iot,
            "The tag may be a number: it is high unless it is 0.",
        )],
        title: "Open contact",
        operands: &[Operand::input(
            "tag",
            Accepts::BoolOrRange,
            "The bit that is asked; of a range, every bit.",
        )],
        eno: "EN and tag",
        doc: "Passes power while its tag is high.

With a range of BOOLs (`a[1..8]`) it passes power while every bit of the range is high. It reads the tag
only when EN is high, at the moment it is reached: a coil further up that wrote the tag in this scan is
already seen.

IEC 61131-3: normally open contact.",
        example: "VAR_INPUT
    guard_closed, start : BOOL;
END_VAR
VAR_OUTPUT
    run : BOOL;
END_VAR

+--[ ]( guard_closed )--[ ]( start )-------------------------------( )( run )--+",
        ..BASE
    },
    Instruction {
        op: Op::NegatedContact,
        power: Power::Level { high: false },
        mnemonic: "/",
        differs: &[(
            Profile::Iot,
            "The tag may be a number: it is high unless it is 0.",
        )],
        title: "Closed contact",
        operands: &[Operand::input(
            "tag",
            Accepts::BoolOrRange,
            "The bit that is asked; of a range, no bit may be high.",
        )],
        eno: "EN and not tag",
        doc: "Passes power while its tag is low.

With a range of BOOLs (`a[1..8]`) it passes power while no bit of the range is high. It reads the tag only
when EN is high.

A stop button that is wired normally closed reads high while nobody presses it: for such an input the open
contact `[ ]` is the right one.

IEC 61131-3: normally closed contact.",
        example: "VAR_INPUT
    start, overload : BOOL;
END_VAR
VAR_OUTPUT
    run : BOOL;
END_VAR

+--[ ]( start )--[/]( overload )-----------------------------------( )( run )--+",
        ..BASE
    },
    Instruction {
        op: Op::RisingContact,
        power: Power::TagEdge(Edge::Rising),
        mnemonic: "P",
        acts: Acts::Always,
        profiles: Profiles::WITHOUT_LDMICRO,
        differs: &[
            (
                Profile::Iot,
                "All edges of one tag share one memory: of two blocks in one scan only the first sees the edge. The tag may be a number.",
            ),
            (
                Profile::Logix,
                "A tag that is high at the first evaluation has not risen.",
            ),
        ],
        title: "Rising-edge contact",
        operands: &[Operand::input(
            "tag",
            Accepts::Bool,
            "The bit whose rise is watched.",
        )],
        eno: "EN and tag rose",
        doc: "Passes power for one scan when its tag goes from low to high.

- The memory of the last state belongs to this place in the program and is brought up to date at every
  evaluation, also while EN is low. A rise that happens while EN is low is therefore missed, not kept for
  later.
- A tag that is already high at the first evaluation counts as having risen.
- It compares with its last evaluation, in this scan or an earlier one: jumped over, it misses what happened
  meanwhile; in a loop, it sees each change from turn to turn.

To watch the power of the wire instead of a tag, use `[OSR]`. IEC 61131-3: positive transition-sensing
contact.",
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
        op: Op::FallingContact,
        power: Power::TagEdge(Edge::Falling),
        mnemonic: "N",
        acts: Acts::Always,
        profiles: Profiles::WITHOUT_LDMICRO,
        differs: &[(
            Profile::Iot,
            "All edges of one tag share one memory: of two blocks in one scan only the first sees the edge. The tag may be a number.",
        )],
        title: "Falling-edge contact",
        operands: &[Operand::input(
            "tag",
            Accepts::Bool,
            "The bit whose fall is watched.",
        )],
        eno: "EN and tag fell",
        doc: "Passes power for one scan when its tag goes from high to low.

- The memory of the last state belongs to this place in the program and is brought up to date at every
  evaluation, also while EN is low. A fall that happens while EN is low is therefore missed, not kept for
  later.
- The first evaluation never reports a fall.
- It compares with its last evaluation, in this scan or an earlier one: jumped over, it misses what happened
  meanwhile; in a loop, it sees each change from turn to turn.

To watch the power of the wire instead of a tag, use `[OSF]`. IEC 61131-3: negative transition-sensing
contact.",
        example: "VAR_INPUT
    door_closed : BOOL;
END_VAR
VAR
    openings : DINT;
END_VAR

+--[N]( door_closed )--------------------------[ADD]( openings, openings, 1 )--+",
        ..BASE
    },
    Instruction {
        op: Op::Inverter,
        power: Power::Inverts,
        mnemonic: "NOT",
        acts: Acts::Always,
        profiles: Profiles::OWN,
        title: "Inverter",
        eno: "not EN",
        doc: r#"Passes power exactly when none arrives.

It inverts everything to its left, up to the rail or the point where branches join. After it power flows
also when the contacts to the left are open, so a coil there is high when the rung is "off".

Without operands it is this inverter; `[NOT]( y, a )` inverts the bits of a value."#,
        example: "VAR_INPUT
    guard_closed, air_ok : BOOL;
END_VAR
VAR_OUTPUT
    alarm : BOOL;
END_VAR

+--[ ]( guard_closed )--[ ]( air_ok )--[NOT]---------------------( )( alarm )--+",
        ..BASE
    },
    Instruction {
        op: Op::OneShotRising,
        differs: &[(
            Profile::Logix,
            "An EN that is high at the first evaluation has not risen.",
        )],
        power: Power::EnEdge(Edge::Rising),
        mnemonic: "OSR",
        aliases: &["R_TRIG"],
        acts: Acts::Always,
        profiles: Profiles::WITHOUT_IOT,
        title: "One shot rising",
        eno: "EN rose",
        doc: "Passes power for one scan when the power that reaches it goes from low to high.

- The memory belongs to this place in the program.
- Power that is already there at the first evaluation counts as having risen.
- It compares with its last evaluation, in this scan or an earlier one: jumped over, it misses what happened
  meanwhile; in a loop, it sees each change from turn to turn.

To watch a tag instead of the wire, use `[P]`. IEC 61131-3: R_TRIG.",
        example: "VAR_INPUT
    auto, start : BOOL;
END_VAR
VAR
    starts : DINT;
END_VAR

+--[ ]( auto )--[ ]( start )--[OSR]----------------[ADD]( starts, starts, 1 )--+",
        ..BASE
    },
    Instruction {
        op: Op::OneShotFalling,
        power: Power::EnEdge(Edge::Falling),
        mnemonic: "OSF",
        aliases: &["F_TRIG"],
        acts: Acts::Always,
        profiles: Profiles::WITHOUT_IOT,
        title: "One shot falling",
        eno: "EN fell",
        doc: "Passes power for one scan when the power that reaches it goes from high to low.

- The memory belongs to this place in the program.
- The first evaluation never reports a fall. (The F_TRIG of IEC 61131-3 reports one at its first call if its
  input is low.)
- It compares with its last evaluation, in this scan or an earlier one: jumped over, it misses what happened
  meanwhile; in a loop, it sees each change from turn to turn.

To watch a tag instead of the wire, use `[N]`. IEC 61131-3: F_TRIG.",
        example: "VAR_INPUT
    auto, run : BOOL;
END_VAR
VAR
    stops : DINT;
END_VAR

+--[ ]( auto )--[ ]( run )--[OSF]--------------------[ADD]( stops, stops, 1 )--+",
        ..BASE
    },
];
