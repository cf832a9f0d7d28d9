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
    /// `TIME2COUNT name delay adjust`
    Count,
    /// `7SEGMENTS dest src common`
    Segments,
    /// What is not read; how many fields it has at least.
    Outside(usize),
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
    row("SWAP", Form::Made(Made::Swap, TO_FROM)),
    row("OPPOSITE", Form::Made(Made::Opposite, TO_FROM)),
    row("TIME2COUNT", Form::Count),
    row("7SEGMENTS", Form::Segments),
    row("ODR", Form::Made(Made::OneDropRising, &[])),
    row("TIME2DELAY", Form::Outside(2)),
    row("DELAY", Form::Outside(1)),
    row("SLEEP", Form::Outside(0)),
    row("CLRWDT", Form::Outside(0)),
    row("LOCK", Form::Outside(0)),
    row("BUS", Form::Outside(10)),
    row("9SEGMENTS", Form::Outside(3)),
    row("14SEGMENTS", Form::Outside(3)),
    row("16SEGMENTS", Form::Outside(3)),
    row("RSFR", Form::Outside(2)),
    row("WSFR", Form::Outside(2)),
    row("SSFR", Form::Outside(2)),
    row("CSFR", Form::Outside(2)),
    row("TSFR", Form::Outside(2)),
    row("TCSFR", Form::Outside(2)),
    row("RANDOM", Form::Outside(1)),
    row("SEED_RANDOM", Form::Outside(2)),
    row("NPULSE", Form::Outside(3)),
    row("NPULSE_OFF", Form::Outside(0)),
    row("PULSER", Form::Outside(5)),
    row("STEPPER", Form::Outside(6)),
    row("QUAD_ENCOD", Form::Outside(4)),
    row("SPI", Form::Outside(8)),
    row("SPI_WR", Form::Outside(8)),
    row("I2C_RD", Form::Outside(8)),
    row("I2C_WR", Form::Outside(8)),
    row("UART_SENDn", Form::Outside(1)),
    row("UART_RECVn", Form::Outside(1)),
    row("UART_SEND_READY", Form::Outside(0)),
    row("UART_SEND_BUSY", Form::Outside(0)),
    row("UART_UDRE", Form::Outside(0)),
    row("UART_RECV_AVAIL", Form::Outside(0)),
    row("STRING", Form::Outside(2)),
    row("FORMATTED_STR", Form::Outside(0)),
    row("SET_PWM_SOFT", Form::Outside(0)),
    row("PWM_OFF", Form::Outside(0)),
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
            Form::Segments => 3,
            Form::OneBit(_) | Form::Timer(_) | Form::Counter | Form::Count => 2,
            Form::Jump(Jump::Return) => 0,
            Form::Jump(_) => 1,
            Form::Outside(least) => least,
        }
    }

    /// The jump that it is, if it is one.
    pub(crate) const fn jump(&self) -> Option<Jump> {
        match self.form {
            Form::Jump(jump) => Some(jump),
            _ => None,
        }
    }

    /// Whether it is not read.
    pub(crate) const fn is_outside(&self) -> bool {
        matches!(self.form, Form::Outside(_))
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
