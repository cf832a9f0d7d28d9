//! Timers (LANGUAGE §5.3).

use crate::instruction::{Acts, Group, Instruction, Role, Shape};
use crate::op::Op;
use crate::operand::{Accepts, Operand, StateType};
use crate::power::Power;
use crate::profile::{Profile, Profiles};

/// What the rows of this section share.
const BASE: Instruction = Instruction {
    op: Op::Ton,
    mnemonic: "",
    synonyms: &[],
    aliases: &[],
    shape: Shape::Logical,
    role: Role::Acting,
    acts: Acts::Always,
    group: Group::State,
    operands: &[],
    profiles: Profiles::ALL,
    differs: &[(
        Profile::Logix,
        "The power after it is EN. Programs of Logix have the block `$TON` in its place, whose state is a structure.",
    )],
    power: Power::Output,
    coil: None,
    eno: "Q",
    title: "",
    doc: "",
    example: "",
};

const PT: Operand = Operand::input(
    "PT",
    Accepts::Duration,
    "The preset time; a plain integer is milliseconds.",
);
const RESET: Operand = Operand::input("R", Accepts::Bool, "The reset, while it is high.")
    .named()
    .known_to(Profiles::OWN);
const BASE_TIME: Operand = Operand::input(
    "B",
    Accepts::Time,
    "The time base that PT and ET count, in profiles `iot` and `click` only.",
)
.named()
.known_to(Profiles::only(Profile::Iot).and(Profile::Click));

pub(super) const ROWS: &[Instruction] = &[
    Instruction {
        op: Op::Ton,
        mnemonic: "TON",
        differs: &[
            (
                Profile::Ldmicro,
                "ET counts scans and is an integer: with PT of n scan intervals Q is high from the n-th scan in a row that has power. PT is 2 scan intervals at least; a part of one is cut off. Other instructions may write ET, and several blocks use one tag.",
            ),
            (
                Profile::Iot,
                "ET counts the time base `B` (100 ms unless given) and is a DINT, at most one step in a scan; a plain PT counts it too. Q is high from the step that reaches PT.",
            ),
            (
                Profile::Click,
                "ET counts the unit `B` (1 ms unless given) and is an INT; a plain PT counts it too. The scan in which EN rises counts already. Q is high while EN is and ET is PT or more: ET runs on to 32767, and a longer PT takes Q back. Other instructions may write ET.",
            ),
        ],
        title: "On-delay timer",
        operands: &[
            Operand::in_out(
                "t",
                Accepts::State(StateType::Ton),
                "The timer's tag, of type TON.",
            ),
            PT,
            RESET,
            BASE_TIME,
        ],
        doc: "Q goes high once EN has been high for the time PT.

```text
PT = 3 columns
EN   _-------___--___
Q    ____----________
ET   0012333300001000
```

- The scan in which EN rises starts the time at 0; Q goes high in the first scan that is PT or more later.
  When EN falls, Q and ET fall at once.
- While R is high ET is 0 and Q low. If R ends under a high EN, the time starts again in that scan.
- PT is read at every evaluation, so it may be a tag. Lengthening it does not take back a Q that is already
  high. With PT of 0 or less Q follows EN.
- ET is the time run so far, at most PT. ENO is Q; other rungs read `t.Q` and `t.ET`.
- Where the block is jumped over, the time runs on and is brought up to date when the block is next reached.

Each timer tag belongs to one block. IEC 61131-3: TON.",
        example: "VAR_INPUT
    run : BOOL;
END_VAR
VAR
    warmup : TON;
END_VAR
VAR_OUTPUT
    ready : BOOL;
END_VAR

+--[ ]( run )-----------------------------[TON]( warmup, T#5s )--( )( ready )--+",
        ..BASE
    },
    Instruction {
        op: Op::Tof,
        mnemonic: "TOF",
        differs: &[
            (
                Profile::Ldmicro,
                "ET counts scans and is an integer: with PT of n scan intervals Q is low from the n-th scan in a row without power. It begins as if its time were over. PT is 2 scan intervals at least; a part of one is cut off. Other instructions may write ET, and several blocks use one tag.",
            ),
            (
                Profile::Iot,
                "No off-delay: the power after it is EN until the time is over, and then low. It counts as TON does; Q is that the time is over.",
            ),
            (
                Profile::Click,
                "ET counts the unit `B` (1 ms unless given) from the scan on in which EN falls, and runs on to 32767. Q is high with EN, and then while ET is below PT: a longer PT brings it back. It starts low.",
            ),
            (
                Profile::Logix,
                "The power after it is EN. Programs of Logix have the block `$TOF` in its place, whose state is a structure.",
            ),
        ],
        title: "Off-delay timer",
        operands: &[
            Operand::in_out(
                "t",
                Accepts::State(StateType::Tof),
                "The timer's tag, of type TOF.",
            ),
            PT,
            RESET,
            BASE_TIME,
        ],
        doc: "Q goes high with EN, and low once EN has been low for the time PT.

```text
PT = 3 columns
EN   _---______--__---
Q    _------___-------
ET   00000123330001000
```

- The scan in which EN falls starts the time at 0; Q goes low in the first scan that is PT or more later. If
  EN rises before, the time is cleared and Q never went low.
- Q starts low: nothing runs before EN was high once.
- While R is high ET is 0 and Q low. If R ends under a high EN, Q is high again.
- PT is read at every evaluation, so it may be a tag. With PT of 0 or less Q follows EN.
- ET is the time run so far; it stays at PT once the time is over. ENO is Q; other rungs read `t.Q` and
  `t.ET`.
- Where the block is jumped over, the time runs on and is brought up to date when the block is next reached.

Each timer tag belongs to one block. IEC 61131-3: TOF.",
        example: "VAR_INPUT
    motion : BOOL;
END_VAR
VAR
    stay_on : TOF;
END_VAR
VAR_OUTPUT
    light : BOOL;
END_VAR

+--[ ]( motion )-------------------------[TOF]( stay_on, T#2m )--( )( light )--+",
        ..BASE
    },
    Instruction {
        op: Op::Tp,
        mnemonic: "TP",
        profiles: Profiles::only(Profile::Iec),
        title: "Pulse timer",
        operands: &[
            Operand::in_out("t", Accepts::State(StateType::Tp), "The timer's tag, of type TP."),
            PT,
            RESET,
            BASE_TIME,
        ],
        doc: "Q goes high for the time PT when EN rises, however long EN stays high.

```text
PT = 3 columns
EN   _------__-_-____
Q    _---_____---____
ET   0012333000120000
```

- A rise during the pulse is ignored: the pulse is neither lengthened nor started again.
- EN that is high at the first evaluation counts as a rise.
- While R is high ET is 0 and Q low. If R ends under a high EN, the next pulse waits for a new rise.
- PT is read at every evaluation, so it may be a tag. With PT of 0 or less there is no pulse.
- ET is the time run so far; after the pulse it stays at PT until EN is low. ENO is Q; other rungs read
  `t.Q` and `t.ET`.
- Where the block is jumped over, the time runs on and is brought up to date when the block is next reached.

Each timer tag belongs to one block. IEC 61131-3: TP.",
        example: "VAR_INPUT
    part_seen : BOOL;
END_VAR
VAR
    blow_time : TP;
END_VAR
VAR_OUTPUT
    air_valve : BOOL;
END_VAR

+--[ ]( part_seen )--------------[TP]( blow_time, T#300ms )--( )( air_valve )--+",
        ..BASE
    },
    Instruction {
        op: Op::Rto,
        mnemonic: "RTO",
        profiles: Profiles::WITHOUT_IOT,
        differs: &[
            (
                Profile::Ldmicro,
                "ET counts scans with power and is an integer, to one less than PT has scan intervals; Q is high from the scan after that on, until `(RES)`. PT is 2 scan intervals at least. Other instructions may write ET, and several blocks use one tag.",
            ),
            (
                Profile::Click,
                "ET counts the unit `B` (1 ms unless given), each scan with power as a whole, and runs on to 32767; what is less than a unit is kept over a pause. Q is high while ET is PT or more and R is low.",
            ),
            (
                Profile::Logix,
                "The power after it is EN. Programs of Logix have the block `$RTO` in its place, whose state is a structure.",
            ),
        ],
        title: "Retentive on-delay timer",
        operands: &[
            Operand::in_out(
                "t",
                Accepts::State(StateType::Rto),
                "The timer's tag, of type RTO.",
            ),
            PT,
            RESET,
            BASE_TIME,
        ],
        doc: "Adds up the time during which EN is high; Q goes high once it has reached PT.

```text
PT = 3 columns
EN   _---__---___
R    __________-_
Q    _______---__
ET   001222233300
```

- ET grows by the time between two evaluations that both have EN high, and keeps its value while EN is low.
  Q is high as long as ET has reached PT, also while EN is low.
- Only R, `(R)` or `(RES)` clears it. While R is high ET is 0 and Q low; if R ends under a high EN, the time
  starts again in that scan.
- PT is read at every evaluation, so it may be a tag. With PT of 0 or less Q follows EN.
- ENO is Q; other rungs read `t.Q` and `t.ET`. Declare the tag in a `RETAIN` section to keep the time over a
  restart.

Each timer tag belongs to one block. IEC 61131-3 has no such timer; controllers call it RTO or TONR.",
        example: "VAR_INPUT
    running, serviced : BOOL;
END_VAR
VAR RETAIN
    hours : RTO;
END_VAR
VAR_OUTPUT
    service_due : BOOL;
END_VAR

+--[ ]( running )---[RTO]( hours, T#500h, R := serviced )--( )( service_due )--+",
        ..BASE
    },
    Instruction {
        op: Op::Rtof,
        mnemonic: "RTOF",
        profiles: Profiles::OWN,
        differs: &[(
            Profile::Click,
            "The controller itself has none. ET counts the unit `B` (1 ms unless given), each scan without power as a whole, and runs on to 32767; Q is high with EN, and then while ET is below PT.",
        )],
        title: "Retentive off-delay timer",
        operands: &[
            Operand::in_out(
                "t",
                Accepts::State(StateType::Rtof),
                "The timer's tag, of type RTOF.",
            ),
            PT,
            RESET,
            BASE_TIME,
        ],
        doc: "Q goes high with EN, and low once EN has been low for the time PT in all, pauses not counted.

```text
PT = 3 columns
EN   _--__--_____--__
Q    _--------___--__
ET   0000111123333333
```

- While EN is low after a fall, ET grows by the time between two evaluations; while EN is high it is
  still. A new rise of EN does not clear it.
- Q is high while EN is high. Once ET has reached PT, Q falls together with EN, until R clears the time.
- Q starts low: nothing runs before EN was high once.
- Only R, `(R)` or `(RES)` clears ET. While R is high ET is 0 and Q low; if R ends under a high EN, Q is
  high again.
- PT is read at every evaluation, so it may be a tag. With PT of 0 or less Q follows EN.
- ENO is Q; other rungs read `t.Q` and `t.ET`.

Each timer tag belongs to one block. IEC 61131-3 has no such timer.",
        example: "VAR_INPUT
    pump_on, refilled : BOOL;
END_VAR
VAR
    idle_time : RTOF;
END_VAR
VAR_OUTPUT
    keep_warm : BOOL;
END_VAR

+--[ ]( pump_on )---------------------[RTOF]( idle_time, T#10m, R := refilled )--( )( keep_warm )--+",
        ..BASE
    },
];
