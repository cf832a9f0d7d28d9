//! Contacts, edges and the inverter (LANGUAGE §5.1).

use crate::{Accepts, Acts, Group, Instruction, Op, Operand, Role, Shape};

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
    eno: "EN and tag",
    title: "",
    doc: "",
    example: "",
};

pub(super) const ROWS: &[Instruction] = &[
    Instruction {
        op: Op::Contact,
        mnemonic: " ",
        title: "Open contact",
        operands: &[Operand::input(
            "tag",
            Accepts::BoolOrRange,
            "The bit that is asked; of a range, every bit.",
        )],
        eno: "EN and tag",
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::NegatedContact,
        mnemonic: "/",
        title: "Closed contact",
        operands: &[Operand::input(
            "tag",
            Accepts::BoolOrRange,
            "The bit that is asked; of a range, no bit may be high.",
        )],
        eno: "EN and not tag",
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::RisingContact,
        mnemonic: "P",
        acts: Acts::Always,
        title: "Rising-edge contact",
        operands: &[Operand::input(
            "tag",
            Accepts::Bool,
            "The bit whose rise is watched.",
        )],
        eno: "EN and tag rose",
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::FallingContact,
        mnemonic: "N",
        acts: Acts::Always,
        title: "Falling-edge contact",
        operands: &[Operand::input(
            "tag",
            Accepts::Bool,
            "The bit whose fall is watched.",
        )],
        eno: "EN and tag fell",
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::Inverter,
        mnemonic: "NOT",
        acts: Acts::Always,
        title: "Inverter",
        eno: "not EN",
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::OneShotRising,
        mnemonic: "OSR",
        aliases: &["R_TRIG"],
        acts: Acts::Always,
        title: "One shot rising",
        eno: "EN rose",
        doc: "",
        example: "",
        ..BASE
    },
    Instruction {
        op: Op::OneShotFalling,
        mnemonic: "OSF",
        aliases: &["F_TRIG"],
        acts: Acts::Always,
        title: "One shot falling",
        eno: "EN fell",
        doc: "",
        example: "",
        ..BASE
    },
];
