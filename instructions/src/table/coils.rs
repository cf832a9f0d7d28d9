//! Coils (LANGUAGE §5.4).

use crate::{Accepts, Acts, Group, Instruction, Op, Operand, Role, Shape};

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
    eno: "EN",
    title: "",
    doc: "",
    example: "",
};

pub(super) const ROWS: &[Instruction] = &[
    Instruction {
        op: Op::Coil,
        mnemonic: " ",
        title: "Coil",
        operands: &[Operand::output(
            "tag",
            Accepts::BoolOrRange,
            "The bit, or the bits, that follow EN.",
        )],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::NegatedCoil,
        mnemonic: "/",
        title: "Negated coil",
        operands: &[Operand::output(
            "tag",
            Accepts::Bool,
            "The bit that is the opposite of EN.",
        )],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::SetCoil,
        mnemonic: "S",
        title: "Set coil",
        operands: &[Operand::output(
            "tag",
            Accepts::BoolOrRange,
            "The bit, or the bits, that are set.",
        )],
        eno: "the tag",
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::ResetCoil,
        mnemonic: "R",
        title: "Reset coil",
        operands: &[Operand::output(
            "tag",
            Accepts::BoolRangeOrState,
            "The bits that are cleared, or a timer or counter.",
        )],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::RisingCoil,
        mnemonic: "P",
        title: "Rising-edge coil",
        operands: &[Operand::output(
            "tag",
            Accepts::Bool,
            "The bit that is high for one scan when EN rises.",
        )],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::FallingCoil,
        mnemonic: "N",
        title: "Falling-edge coil",
        operands: &[Operand::output(
            "tag",
            Accepts::Bool,
            "The bit that is high for one scan when EN falls.",
        )],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::RetentiveCoil,
        mnemonic: "M",
        title: "Retentive coil",
        operands: &[Operand::output(
            "tag",
            Accepts::BoolOrRange,
            "The bit, or the bits, that follow EN and are retentive.",
        )],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::RetentiveSet,
        mnemonic: "SM",
        title: "Set retentive coil",
        operands: &[Operand::output(
            "tag",
            Accepts::BoolOrRange,
            "The bit, or the bits, that are set and are retentive.",
        )],
        eno: "the tag",
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::RetentiveReset,
        mnemonic: "RM",
        title: "Reset retentive coil",
        operands: &[Operand::output(
            "tag",
            Accepts::BoolRangeOrState,
            "The bits that are cleared and are retentive, or a timer or counter.",
        )],
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Res,
        mnemonic: "RES",
        title: "Reset timer or counter",
        operands: &[Operand::in_out(
            "tag",
            Accepts::TimerOrCounter,
            "The timer or counter that is cleared.",
        )],
        doc: "",
        example: "",
        ..BASE
    },
];
