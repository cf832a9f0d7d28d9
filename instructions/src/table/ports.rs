//! Ports to the world outside (LANGUAGE §5.6).

use crate::instruction::{Acts, Group, Instruction, Role, Shape};
use crate::op::Op;
use crate::operand::{Accepts, Operand, TypeClass};
use crate::power::Power;
use crate::profile::{Profile, Profiles};

/// What the rows of this section share.
const BASE: Instruction = Instruction {
    op: Op::Adc,
    mnemonic: "",
    synonyms: &[],
    aliases: &[],
    shape: Shape::Logical,
    role: Role::Acting,
    acts: Acts::WhenPowered,
    group: Group::Port,
    operands: &[],
    profiles: Profiles::ALL,
    differs: &[],
    power: Power::PassesIfDone,
    coil: None,
    eno: "EN",
    title: "",
    doc: "",
    example: "",
};

pub(super) const ROWS: &[Instruction] = &[
    Instruction {
        op: Op::Adc,
        mnemonic: "ADC",
        profiles: Profiles::WITHOUT_IOT,
        title: "Read analog input",
        operands: &[
            Operand::output(
                "y",
                Accepts::Result(TypeClass::Integer),
                "The value that was read.",
            ),
            Operand::input("channel", Accepts::Integer, "The number of the analog input."),
        ],
        doc: "Reads an analog input, as an integer, into y.

In the simulator the channel is a port with a name, which tests and editors set.",
        example: "VAR
    raw : INT;
END_VAR
VAR_OUTPUT
    high : BOOL;
END_VAR

+-------------------------------------------------------------[ADC]( raw, 0 )--+
+--[GT]( raw, 800 )-----------------------------------------------( )( high )--+",
        ..BASE
    },
    Instruction {
        op: Op::Pwm,
        mnemonic: "PWM",
        profiles: Profiles::WITHOUT_IOT,
        title: "Pulse output",
        operands: &[
            Operand::input(
                "duty",
                Accepts::Integer,
                "How much of each period is high, in percent.",
            ),
            Operand::input("frequency", Accepts::Integer, "Periods per second, in hertz."),
            Operand::input("CH", Accepts::Integer, "The number of the pulse output.").named(),
        ],
        doc: "Sets a pulse output: its duty in percent and its frequency in hertz.

The output goes on with the last setting while EN is low. `CH` chooses among several pulse outputs. In the
simulator the output is a port with a name, which tests and editors read.",
        example: "VAR
    duty : INT := 50;
END_VAR

+------------------------------------------------[PWM]( duty, 1000, CH := 0 )--+",
        ..BASE
    },
    Instruction {
        op: Op::Usnd,
        mnemonic: "USND",
        profiles: Profiles::WITHOUT_IOT,
        differs: &[(
            Profile::Ldmicro,
            "A byte takes two scans. It is sent when EN is high and the line is free; the power after it shows that the line is busy.",
        )],
        title: "Send a byte",
        operands: &[Operand::input(
            "n",
            Accepts::Integer,
            "The byte; of a larger number its lowest eight bits.",
        )],
        eno: "EN",
        doc: "Sends one byte through the serial port.

Of a larger number the lowest eight bits are sent. With EN high it sends in every scan, so put an edge in
front. In the simulator the port has a name; tests and editors read what was sent.",
        example: "VAR_INPUT
    send : BOOL;
END_VAR
VAR
    code : INT := 65;
END_VAR

+--[P]( send )-------------------------------------------------[USND]( code )--+",
        ..BASE
    },
    Instruction {
        op: Op::Urcv,
        mnemonic: "URCV",
        profiles: Profiles::WITHOUT_IOT,
        differs: &[(
            Profile::Ldmicro,
            "The port holds one byte: a newer one takes its place.",
        )],
        title: "Receive a byte",
        operands: &[Operand::output(
            "y",
            Accepts::Result(TypeClass::Integer),
            "The byte that came.",
        )],
        eno: "EN and a byte came",
        doc: "Takes one byte that came in at the serial port into y.

ENO is high in the scan in which a byte was taken; otherwise it is low and y keeps its value. Bytes that
come while EN is low wait. In the simulator the port has a name, and tests and editors feed it.",
        example: "VAR
    received, last : INT;
END_VAR

+---------------------------------[URCV]( received )--[MOV]( last, received )--+",
        ..BASE
    },
    Instruction {
        op: Op::Fmt,
        mnemonic: "FMT",
        profiles: Profiles::WITHOUT_IOT,
        differs: &[(
            Profile::Ldmicro,
            "Sends a byte every second scan, whenever the line is free; the power after it shows that there is more to send. A rise of EN begins again, and so does the start of the program. `\\3` is the number with three digits, `\\-3` with its sign before them (1 to 5 digits), `\\\\` a backslash.",
        )],
        title: "Send formatted text",
        operands: &[
            Operand::input("text", Accepts::String, "The text; each `%d` stands for a value."),
            Operand::input("a", Accepts::Integer, "The value for a `%d`, in order.").repeated_or_none(),
        ],
        doc: "Sends a text through the serial port, with numbers in the places of `%d`.

The values are after the text, one for each `%d`, in order. With EN high it sends in every scan, so put
an edge in front. In the simulator the port has a name; tests and editors read what was sent.",
        example: "VAR_INPUT
    report : BOOL;
END_VAR
VAR
    parts : DINT;
END_VAR

+--[P]( report )------------------------------[FMT]( 'parts: %d$R$N', parts )--+",
        ..BASE
    },
    Instruction {
        op: Op::Persist,
        power: Power::Passes,
        mnemonic: "PERSIST",
        profiles: Profiles::WITHOUT_IOT,
        title: "Make retentive",
        operands: &[Operand::in_out(
            "tag",
            Accepts::Tag,
            "The tag that keeps its value over a warm restart.",
        )],
        doc: "Makes a tag retentive.

A retentive tag keeps its value over a warm restart; any other starts with its initial value. Declaring the
tag in a `RETAIN` section does the same.",
        example: "VAR
    total : DINT;
END_VAR

+----------------------------------------------------------[PERSIST]( total )--+",
        ..BASE
    },
    Instruction {
        op: Op::Scantime,
        mnemonic: "SCANTIME",
        profiles: Profiles::WITHOUT_LDMICRO,
        title: "Scan time",
        operands: &[Operand::output(
            "y",
            Accepts::Result(TypeClass::Number),
            "The length of the last scan in milliseconds.",
        )
        .trailing()],
        doc: "Puts the length of the last scan, in milliseconds, into y.

Without an operand it is written to the serial port, once a second. `SYS.SCAN_TIME` gives the same length as
a TIME.",
        example: "VAR
    milliseconds : INT;
END_VAR

+--------------------------------------------------[SCANTIME]( milliseconds )--+",
        ..BASE
    },
];
