//! The instructions of SIMATIC controllers, each under its names in source documents and in SimaticML, next to what says
//! the same here.

use ladder_analysis::program::{Clock, SystemTag};
use ladder_format::program::Operator;
use ladder_instructions::Op;
use ladder_notation_st::read::Edge;

/// What an instruction becomes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Form {
    /// A contact.
    Contact(Op),
    /// A contact with a bit that remembers.
    EdgeContact(Op),
    /// A comparison as a contact.
    Compare(Op),
    /// A comparison as a box, with its sign.
    CompareBox(Operator),
    /// Whether a value lies between two others.
    InRange,
    OutRange,
    /// Whether a real is a number: it is what it is then.
    Valid(Op),
    /// The edge of the power, with a bit that remembers.
    Edge(Op),
    Not,
    Coil(Op),
    /// A coil with a bit that remembers.
    EdgeCoil(Op),
    /// A coil on several bits.
    Bits(Op),
    /// A bit that is set and reset: whether resetting is stronger.
    Bistable {
        reset_wins: bool,
    },
    /// An edge detector with an instance, which holds its output here.
    Trigger(Edge),
    /// A block with a state, and the pins that are operands, each with its name here (by place without).
    State(Op, &'static [(&'static str, &'static str)]),
    TimerCoil(Op),
    ResetTimer,
    Move,
    /// A result from values, and the pins.
    Value(Op, Pins),
    Square,
    /// A value that is counted up or down.
    Step(Op),
    Convert,
    Calculate,
    Jump {
        negated: bool,
    },
    Return,
}

impl Form {
    /// The instruction here that is written as it.
    const fn op(self) -> Option<Op> {
        match self {
            Form::Contact(op)
            | Form::EdgeContact(op)
            | Form::Compare(op)
            | Form::Edge(op)
            | Form::Coil(op)
            | Form::EdgeCoil(op)
            | Form::State(op, _)
            | Form::Value(op, _) => Some(op),
            Form::Not => Some(Op::Inverter),
            Form::ResetTimer => Some(Op::Res),
            Form::Move => Some(Op::Mov),
            Form::Convert => Some(Op::Typ),
            Form::Calculate => Some(Op::Calc),
            Form::Jump { negated: false } => Some(Op::Jmp),
            Form::Return => Some(Op::Ret),
            _ => None,
        }
    }

    /// The pin of the operand that an instruction has by place in a document, and nothing beside it.
    pub(crate) const fn only_pin(self) -> Option<&'static str> {
        match self {
            Form::Contact(_) | Form::Coil(_) => Some("operand"),
            Form::Edge(_) => Some("bit"),
            Form::ResetTimer => Some("timer"),
            Form::Jump { .. } => Some("label"),
            _ => None,
        }
    }

    /// Whether it is a coil: what it writes is wired as what is read.
    pub(crate) const fn is_coil(self) -> bool {
        matches!(
            self,
            Form::Coil(_) | Form::EdgeCoil(_) | Form::Bits(_) | Form::TimerCoil(_) | Form::ResetTimer
        )
    }
}

/// The pins that are operands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Pins {
    /// These.
    Named(&'static [&'static str]),
    /// `in1`, `in2` and so on, as many as there are.
    Numbered,
    /// A selector, and then `in0`, `in1` and so on.
    Selected(&'static str),
}

/// An instruction.
pub(crate) struct Row {
    /// In source documents; the first is the one that is written.
    pub(crate) sd: &'static [&'static str],
    /// In SimaticML.
    pub(crate) xml: &'static [&'static str],
    pub(crate) form: Form,
    /// What names the type that it works in, where a document must say it.
    pub(crate) template: Option<&'static str>,
}

const fn row(
    sd: &'static [&'static str],
    xml: &'static [&'static str],
    form: Form,
    template: Option<&'static str>,
) -> Row {
    Row {
        sd,
        xml,
        form,
        template,
    }
}

const SRC: Option<&str> = Some("SrcType");
const VALUE: Option<&str> = Some("value_type");
const TIME: Option<&str> = Some("time_type");
const IN: Pins = Pins::Named(&["in"]);
const TWO: Pins = Pins::Named(&["in1", "in2"]);
const SHIFTED: Pins = Pins::Named(&["in", "n"]);
const PT: &[(&str, &str)] = &[("pt", "")];

/// All of them.
#[rustfmt::skip]
pub(crate) const ROWS: &[Row] = &[
    row(&["Contact"], &["Contact"], Form::Contact(Op::Contact), None),
    row(&["I_Contact"], &[], Form::Contact(Op::NegatedContact), None),
    row(&["P_Contact"], &["PContact"], Form::EdgeContact(Op::RisingContact), None),
    row(&["N_Contact"], &["NContact"], Form::EdgeContact(Op::FallingContact), None),
    row(&["P_Trig"], &["PBox"], Form::Edge(Op::OneShotRising), None),
    row(&["N_Trig"], &["NBox"], Form::Edge(Op::OneShotFalling), None),
    row(&["Not"], &["Not"], Form::Not, None),
    row(&["EQ_Contact"], &["Eq"], Form::Compare(Op::Eq), SRC),
    row(&["NE_Contact"], &["Ne"], Form::Compare(Op::Ne), SRC),
    row(&["GT_Contact"], &["Gt"], Form::Compare(Op::Gt), SRC),
    row(&["GE_Contact"], &["Ge"], Form::Compare(Op::Ge), SRC),
    row(&["LT_Contact"], &["Lt"], Form::Compare(Op::Lt), SRC),
    row(&["LE_Contact"], &["Le"], Form::Compare(Op::Le), SRC),
    row(&["EQ"], &[], Form::CompareBox(Operator::Equal), SRC),
    row(&["NE"], &[], Form::CompareBox(Operator::NotEqual), SRC),
    row(&["GT"], &[], Form::CompareBox(Operator::Greater), SRC),
    row(&["GE"], &[], Form::CompareBox(Operator::GreaterEqual), SRC),
    row(&["LT"], &[], Form::CompareBox(Operator::Less), SRC),
    row(&["LE"], &[], Form::CompareBox(Operator::LessEqual), SRC),
    row(&["InRange"], &["InRange"], Form::InRange, SRC),
    row(&["OutRange"], &["OutRange"], Form::OutRange, SRC),
    row(&["IsValidContact", "OK"], &["OK"], Form::Valid(Op::Eq), None),
    row(&["IsNotValidContact", "NOK"], &["NotOK", "NOK"], Form::Valid(Op::Ne), None),
    row(&["Coil"], &["Coil"], Form::Coil(Op::Coil), None),
    row(&["I_Coil"], &[], Form::Coil(Op::NegatedCoil), None),
    row(&["S_Coil"], &["SCoil"], Form::Coil(Op::SetCoil), None),
    row(&["R_Coil"], &["RCoil"], Form::Coil(Op::ResetCoil), None),
    row(&["P_Coil"], &["PCoil"], Form::EdgeCoil(Op::RisingCoil), None),
    row(&["N_Coil"], &["NCoil"], Form::EdgeCoil(Op::FallingCoil), None),
    row(&["S_BitfieldCoil"], &["SBitfield", "SET_BF"], Form::Bits(Op::SetCoil), None),
    row(&["R_BitfieldCoil"], &["RBitfield", "RESET_BF"], Form::Bits(Op::ResetCoil), None),
    row(&["S_SR", "SR"], &["Sr"], Form::Bistable { reset_wins: true }, None),
    row(&["S_RS", "RS"], &["Rs"], Form::Bistable { reset_wins: false }, None),
    row(&["TON"], &["TON"], Form::State(Op::Ton, PT), TIME),
    row(&["TOF"], &["TOF"], Form::State(Op::Tof, PT), TIME),
    row(&["TP"], &["TP"], Form::State(Op::Tp, PT), TIME),
    row(&["TONR"], &["TONR"], Form::State(Op::Rto, &[("pt", ""), ("r", "R")]), TIME),
    row(&["CTU"], &["CTU"], Form::State(Op::Ctu, &[("pv", ""), ("r", "R")]), VALUE),
    row(&["CTD"], &["CTD"], Form::State(Op::Ctd, &[("pv", ""), ("ld", "LD")]), VALUE),
    row(&["CTUD"], &["CTUD"], Form::State(Op::Ctud, &[("pv", ""), ("cd", "CD"), ("r", "R"), ("ld", "LD")]), VALUE),
    row(&["TON_Coil"], &["CoilTON"], Form::TimerCoil(Op::Ton), TIME),
    row(&["TOF_Coil"], &["CoilTOF"], Form::TimerCoil(Op::Tof), TIME),
    row(&["TP_Coil"], &["CoilTP"], Form::TimerCoil(Op::Tp), TIME),
    row(&["TONR_Coil"], &["CoilTONR"], Form::TimerCoil(Op::Rto), TIME),
    row(&["RT_Coil"], &["ResetIECTimerCoil", "RtCoil"], Form::ResetTimer, None),
    row(&["Move"], &["Move"], Form::Move, None),
    row(&["Add"], &["Add"], Form::Value(Op::Add, Pins::Numbered), SRC),
    row(&["Sub"], &["Sub"], Form::Value(Op::Sub, TWO), SRC),
    row(&["Mul"], &["Mul"], Form::Value(Op::Mul, Pins::Numbered), SRC),
    row(&["Div"], &["Div"], Form::Value(Op::Div, TWO), SRC),
    row(&["Mod"], &["Mod"], Form::Value(Op::Mod, TWO), SRC),
    row(&["Expt"], &["Expt"], Form::Value(Op::Exp, TWO), SRC),
    row(&["Neg"], &["Neg"], Form::Value(Op::Neg, IN), SRC),
    row(&["Abs"], &["Abs"], Form::Value(Op::Abs, IN), SRC),
    row(&["Sqrt"], &["Sqrt"], Form::Value(Op::Sqrt, IN), SRC),
    row(&["Ln"], &["Ln"], Form::Value(Op::Ln, IN), SRC),
    row(&["Exp"], &["Exp"], Form::Value(Op::Expe, IN), SRC),
    row(&["Sin"], &["Sin"], Form::Value(Op::Sin, IN), SRC),
    row(&["Cos"], &["Cos"], Form::Value(Op::Cos, IN), SRC),
    row(&["Tan"], &["Tan"], Form::Value(Op::Tan, IN), SRC),
    row(&["Asin"], &["Asin"], Form::Value(Op::Asin, IN), SRC),
    row(&["Acos"], &["Acos"], Form::Value(Op::Acos, IN), SRC),
    row(&["Atan"], &["Atan"], Form::Value(Op::Atan, IN), SRC),
    row(&["Sqr"], &["Sqr"], Form::Square, SRC),
    row(&["Inc"], &["Inc"], Form::Step(Op::Add), SRC),
    row(&["Dec"], &["Dec"], Form::Step(Op::Sub), SRC),
    row(&["MIN"], &["MIN"], Form::Value(Op::Min, Pins::Numbered), VALUE),
    row(&["MAX"], &["MAX"], Form::Value(Op::Max, Pins::Numbered), VALUE),
    row(&["Limit"], &["LIMIT"], Form::Value(Op::Limit, Pins::Named(&["min", "in", "max"])), VALUE),
    row(&["SEL"], &["SEL"], Form::Value(Op::Sel, Pins::Selected("g")), VALUE),
    row(&["Mux"], &["Mux"], Form::Value(Op::Mux, Pins::Selected("k")), SRC),
    row(&["And"], &["And"], Form::Value(Op::And, Pins::Numbered), SRC),
    row(&["Or"], &["Or"], Form::Value(Op::Or, Pins::Numbered), SRC),
    row(&["Xor"], &["Xor"], Form::Value(Op::Xor, Pins::Numbered), SRC),
    row(&["Inv"], &["Inv"], Form::Value(Op::Not, IN), SRC),
    row(&["Shl"], &["Shl"], Form::Value(Op::Shl, SHIFTED), SRC),
    row(&["Shr"], &["Shr"], Form::Value(Op::Shr, SHIFTED), SRC),
    row(&["Rol"], &["Rl", "Rol"], Form::Value(Op::Rol, SHIFTED), SRC),
    row(&["Ror"], &["Rr", "Ror"], Form::Value(Op::Ror, SHIFTED), SRC),
    row(&["Convert"], &["Convert"], Form::Convert, None),
    row(&["R_TRIG"], &["R_TRIG"], Form::Trigger(Edge::Rising), None),
    row(&["F_TRIG"], &["F_TRIG"], Form::Trigger(Edge::Falling), None),
    row(&["Trunc"], &["Trunc"], Form::Value(Op::Trunc, IN), None),
    row(&["Round"], &["Round"], Form::Convert, None),
    row(&["Calculate"], &["Calc"], Form::Calculate, SRC),
    row(&["JumpCoil"], &["Jump"], Form::Jump { negated: false }, None),
    row(&["I_JumpCoil"], &["JumpNot"], Form::Jump { negated: true }, None),
    row(&["Return", "ReturnCoil", "ReturnTrue", "ReturnFalse"], &["Return"], Form::Return, None),
];

/// The instruction of a name in a source document. Upper and lower case make a difference there, and people forget it: only
/// a comparison and a gate that differ in nothing else are told apart by it.
pub(crate) fn of_document(name: &str) -> Option<&'static Row> {
    let exact = ROWS.iter().find(|row| row.sd.contains(&name));
    exact.or_else(|| {
        ROWS.iter()
            .find(|row| row.sd.iter().any(|own| own.eq_ignore_ascii_case(name)))
    })
}

/// What an instruction here is written as. One that names a form has it only by the operand that it is given.
pub(crate) fn of_op(op: Op) -> Option<&'static Row> {
    ROWS.iter().find(|row| row.form.op() == Some(op))
}

/// The instruction of a form.
pub(crate) fn of_form(form: Form) -> Option<&'static Row> {
    ROWS.iter().find(|row| row.form == form)
}

/// Pins that have other names in SimaticML: of which instruction, the name in a document, and that there.
const PINS: [(&str, &str, &str); 3] = [
    ("Limit", "min", "MN"),
    ("Limit", "max", "MX"),
    ("RT_Coil", "timer", "operand"),
];

impl Row {
    /// Whether it is of the library of the standard: such have a version in SimaticML, and pins in capitals.
    pub(crate) fn is_of_library(&self) -> bool {
        self.template.is_some_and(|name| name != "SrcType") && !self.form.is_coil()
    }

    /// The name of a pin in SimaticML.
    pub(crate) fn pin_there(&self, pin: &str) -> String {
        let mut other = PINS.iter().filter(|(row, ..)| *row == self.sd[0]);
        match other.find(|(_, here, _)| *here == pin) {
            Some((.., there)) => (*there).to_owned(),
            None if self.is_of_library() => pin.to_ascii_uppercase(),
            None => pin.to_owned(),
        }
    }
}

/// The name in a document of a pin that has another one in SimaticML.
pub(crate) fn pin_here<'p>(instruction: &str, pin: &'p str) -> &'p str {
    let mut other = PINS.iter().filter(|(row, ..)| *row == instruction);
    let found = other.find(|(.., there)| there.eq_ignore_ascii_case(pin));
    found.map_or(pin, |(_, here, _)| here)
}

/// The instruction of a part in SimaticML.
pub(crate) fn of_xml(name: &str) -> Option<&'static Row> {
    ROWS.iter()
        .find(|row| row.xml.iter().any(|own| own.eq_ignore_ascii_case(name)))
}

/// Whether an instruction is after what holds its state.
pub(crate) fn with_instance(name: &str) -> bool {
    let form = of_document(name).map(|row| row.form);
    matches!(
        form,
        Some(Form::State(..) | Form::Bistable { .. } | Form::Trigger(_))
    )
}

/// Types of what holds a state: as they are spelled here, and there.
#[rustfmt::skip]
const STATES: [(&str, &str); 7] = [
    ("TON", "TON_TIME"), ("TOF", "TOF_TIME"), ("TP", "TP_TIME"), ("RTO", "TONR_TIME"),
    ("CTU", "CTU_DINT"), ("CTD", "CTD_DINT"), ("CTUD", "CTUD_DINT"),
];

/// Elementary types: as they are spelled here, and there.
#[rustfmt::skip]
const ELEMENTARY: [(&str, &str); 19] = [
    ("BOOL", "Bool"), ("BYTE", "Byte"), ("WORD", "Word"), ("DWORD", "DWord"), ("LWORD", "LWord"),
    ("SINT", "SInt"), ("INT", "Int"), ("DINT", "DInt"), ("LINT", "LInt"),
    ("USINT", "USInt"), ("UINT", "UInt"), ("UDINT", "UDInt"), ("ULINT", "ULInt"),
    ("REAL", "Real"), ("LREAL", "LReal"), ("TIME", "Time"),
    ("DATE", "Date"), ("TOD", "Time_Of_Day"), ("DT", "LDT"),
];

/// The type of what holds a state, from the name of a declared type: `CTU_INT` is that of a `CTU`.
pub(crate) fn state_type(name: &str) -> Option<&'static str> {
    let upper = name.to_ascii_uppercase();
    let base = match upper.split_once('_') {
        Some((
            base,
            "TIME" | "LTIME" | "SINT" | "INT" | "DINT" | "LINT" | "USINT" | "UINT" | "UDINT" | "ULINT",
        )) => base,
        _ => &upper,
    };
    let of = |(_, there): &&(&str, &str)| there.split('_').next() == Some(base);
    STATES.iter().find(of).map(|(own, _)| *own)
}

/// The edge detector of a name.
pub(crate) fn trigger(name: &str) -> Option<Edge> {
    match name.to_ascii_uppercase().as_str() {
        "R_TRIG" => Some(Edge::Rising),
        "F_TRIG" => Some(Edge::Falling),
        _ => None,
    }
}

/// The elementary type of a name, as it is spelled here.
pub(crate) fn elementary(name: &str) -> Option<&'static str> {
    let upper = name.to_ascii_uppercase();
    let name = match upper.as_str() {
        "LTIME" => "TIME",
        "TIME_OF_DAY" | "LTOD" | "LTIME_OF_DAY" => "TOD",
        "DATE_AND_TIME" | "LDT" => "DT",
        other => other,
    };
    ELEMENTARY.iter().map(|(own, _)| *own).find(|own| *own == name)
}

/// An elementary type of here, or that of what holds a state, as it is spelled there.
pub(crate) fn spelled(own: &str) -> Option<&'static str> {
    let mut all = ELEMENTARY.iter().chain(&STATES);
    all.find(|(name, _)| *name == own).map(|(_, there)| *there)
}

/// The pin that power enters, and the one that it leaves, in SimaticML.
pub(crate) fn power_pins(name: &str) -> (&'static str, &'static str) {
    match of_xml(name).map(|row| row.form) {
        Some(Form::Bits(_)) if name.ends_with("Bitfield") => ("en", "eno"),
        Some(Form::Compare(_) | Form::InRange | Form::OutRange | Form::Valid(_)) => ("pre", "out"),
        Some(Form::State(Op::Ctu, _)) => ("CU", "Q"),
        Some(Form::State(Op::Ctd, _)) => ("CD", "Q"),
        Some(Form::State(Op::Ctud, _)) => ("CU", "QU"),
        Some(Form::State(..)) => ("IN", "Q"),
        Some(Form::Bistable { reset_wins: true }) => ("s", "q"),
        Some(Form::Bistable { reset_wins: false }) => ("r", "q"),
        Some(
            Form::Contact(_)
            | Form::EdgeContact(_)
            | Form::Edge(_)
            | Form::Not
            | Form::Coil(_)
            | Form::EdgeCoil(_)
            | Form::Bits(_)
            | Form::TimerCoil(_)
            | Form::ResetTimer
            | Form::Jump { .. }
            | Form::Return,
        ) => ("in", "out"),
        _ => ("en", "eno"),
    }
}

/// System tags, and what a project calls the same while its system and clock memory are on.
pub(crate) const SYSTEM: [(SystemTag, &str); 6] = [
    (SystemTag::On, "AlwaysTRUE"),
    (SystemTag::Off, "AlwaysFALSE"),
    (SystemTag::FirstScan, "FirstScan"),
    (SystemTag::Clock(Clock::HundredMilliseconds), "Clock_10Hz"),
    (SystemTag::Clock(Clock::HalfSecond), "Clock_2Hz"),
    (SystemTag::Clock(Clock::Second), "Clock_1Hz"),
];

/// Whether a project has a tag of `SYS`.
pub(crate) fn has(tag: SystemTag) -> bool {
    SYSTEM.iter().any(|(own, _)| *own == tag)
}
