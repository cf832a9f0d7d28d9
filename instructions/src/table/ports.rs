//! Ports to the world outside (LANGUAGE §5.6).

use crate::{Accepts, Acts, Group, Instruction, Op, Operand, Role, Shape, TypeClass};

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
    eno: "EN",
    title: "",
    doc: "",
    example: "",
};

pub(super) const ROWS: &[Instruction] = &[
    Instruction {
        op: Op::Adc,
        mnemonic: "ADC",
        title: "Read analog input",
        operands: &[
            Operand::output(
                "y",
                Accepts::Result(TypeClass::Integer),
                "The value that was read.",
            ),
            Operand::input("channel", Accepts::Integer, "The number of the analog input."),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Pwm,
        mnemonic: "PWM",
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
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Usnd,
        mnemonic: "USND",
        title: "Send a byte",
        operands: &[Operand::input(
            "n",
            Accepts::Integer,
            "The byte; of a larger number its lowest eight bits.",
        )],
        eno: "EN",
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Urcv,
        mnemonic: "URCV",
        title: "Receive a byte",
        operands: &[Operand::output(
            "y",
            Accepts::Result(TypeClass::Integer),
            "The byte that came.",
        )],
        eno: "EN and a byte came",
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Fmt,
        mnemonic: "FMT",
        title: "Send formatted text",
        operands: &[
            Operand::input("text", Accepts::String, "The text; each `%d` stands for a value."),
            Operand::input("a", Accepts::Integer, "The value for a `%d`, in order.").repeated_or_none(),
        ],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Persist,
        mnemonic: "PERSIST",
        title: "Make retentive",
        operands: &[Operand::in_out(
            "tag",
            Accepts::Tag,
            "The tag that keeps its value over a warm restart.",
        )],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Scantime,
        mnemonic: "SCANTIME",
        title: "Scan time",
        operands: &[Operand::output(
            "y",
            Accepts::Result(TypeClass::Number),
            "The length of the last scan in milliseconds.",
        )
        .trailing()],
        doc: "",
        example: "",
        ..BASE
    },
];
