//! The instructions of SIMATIC controllers, each under its names in source documents and in SimaticML, next to what says
//! the same here.

use ladder_analysis::names::system_tag::SystemTag;

/// What an instruction becomes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Form {
    /// A contact.
    Contact(&'static str),
    /// A contact with a bit that remembers.
    EdgeContact(&'static str),
    /// A comparison as a contact.
    Compare(&'static str),
    /// A comparison as a box, with its sign.
    CompareBox(&'static str),
    /// Whether a value lies between two others.
    InRange,
    OutRange,
    /// Whether a real is a number.
    Valid,
    Invalid,
    /// The edge of the power, with a bit that remembers.
    Edge(&'static str),
    Not,
    Coil(&'static str),
    /// A coil with a bit that remembers.
    EdgeCoil(&'static str),
    /// A coil on several bits.
    Bits(&'static str),
    /// A bit that is set and reset: whether resetting is stronger.
    Bistable {
        reset_wins: bool,
    },
    /// A block with a state: its mnemonic, and the pins that are operands, each with its name here (by place without).
    State(&'static str, &'static [(&'static str, &'static str)]),
    TimerCoil(&'static str),
    ResetTimer,
    Move,
    /// A result from values: its mnemonic, and the pins.
    Value(&'static str, Pins),
    Square,
    /// A value that is counted up or down.
    Step(&'static str),
    Convert,
    Calculate,
    Jump {
        negated: bool,
    },
    Return {
        negated: bool,
    },
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
    row(&["Contact"], &["Contact"], Form::Contact("[ ]"), None),
    row(&["I_Contact"], &[], Form::Contact("[/]"), None),
    row(&["P_Contact"], &["PContact"], Form::EdgeContact("[P]"), None),
    row(&["N_Contact"], &["NContact"], Form::EdgeContact("[N]"), None),
    row(&["P_Trig"], &["PBox"], Form::Edge("[OSR]"), None),
    row(&["N_Trig"], &["NBox"], Form::Edge("[OSF]"), None),
    row(&["Not"], &["Not"], Form::Not, None),
    row(&["EQ_Contact"], &["Eq"], Form::Compare("EQ"), SRC),
    row(&["NE_Contact"], &["Ne"], Form::Compare("NE"), SRC),
    row(&["GT_Contact"], &["Gt"], Form::Compare("GT"), SRC),
    row(&["GE_Contact"], &["Ge"], Form::Compare("GE"), SRC),
    row(&["LT_Contact"], &["Lt"], Form::Compare("LT"), SRC),
    row(&["LE_Contact"], &["Le"], Form::Compare("LE"), SRC),
    row(&["EQ"], &[], Form::CompareBox("="), SRC),
    row(&["NE"], &[], Form::CompareBox("<>"), SRC),
    row(&["GT"], &[], Form::CompareBox(">"), SRC),
    row(&["GE"], &[], Form::CompareBox(">="), SRC),
    row(&["LT"], &[], Form::CompareBox("<"), SRC),
    row(&["LE"], &[], Form::CompareBox("<="), SRC),
    row(&["InRange"], &["InRange"], Form::InRange, SRC),
    row(&["OutRange"], &["OutRange"], Form::OutRange, SRC),
    row(&["IsValidContact", "OK"], &["OK"], Form::Valid, None),
    row(&["IsNotValidContact", "NOK"], &["NotOK", "NOK"], Form::Invalid, None),
    row(&["Coil"], &["Coil"], Form::Coil("( )"), None),
    row(&["I_Coil"], &[], Form::Coil("(/)"), None),
    row(&["S_Coil"], &["SCoil"], Form::Coil("(S)"), None),
    row(&["R_Coil"], &["RCoil"], Form::Coil("(R)"), None),
    row(&["P_Coil"], &["PCoil"], Form::EdgeCoil("(P)"), None),
    row(&["N_Coil"], &["NCoil"], Form::EdgeCoil("(N)"), None),
    row(&["S_BitfieldCoil"], &["SET_BF"], Form::Bits("(S)"), None),
    row(&["R_BitfieldCoil"], &["RESET_BF"], Form::Bits("(R)"), None),
    row(&["S_SR", "SR"], &["Sr"], Form::Bistable { reset_wins: true }, None),
    row(&["S_RS", "RS"], &["Rs"], Form::Bistable { reset_wins: false }, None),
    row(&["TON"], &["TON"], Form::State("TON", PT), TIME),
    row(&["TOF"], &["TOF"], Form::State("TOF", PT), TIME),
    row(&["TP"], &["TP"], Form::State("TP", PT), TIME),
    row(&["TONR"], &["TONR"], Form::State("RTO", &[("pt", ""), ("r", "R")]), TIME),
    row(&["CTU"], &["CTU"], Form::State("CTU", &[("pv", ""), ("r", "R")]), VALUE),
    row(&["CTD"], &["CTD"], Form::State("CTD", &[("pv", ""), ("ld", "LD")]), VALUE),
    row(&["CTUD"], &["CTUD"], Form::State("CTUD", &[("pv", ""), ("cd", "CD"), ("r", "R"), ("ld", "LD")]), VALUE),
    row(&["TON_Coil"], &["CoilTON"], Form::TimerCoil("TON"), TIME),
    row(&["TOF_Coil"], &["CoilTOF"], Form::TimerCoil("TOF"), TIME),
    row(&["TP_Coil"], &["CoilTP"], Form::TimerCoil("TP"), TIME),
    row(&["TONR_Coil"], &["CoilTONR"], Form::TimerCoil("RTO"), TIME),
    row(&["RT_Coil"], &["RtCoil"], Form::ResetTimer, None),
    row(&["Move"], &["Move"], Form::Move, None),
    row(&["Add"], &["Add"], Form::Value("ADD", Pins::Numbered), SRC),
    row(&["Sub"], &["Sub"], Form::Value("SUB", TWO), SRC),
    row(&["Mul"], &["Mul"], Form::Value("MUL", Pins::Numbered), SRC),
    row(&["Div"], &["Div"], Form::Value("DIV", TWO), SRC),
    row(&["Mod"], &["Mod"], Form::Value("MOD", TWO), SRC),
    row(&["Expt"], &["Expt"], Form::Value("EXP", TWO), SRC),
    row(&["Neg"], &["Neg"], Form::Value("NEG", IN), SRC),
    row(&["Abs"], &["Abs"], Form::Value("ABS", IN), SRC),
    row(&["Sqrt"], &["Sqrt"], Form::Value("SQRT", IN), SRC),
    row(&["Ln"], &["Ln"], Form::Value("LN", IN), SRC),
    row(&["Exp"], &["Exp"], Form::Value("EXPE", IN), SRC),
    row(&["Sin"], &["Sin"], Form::Value("SIN", IN), SRC),
    row(&["Cos"], &["Cos"], Form::Value("COS", IN), SRC),
    row(&["Tan"], &["Tan"], Form::Value("TAN", IN), SRC),
    row(&["Asin"], &["Asin"], Form::Value("ASIN", IN), SRC),
    row(&["Acos"], &["Acos"], Form::Value("ACOS", IN), SRC),
    row(&["Atan"], &["Atan"], Form::Value("ATAN", IN), SRC),
    row(&["Sqr"], &["Sqr"], Form::Square, SRC),
    row(&["Inc"], &["Inc"], Form::Step("ADD"), SRC),
    row(&["Dec"], &["Dec"], Form::Step("SUB"), SRC),
    row(&["MIN"], &["Min"], Form::Value("MIN", Pins::Numbered), VALUE),
    row(&["MAX"], &["Max"], Form::Value("MAX", Pins::Numbered), VALUE),
    row(&["Limit"], &["Limit"], Form::Value("LIMIT", Pins::Named(&["min", "in", "max"])), VALUE),
    row(&["SEL"], &["Sel"], Form::Value("SEL", Pins::Selected("g")), VALUE),
    row(&["Mux"], &["Mux"], Form::Value("MUX", Pins::Selected("k")), SRC),
    row(&["And"], &["And"], Form::Value("AND", Pins::Numbered), SRC),
    row(&["Or"], &["Or"], Form::Value("OR", Pins::Numbered), SRC),
    row(&["Xor"], &["Xor"], Form::Value("XOR", Pins::Numbered), SRC),
    row(&["Inv"], &["Inv"], Form::Value("NOT", IN), SRC),
    row(&["Shl"], &["Shl"], Form::Value("SHL", SHIFTED), SRC),
    row(&["Shr"], &["Shr"], Form::Value("SHR", SHIFTED), SRC),
    row(&["Rol"], &["Rl", "Rol"], Form::Value("ROL", SHIFTED), SRC),
    row(&["Ror"], &["Rr", "Ror"], Form::Value("ROR", SHIFTED), SRC),
    row(&["Convert"], &["Convert"], Form::Convert, None),
    row(&["Trunc"], &["Trunc"], Form::Value("TRUNC", IN), None),
    row(&["Round"], &["Round"], Form::Convert, None),
    row(&["Calculate"], &["Calc"], Form::Calculate, SRC),
    row(&["JumpCoil"], &["Jump"], Form::Jump { negated: false }, None),
    row(&["I_JumpCoil"], &["JumpNot"], Form::Jump { negated: true }, None),
    row(&["ReturnCoil", "Return", "ReturnTrue", "ReturnFalse"], &["Return"], Form::Return { negated: false }, None),
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

/// The instruction of a part in SimaticML.
pub(crate) fn of_xml(name: &str) -> Option<&'static Row> {
    ROWS.iter()
        .find(|row| row.xml.iter().any(|own| own.eq_ignore_ascii_case(name)))
}

/// Whether an instruction stands after what holds its state.
pub(crate) fn with_instance(name: &str) -> bool {
    let form = of_document(name).map(|row| row.form);
    matches!(form, Some(Form::State(..) | Form::Bistable { .. }))
}

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
    Some(match base {
        "TON" => "TON",
        "TOF" => "TOF",
        "TP" => "TP",
        "TONR" => "RTO",
        "CTU" => "CTU",
        "CTD" => "CTD",
        "CTUD" => "CTUD",
        _ => return None,
    })
}

/// The elementary type of a name, as it is spelled here.
pub(crate) fn elementary(name: &str) -> Option<&'static str> {
    const SAME: [&str; 19] = [
        "BOOL", "BYTE", "WORD", "DWORD", "LWORD", "SINT", "INT", "DINT", "LINT", "USINT", "UINT", "UDINT",
        "ULINT", "REAL", "LREAL", "TIME", "DATE", "TOD", "DT",
    ];
    let upper = name.to_ascii_uppercase();
    let name = match upper.as_str() {
        "LTIME" => "TIME",
        "TIME_OF_DAY" | "LTOD" | "LTIME_OF_DAY" => "TOD",
        "DATE_AND_TIME" | "LDT" => "DT",
        other => other,
    };
    SAME.into_iter().find(|own| *own == name)
}

/// The pin that power enters, and the one that it leaves, in SimaticML.
pub(crate) fn power_pins(name: &str) -> (&'static str, &'static str) {
    match of_xml(name).map(|row| row.form) {
        Some(Form::Compare(_) | Form::InRange | Form::OutRange | Form::Valid | Form::Invalid) => {
            ("pre", "out")
        }
        Some(Form::State("CTU", _)) => ("CU", "Q"),
        Some(Form::State("CTD", _)) => ("CD", "Q"),
        Some(Form::State("CTUD", _)) => ("CU", "QU"),
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
            | Form::Return { .. },
        ) => ("in", "out"),
        _ => ("en", "eno"),
    }
}

/// System tags, and what a project calls the same while its system and clock memory are on.
pub(crate) const SYSTEM: [(&str, &str); 6] = [
    ("SYS.ON", "AlwaysTRUE"),
    ("SYS.OFF", "AlwaysFALSE"),
    ("SYS.FIRST_SCAN", "FirstScan"),
    ("SYS.CLOCK_100MS", "Clock_10Hz"),
    ("SYS.CLOCK_500MS", "Clock_2Hz"),
    ("SYS.CLOCK_1S", "Clock_1Hz"),
];

/// Whether a project has a tag of `SYS`.
pub(crate) fn has(tag: SystemTag) -> bool {
    SYSTEM
        .iter()
        .any(|(name, _)| name.strip_prefix("SYS.") == Some(tag.name()))
}
