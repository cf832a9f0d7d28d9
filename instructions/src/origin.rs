//! Where each instruction comes from.

use crate::op::Op;
use std::fmt;

/// A source of an instruction: what it is called there, and where that is documented.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Origin {
    /// IEC 61131-3, third edition: its name there, and the clause.
    Iec(&'static str, &'static str),
    /// The CPLC-LD standard, from which the form of the text comes.
    Cplc,
    /// A family of controllers, or a tool for them.
    Controllers(&'static str),
    /// This language.
    Own(&'static str),
}

impl fmt::Display for Origin {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Origin::Iec(name, clause) => write!(f, "IEC 61131-3, {clause}: {name}"),
            Origin::Cplc => f.write_str("the CPLC-LD standard"),
            Origin::Controllers(who) => f.write_str(who),
            Origin::Own(why) => write!(f, "this language: {why}"),
        }
    }
}

const FUNCTIONS: &str = "6.6.2.5";
const BLOCKS: &str = "6.6.3.5";
const CONTACTS: &str = "8.2.4";
const COILS: &str = "8.2.5";
const CONTROL: &str = "8.1.5";

const LOGIX: Origin = Origin::Controllers("controllers of Allen-Bradley");
const CLICK: Origin = Origin::Controllers("Click controllers");
const LDMICRO: Origin = Origin::Controllers("LDmicro");

/// Where an instruction comes from: its sources, the nearest first. A new one does not compile without its line.
pub const fn origin(op: Op) -> &'static [Origin] {
    use Origin::{Cplc, Iec, Own};
    match op {
        Op::Contact => &[Iec("normally open contact", CONTACTS), Cplc],
        Op::NegatedContact => &[Iec("normally closed contact", CONTACTS), Cplc],
        Op::RisingContact => &[Iec("positive transition-sensing contact", CONTACTS), Cplc],
        Op::FallingContact => &[Iec("negative transition-sensing contact", CONTACTS), Cplc],
        Op::Inverter => &[Cplc],
        Op::OneShotRising => &[Iec("R_TRIG", BLOCKS), LDMICRO],
        Op::OneShotFalling => &[Iec("F_TRIG", BLOCKS), LDMICRO],
        Op::Eq => &[Iec("EQ", FUNCTIONS)],
        Op::Ne => &[Iec("NE", FUNCTIONS)],
        Op::Gt => &[Iec("GT", FUNCTIONS)],
        Op::Ge => &[Iec("GE", FUNCTIONS)],
        Op::Lt => &[Iec("LT", FUNCTIONS)],
        Op::Le => &[Iec("LE", FUNCTIONS)],
        Op::Mov => &[Iec("MOVE", FUNCTIONS), Cplc],
        Op::Typ => &[Cplc, Iec("the conversions such as REAL_TO_INT", FUNCTIONS)],
        Op::Wrap => &[
            Iec(
                "conversions of integers, as most controllers make them",
                FUNCTIONS,
            ),
            LOGIX,
        ],
        Op::Add => &[Iec("ADD", FUNCTIONS), Cplc],
        Op::Mul => &[Iec("MUL", FUNCTIONS), Cplc],
        Op::Sub => &[Iec("SUB", FUNCTIONS), Cplc],
        Op::Div => &[Iec("DIV", FUNCTIONS), Cplc],
        Op::Mod => &[Iec("MOD", FUNCTIONS), Cplc],
        Op::Exp => &[Cplc, Iec("EXPT", FUNCTIONS)],
        Op::Not => &[Iec("NOT", FUNCTIONS), Cplc],
        Op::And => &[Iec("AND", FUNCTIONS), Cplc],
        Op::Or => &[Iec("OR", FUNCTIONS), Cplc],
        Op::Xor => &[Iec("XOR", FUNCTIONS), Cplc],
        Op::Shl => &[Iec("SHL", FUNCTIONS), Cplc],
        Op::Shr => &[Iec("SHR", FUNCTIONS), Cplc],
        Op::Rol => &[Iec("ROL", FUNCTIONS), Cplc],
        Op::Ror => &[Iec("ROR", FUNCTIONS), Cplc],
        Op::Abs => &[Iec("ABS", FUNCTIONS)],
        Op::Neg | Op::Rad | Op::Deg => &[LOGIX],
        Op::Trunc => &[Iec("TRUNC", FUNCTIONS)],
        Op::Sqrt => &[Iec("SQRT", FUNCTIONS)],
        Op::Ln => &[Iec("LN", FUNCTIONS)],
        Op::Log => &[Iec("LOG", FUNCTIONS)],
        Op::Expe => &[Iec("EXP", FUNCTIONS)],
        Op::Sin => &[Iec("SIN", FUNCTIONS)],
        Op::Cos => &[Iec("COS", FUNCTIONS)],
        Op::Tan => &[Iec("TAN", FUNCTIONS)],
        Op::Asin => &[Iec("ASIN", FUNCTIONS)],
        Op::Acos => &[Iec("ACOS", FUNCTIONS)],
        Op::Atan => &[Iec("ATAN", FUNCTIONS)],
        Op::Min => &[Iec("MIN", FUNCTIONS)],
        Op::Max => &[Iec("MAX", FUNCTIONS)],
        Op::Limit => &[Iec("LIMIT", FUNCTIONS)],
        Op::Sel => &[Iec("SEL", FUNCTIONS)],
        Op::Mux => &[Iec("MUX", FUNCTIONS)],
        Op::Calc => &[
            CLICK,
            Own("its expressions are those of IEC 61131-3, Structured Text"),
        ],
        Op::Len => &[Iec("LEN", FUNCTIONS)],
        Op::Left => &[Iec("LEFT", FUNCTIONS)],
        Op::Right => &[Iec("RIGHT", FUNCTIONS)],
        Op::Mid => &[Iec("MID", FUNCTIONS)],
        Op::Concat => &[Iec("CONCAT", FUNCTIONS)],
        Op::Insert => &[Iec("INSERT", FUNCTIONS)],
        Op::Delete => &[Iec("DELETE", FUNCTIONS)],
        Op::Replace => &[Iec("REPLACE", FUNCTIONS)],
        Op::Find => &[Iec("FIND", FUNCTIONS)],
        Op::Bmov | Op::Fill | Op::Pack | Op::Unpack | Op::Search => &[CLICK],
        Op::Shift => &[CLICK, LDMICRO],
        Op::Lut | Op::Pwl => &[LDMICRO],
        Op::Ton => &[Iec("TON", BLOCKS)],
        Op::Tof => &[Iec("TOF", BLOCKS)],
        Op::Tp => &[Iec("TP", BLOCKS)],
        Op::Rto => &[LOGIX, LDMICRO],
        Op::Rtof => &[Own("the counterpart of RTO")],
        Op::Ctu => &[Iec("CTU", BLOCKS)],
        Op::Ctd => &[Iec("CTD", BLOCKS)],
        Op::Ctud => &[Iec("CTUD", BLOCKS)],
        Op::Ctc => &[LDMICRO],
        Op::Sr => &[Iec("SR", BLOCKS)],
        Op::Rs => &[Iec("RS", BLOCKS)],
        Op::Coil => &[Iec("coil", COILS), Cplc],
        Op::NegatedCoil => &[Iec("negated coil", COILS)],
        Op::SetCoil => &[Iec("set (latch) coil", COILS), Cplc],
        Op::ResetCoil => &[Iec("reset (unlatch) coil", COILS), Cplc],
        Op::RisingCoil => &[Iec("positive transition-sensing coil", COILS)],
        Op::FallingCoil => &[Iec("negative transition-sensing coil", COILS)],
        Op::RetentiveCoil | Op::RetentiveSet | Op::RetentiveReset => {
            &[Cplc, Origin::Controllers("the first edition of IEC 61131-3")]
        }
        Op::Res => &[LOGIX],
        Op::Lbl => &[Cplc, Iec("network label", CONTROL)],
        Op::Jmp => &[Cplc, Iec("jump", CONTROL)],
        Op::Fun | Op::Call | Op::End => &[Cplc],
        Op::Ret => &[Cplc, Iec("return", CONTROL)],
        Op::For | Op::Next => &[CLICK],
        Op::Mcr => &[LDMICRO, LOGIX],
        Op::Adc | Op::Pwm | Op::Usnd | Op::Urcv | Op::Fmt | Op::Persist => &[LDMICRO],
        Op::Scantime => &[Origin::Controllers("iot-ladder-editor")],
    }
}
