//! The elements that only LDmicro's fork has, each next to what it becomes here.

use super::super::field::Slot;
use super::made::{Made, MadeTimer};
use ladder_instructions::Op;

/// An element of the fork.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Row {
    pub(crate) word: &'static str,
    pub(super) form: Form,
}

/// What becomes of an element of the fork.
#[derive(Debug, Clone, Copy)]
pub(super) enum Form {
    /// An instruction whose operands are the fields.
    Values(Op, &'static [Slot]),
    /// The same, and the last field says by how many bits.
    Bits(Op),
    /// An instruction on one bit of a variable: `SET_BIT n 3`.
    OneBit(Op),
    /// A block of its own, whose operands are the fields.
    Made(Made, &'static [Slot]),
    /// `TCY name delay adjust`
    Timer(MadeTimer),
    /// `CTR name max init kind`
    Counter,
    /// `GOTO label` and the like.
    Jump(Jump),
    /// There is no counterpart; why, and how many fields it has.
    Refused(usize, &'static str),
}

/// What leads on to another rung, or is a place where that leads.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Jump {
    Label,
    Goto,
    Gosub,
    Subprog,
    Endsub,
    Return,
}

const fn row(word: &'static str, form: Form) -> Row {
    Row { word, form }
}

const TO_FROM: &[Slot] = &[Slot::Place, Slot::Value];
const MATH: &[Slot] = &[Slot::Place, Slot::Value, Slot::Value];

const HARDWARE: &str = "it is about the hardware of the controller, and there is no such port here";
const REGISTER: &str = "it is about a register of the controller";
const UNKNOWN_BITS: &str = "which bit goes where is not documented";
const SEGMENTS: &str = "which segments each character lights is not documented";
const SERIAL: &str = "there is no port here that shows whether the line is free or a byte has come";
const PERIOD: &str = "how many scans or loops it counts is not documented";

/// All of them.
pub(crate) const ROWS: &[Row] = &[
    row("MOD", Form::Values(Op::Mod, MATH)),
    row("AND", Form::Values(Op::And, MATH)),
    row("OR", Form::Values(Op::Or, MATH)),
    row("XOR", Form::Values(Op::Xor, MATH)),
    row("NOT", Form::Values(Op::Not, TO_FROM)),
    row("NEG", Form::Values(Op::Neg, TO_FROM)),
    row("SHL", Form::Bits(Op::Shl)),
    row("SR0", Form::Bits(Op::Shr)),
    row("ROL", Form::Bits(Op::Rol)),
    row("ROR", Form::Bits(Op::Ror)),
    row("SHR", Form::Made(Made::ShiftRight, MATH)),
    row("BIN2BCD", Form::Made(Made::ToBcd, TO_FROM)),
    row("BCD2BIN", Form::Made(Made::FromBcd, TO_FROM)),
    row("OSL", Form::Made(Made::OneShotLow, &[])),
    row("ODF", Form::Made(Made::OneShotLow, &[])),
    row("OSC", Form::Made(Made::Oscillator, &[])),
    row("SET_BIT", Form::OneBit(Op::SetCoil)),
    row("CLEAR_BIT", Form::OneBit(Op::ResetCoil)),
    row("IF_BIT_SET", Form::OneBit(Op::Contact)),
    row("IF_BIT_CLEAR", Form::OneBit(Op::NegatedContact)),
    row("RTL", Form::Timer(MadeTimer::RetentiveLow)),
    row("TCY", Form::Timer(MadeTimer::Cyclic)),
    row("THI", Form::Timer(MadeTimer::High)),
    row("TLO", Form::Timer(MadeTimer::Low)),
    row("CTR", Form::Counter),
    row("LABEL", Form::Jump(Jump::Label)),
    row("GOTO", Form::Jump(Jump::Goto)),
    row("GOSUB", Form::Jump(Jump::Gosub)),
    row("SUBPROG", Form::Jump(Jump::Subprog)),
    row("ENDSUB", Form::Jump(Jump::Endsub)),
    row("RETURN", Form::Jump(Jump::Return)),
    row(
        "ODR",
        Form::Refused(0, "when its power is low for one scan is not documented"),
    ),
    row("TIME2COUNT", Form::Refused(2, PERIOD)),
    row("TIME2DELAY", Form::Refused(2, PERIOD)),
    row("DELAY", Form::Refused(1, HARDWARE)),
    row("SLEEP", Form::Refused(0, HARDWARE)),
    row("CLRWDT", Form::Refused(0, HARDWARE)),
    row("LOCK", Form::Refused(0, HARDWARE)),
    row("OPPOSITE", Form::Refused(2, UNKNOWN_BITS)),
    row("SWAP", Form::Refused(2, UNKNOWN_BITS)),
    row("BUS", Form::Refused(10, UNKNOWN_BITS)),
    row("7SEGMENTS", Form::Refused(3, SEGMENTS)),
    row("9SEGMENTS", Form::Refused(3, SEGMENTS)),
    row("14SEGMENTS", Form::Refused(3, SEGMENTS)),
    row("16SEGMENTS", Form::Refused(3, SEGMENTS)),
    row("RSFR", Form::Refused(2, REGISTER)),
    row("WSFR", Form::Refused(2, REGISTER)),
    row("SSFR", Form::Refused(2, REGISTER)),
    row("CSFR", Form::Refused(2, REGISTER)),
    row("TSFR", Form::Refused(2, REGISTER)),
    row("TCSFR", Form::Refused(2, REGISTER)),
    row("RANDOM", Form::Refused(1, "there are no random numbers here")),
    row(
        "SEED_RANDOM",
        Form::Refused(2, "there are no random numbers here"),
    ),
    row("NPULSE", Form::Refused(3, HARDWARE)),
    row("NPULSE_OFF", Form::Refused(0, HARDWARE)),
    row("PULSER", Form::Refused(5, HARDWARE)),
    row("STEPPER", Form::Refused(6, HARDWARE)),
    row("QUAD_ENCOD", Form::Refused(8, HARDWARE)),
    row("SPI", Form::Refused(8, HARDWARE)),
    row("SPI_WR", Form::Refused(8, HARDWARE)),
    row("I2C_RD", Form::Refused(8, HARDWARE)),
    row("I2C_WR", Form::Refused(8, HARDWARE)),
    row("UART_SENDn", Form::Refused(1, SERIAL)),
    row("UART_RECVn", Form::Refused(1, SERIAL)),
    row("UART_SEND_READY", Form::Refused(0, SERIAL)),
    row("UART_SEND_BUSY", Form::Refused(0, SERIAL)),
    row("UART_UDRE", Form::Refused(0, SERIAL)),
    row("UART_RECV_AVAIL", Form::Refused(0, SERIAL)),
    row(
        "STRING",
        Form::Refused(
            2,
            "LDmicro writes a number into a text as C does, and there is no such instruction here",
        ),
    ),
    row("FORMATTED_STR", Form::Refused(0, HARDWARE)),
    row("SET_PWM_SOFT", Form::Refused(0, HARDWARE)),
    row("PWM_OFF", Form::Refused(0, HARDWARE)),
];

/// The row of a line.
pub(crate) fn row_of(text: &str) -> Option<&'static Row> {
    let word = text.split(' ').next()?;
    ROWS.iter().find(|row| row.word == word)
}

impl Row {
    /// How many fields it has at least.
    pub(crate) fn least(&self) -> usize {
        match self.form {
            Form::Values(_, slots) | Form::Made(_, slots) => slots.len(),
            Form::Bits(_) => 3,
            Form::OneBit(_) | Form::Timer(_) | Form::Counter => 2,
            Form::Jump(Jump::Return) => 0,
            Form::Jump(_) => 1,
            Form::Refused(least, _) => least,
        }
    }

    /// The jump that it is, if it is one.
    pub(crate) const fn jump(&self) -> Option<Jump> {
        match self.form {
            Form::Jump(jump) => Some(jump),
            _ => None,
        }
    }

    /// Whether it is this instruction on this many operands.
    pub(crate) fn is(&self, op: Op, operands: usize) -> bool {
        match self.form {
            Form::Values(own, slots) => own == op && slots.len() == operands,
            Form::Bits(own) => own == op && operands == 3,
            _ => false,
        }
    }
}
