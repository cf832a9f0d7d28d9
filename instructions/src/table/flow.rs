//! Program flow (LANGUAGE §5.5).

use crate::instruction::{Acts, Group, Instruction, Role, Shape};
use crate::op::Op;
use crate::operand::{Accepts, Operand, TypeClass};
use crate::power::Power;
use crate::profile::{Profile, Profiles};

/// What the rows of this section share.
const BASE: Instruction = Instruction {
    op: Op::Lbl,
    mnemonic: "",
    synonyms: &[],
    aliases: &[],
    shape: Shape::Function,
    role: Role::Acting,
    acts: Acts::WhenPowered,
    group: Group::Flow,
    operands: &[],
    profiles: Profiles::ALL,
    differs: &[],
    power: Power::Passes,
    coil: None,
    eno: "EN",
    title: "",
    doc: "",
    example: "",
};

pub(super) const ROWS: &[Instruction] = &[
    Instruction {
        op: Op::Lbl,
        mnemonic: "LBL",
        role: Role::Condition,
        profiles: Profiles::WITHOUT_IOT,
        title: "Label",
        operands: &[Operand::input("name", Accepts::Label, "The name that jumps use.")],
        doc: "Marks its network as the target of jumps.

It does nothing itself and passes power on, so the network can do its work after it. A label is seen within
its own function, or in the main program, only. A name may be used more than once: a jump goes to the
nearest such label after it, or, if there is none, to the nearest before it.",
        example: "VAR_INPUT
    manual : BOOL;
END_VAR
VAR
    strokes : DINT;
END_VAR
VAR_OUTPUT
    ready : BOOL;
END_VAR

+--[ ]( manual )------------------------------------------------<JMP>( skip )--+
+------------------------------------------------[ADD]( strokes, strokes, 1 )--+
+--<LBL>( skip )-------------------------------------------------( )( ready )--+",
        ..BASE
    },
    Instruction {
        op: Op::Jmp,
        mnemonic: "JMP",
        profiles: Profiles::WITHOUT_IOT,
        title: "Jump",
        operands: &[Operand::input("name", Accepts::Label, "The label to go on at.")],
        eno: "EN, if it does not jump",
        doc: "Leaves this network at once and goes on at the network that holds the label.

- What is right of it, and on the lines below it in this network, is not run in this scan. Networks that
  are jumped over keep their outputs and their state; timers catch up when they are next reached.
- The target is the nearest label of that name after the jump; if there is none, the nearest before it, or
  in this network. Labels of other functions are not seen.
- A jump back is a loop within one scan. If it never ends, the watchdog stops the simulation with a fault
  that names the place.

IEC 61131-3: jump.",
        example: "VAR_INPUT
    manual : BOOL;
END_VAR
VAR
    strokes : DINT;
END_VAR
VAR_OUTPUT
    ready : BOOL;
END_VAR

+--[ ]( manual )------------------------------------------------<JMP>( skip )--+
+------------------------------------------------[ADD]( strokes, strokes, 1 )--+
+--<LBL>( skip )-------------------------------------------------( )( ready )--+",
        ..BASE
    },
    Instruction {
        op: Op::Fun,
        mnemonic: "FUN",
        role: Role::Condition,
        profiles: Profiles::WITHOUT_IOT,
        title: "Function",
        operands: &[Operand::input(
            "name",
            Accepts::Function,
            "The name that calls use.",
        )],
        doc: "Begins a function: its network and all that follow, up to the next `<FUN>` or the end of the file.

It does nothing itself and passes power on. The networks before the first `<FUN>` are the main program,
which ends there: a function runs only when `<CALL>` asks for it, and returns at its end or at a `<RET>`. It
works on the tags of its file, and can be called from every file of the workspace.

For a block with operands and a state of its own, define a function block.",
        example: "VAR_INPUT
    dosing : BOOL;
END_VAR
VAR_OUTPUT
    valve, pump : BOOL;
END_VAR

+--------------------------------------------------------------<CALL>( dose )--+

+--<FUN>( dose )--[ ]( dosing )---------------------( )( valve )--( )( pump )--+",
        ..BASE
    },
    Instruction {
        op: Op::Call,
        mnemonic: "CALL",
        profiles: Profiles::WITHOUT_IOT,
        title: "Call a function",
        operands: &[Operand::input(
            "name",
            Accepts::Function,
            "The function that is run.",
        )],
        doc: "Runs a function, then goes on right after this block.

The function is looked up in this file first, then in the workspace; it runs with the tags of the file that
holds it. While EN is low it is not run: its coils keep their state, they do not fall. ENO is EN, whatever
the function does.

Calls may nest 64 deep; past that the simulation stops with a fault that names the place.",
        example: "VAR_INPUT
    auto, part_seen : BOOL;
END_VAR
VAR_OUTPUT
    clamp : BOOL;
END_VAR

+--[ ]( auto )---------------------------------------------<CALL>( clamping )--+

+--<FUN>( clamping )--[ ]( part_seen )---------------------------( )( clamp )--+",
        ..BASE
    },
    Instruction {
        op: Op::Ret,
        mnemonic: "RET",
        profiles: Profiles::WITHOUT_IOT,
        title: "Return",
        eno: "EN, if it does not return",
        doc: "Ends the function at once and goes on after the call.

What is right of it and below it in the function is not run. In the main program it ends this scan; the
next scan begins as usual. (The `END` of many controllers, which ends the scan, is this block.) A function
also returns at its end without it.

In the body of a user-defined block `[$B]` or `($B)` it ends the body.",
        example: "VAR_INPUT
    auto, hold, part_seen : BOOL;
END_VAR
VAR_OUTPUT
    clamp : BOOL;
END_VAR

+--[ ]( auto )---------------------------------------------<CALL>( clamping )--+

+--<FUN>( clamping )--[ ]( hold )---------------------------------------<RET>--+
+--[ ]( part_seen )----------------------------------------------( )( clamp )--+",
        ..BASE
    },
    Instruction {
        op: Op::End,
        mnemonic: "END",
        profiles: Profiles::OWN,
        title: "End of the program",
        eno: "EN, if the program goes on",
        doc: "Stops the program for good.

The rest of this scan is skipped, its outputs are published, and no further scan runs. To end only the
current scan, as the `END` of many controllers does, use `<RET>` in the main program.",
        example: "VAR_INPUT
    finished : BOOL;
END_VAR

+--[ ]( finished )------------------------------------------------------<END>--+",
        ..BASE
    },
    Instruction {
        op: Op::For,
        mnemonic: "FOR",
        profiles: Profiles::OWN,
        title: "Loop",
        operands: &[
            Operand::input("n", Accepts::Integer, "How many times; read once."),
            Operand::output(
                "I",
                Accepts::Result(TypeClass::Integer),
                "The number of the turn, from 1.",
            )
            .named(),
        ],
        doc: "Runs the networks after it n times, up to the one that holds its `<NEXT>`.

- Its own network is finished first. Then come the networks after it, the one with `<NEXT>` included.
- n is read once. With EN low, or n of 0 or less, the networks are skipped.
- `I` receives the number of the turn, from 1, before each turn; a loop that is skipped leaves it alone.
- A jump out of the loop, a jump right of `<FOR>` in its own network, or a `<RET>` ends it.
- Loops nest, eight deep: `<FOR>` and `<NEXT>` pair as brackets do. A jump ends every loop that it leaves. A
  function that is called counts by itself. In the profile `click` loops do not nest.
- All turns happen within one scan and see the same clock. An edge is a difference from the turn before. The
  watchdog stops a loop that is too long.",
        example: "VAR
    a   : ARRAY[1..10] OF INT;
    i   : INT;
    sum : DINT;
END_VAR

+----------------------------------------[MOV]( sum, 0 )--<FOR>( 10, I => i )--+
+-----------------------------------------------------[ADD]( sum, sum, a[i] )--+
+----------------------------------------------------------------------<NEXT>--+",
        ..BASE
    },
    Instruction {
        op: Op::Next,
        mnemonic: "NEXT",
        profiles: Profiles::OWN,
        title: "End of a loop",
        doc: "Ends the networks that the `<FOR>` before it repeats.

Its own power does not matter, and its whole network belongs to the loop. Reached while its own loop does not
run, as after a jump to after the `<FOR>`, it does nothing, also inside another loop.",
        example: "VAR
    x : DINT;
END_VAR

+---------------------------------------------------[MOV]( x, 1 )--<FOR>( 8 )--+
+------------------------------------------------------------[MUL]( x, x, 2 )--+
+----------------------------------------------------------------------<NEXT>--+",
        ..BASE
    },
    Instruction {
        op: Op::Mcr,
        mnemonic: "MCR",
        acts: Acts::Always,
        profiles: Profiles::WITHOUT_IOT,
        differs: &[
            (Profile::Ldmicro, "While the rails are live it gives its EN to them; while they are dead it makes them live, whatever EN is. Its own network has no live rail of its own."),
        ],
        title: "Master control relay",
        doc: "Sets the power of the left rails of the networks after it to EN, until the next `<MCR>` that runs.

- With EN low those networks still run, but without power: coils fall, what was set stays set, an off-delay
  timer runs out.
- A network that holds an `<MCR>` always has a live rail. So a bare `<MCR>` on a rung of its own switches
  the rails on again.
- Rails are live at the start of every scan, of every function and of every block body; on return the
  caller's come back.

It is not an emergency stop: switch off what can hurt people by hardware.",
        example: "VAR_INPUT
    enable, jog : BOOL;
END_VAR
VAR_OUTPUT
    motor : BOOL;
END_VAR

+--[ ]( enable )--------------------------------------------------------<MCR>--+
+--[ ]( jog )----------------------------------------------------( )( motor )--+
+-----------------------------------------------------------------------<MCR>--+",
        ..BASE
    },
];
