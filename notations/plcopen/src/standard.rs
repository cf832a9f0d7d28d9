//! The functions and function blocks of IEC 61131-3, each next to the instruction that says the same.

use ladder_format::program::Operator;

/// A function block of the standard.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum StandardBlock {
    /// A timer, counter or bistable: its mnemonic, the pin that power enters, and the pins that are operands, with
    /// the names of those that are not given by place.
    Stateful(
        &'static str,
        &'static str,
        &'static [(&'static str, Option<&'static str>)],
    ),
    /// `R_TRIG`
    Rising,
    /// `F_TRIG`
    Falling,
}

/// The standard block of a name: `CTU_DINT` is a `CTU` here.
pub(crate) fn block(name: &str) -> Option<StandardBlock> {
    use StandardBlock::{Falling, Rising, Stateful};
    const TIMER: &[(&str, Option<&str>)] = &[("PT", None)];
    const RESETTABLE: &[(&str, Option<&str>)] = &[("PT", None), ("R", Some("R"))];
    let upper = name.to_ascii_uppercase();
    let base = match upper.split_once('_') {
        Some((base, "INT" | "DINT" | "LINT" | "UINT" | "UDINT" | "ULINT" | "TIME")) => base,
        _ => upper.as_str(),
    };
    Some(match base {
        "TON" => Stateful("TON", "IN", TIMER),
        "TOF" => Stateful("TOF", "IN", TIMER),
        "TP" => Stateful("TP", "IN", TIMER),
        "CTU" => Stateful("CTU", "CU", &[("PV", None), ("R", Some("R"))]),
        "LADDER_RTO" => Stateful("RTO", "IN", RESETTABLE),
        "LADDER_RTOF" => Stateful("RTOF", "IN", RESETTABLE),
        "LADDER_CTC" => Stateful("CTC", "CU", &[("PV", None), ("R", Some("R"))]),
        "CTD" => Stateful("CTD", "CD", &[("PV", None), ("LD", Some("LD"))]),
        "CTUD" => Stateful(
            "CTUD",
            "CU",
            &[
                ("PV", None),
                ("CD", Some("CD")),
                ("R", Some("R")),
                ("LD", Some("LD")),
            ],
        ),
        "SR" => Stateful("SR", "S1", &[("R", Some("R"))]),
        "RS" => Stateful("RS", "S", &[("R1", Some("R"))]),
        "R_TRIG" => Rising,
        "F_TRIG" => Falling,
        _ => return None,
    })
}

/// The pin of a standard block that a name means: CODESYS calls the inputs of its bistables otherwise.
pub(crate) fn is_pin(written: &str, pin: &str) -> bool {
    let same = |one: &str| one.eq_ignore_ascii_case(written);
    same(pin)
        || match pin {
            "S1" => same("SET1") || same("S"),
            "S" => same("SET"),
            "R" => same("RESET"),
            "R1" => same("RESET1"),
            "LD" => same("LOAD"),
            _ => false,
        }
}

/// The output of a standard block that is its power.
pub(crate) fn power_output(block: StandardBlock) -> &'static str {
    match block {
        StandardBlock::Stateful("SR" | "RS", ..) => "Q1",
        StandardBlock::Stateful("CTUD", ..) => "QU",
        _ => "Q",
    }
}

/// What leaves timers, counters and bistables.
pub(crate) const OUTPUTS: &[&str] = &["Q", "Q1", "QU", "QD", "ET", "CV"];

/// The type of an output of a standard block.
pub(crate) fn output_type(pin: &str) -> &'static str {
    match pin.to_ascii_uppercase().as_str() {
        "ET" | "PT" => "TIME",
        "CV" | "PV" => "DINT",
        _ => "BOOL",
    }
}

/// A function of the standard.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Function {
    /// AND, OR, XOR, NOT: of powers they are wires, of words an instruction.
    Gate(Gate),
    /// Of two values or more, power.
    Compare(&'static str, Operator),
    /// A value, by the mnemonic of the instruction.
    Value(&'static str),
    /// A value in another type.
    Convert(&'static str),
}

/// See [`Function::Gate`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Gate {
    And,
    Or,
    Xor,
    Not,
}

/// The function of a name.
pub(crate) fn function(name: &str) -> Option<Function> {
    let upper = name.to_ascii_uppercase();
    let compare = |mnemonic, operator| Some(Function::Compare(mnemonic, operator));
    match upper.as_str() {
        "AND" => return Some(Function::Gate(Gate::And)),
        "OR" => return Some(Function::Gate(Gate::Or)),
        "XOR" => return Some(Function::Gate(Gate::Xor)),
        "NOT" => return Some(Function::Gate(Gate::Not)),
        "EQ" => return compare("EQ", Operator::Equal),
        "NE" => return compare("NE", Operator::NotEqual),
        "GT" => return compare("GT", Operator::Greater),
        "GE" => return compare("GE", Operator::GreaterEqual),
        "LT" => return compare("LT", Operator::Less),
        "LE" => return compare("LE", Operator::LessEqual),
        "TRUNC" => return Some(Function::Value("TRUNC")),
        _ => {}
    }
    if let Some((_, to)) = upper
        .split_once("_TO_")
        .or_else(|| upper.split_once("TO_").filter(|(from, _)| from.is_empty()))
    {
        return elementary(to).map(Function::Convert);
    }
    let mnemonic = match upper.as_str() {
        "MOVE" => "MOV",
        "EXPT" => "EXP",
        "ADD_TIME" => "ADD",
        "SUB_TIME" => "SUB",
        "MUL_TIME" | "MULTIME" => "MUL",
        "DIV_TIME" | "DIVTIME" => "DIV",
        "EXP" => "EXPE",
        other => other,
    };
    let known = VALUES.iter().find(|known| **known == mnemonic);
    known.copied().map(Function::Value)
}

/// What makes a value of values, in the order of the standard's pins.
const VALUES: &[&str] = &[
    "MOV", "ADD", "SUB", "MUL", "DIV", "MOD", "EXP", "ABS", "SQRT", "LN", "LOG", "EXPE", "SIN", "COS", "TAN",
    "ASIN", "ACOS", "ATAN", "MIN", "MAX", "LIMIT", "SEL", "MUX", "SHL", "SHR", "ROL", "ROR", "LEN", "LEFT",
    "RIGHT", "MID", "CONCAT", "INSERT", "DELETE", "REPLACE", "FIND",
];

/// The elementary type of a name, as it is spelled here.
pub(crate) fn elementary(name: &str) -> Option<&'static str> {
    const TYPES: [&str; 19] = [
        "BOOL", "BYTE", "WORD", "DWORD", "LWORD", "SINT", "INT", "DINT", "LINT", "USINT", "UINT", "UDINT",
        "ULINT", "REAL", "LREAL", "TIME", "DATE", "TOD", "DT",
    ];
    let upper = name.to_ascii_uppercase();
    // The web pages of Beremiz have types of their own for the same.
    let name = match upper.strip_prefix("HMI_").unwrap_or(&upper) {
        "LTIME" => "TIME",
        "TIME_OF_DAY" | "LTOD" | "LTIME_OF_DAY" => "TOD",
        "DATE_AND_TIME" | "LDT" | "LDATE_AND_TIME" => "DT",
        "LDATE" => "DATE",
        "BIT" => "BOOL",
        "STRING" | "WSTRING" => return Some("STRING"),
        other => other,
    };
    TYPES.iter().find(|known| **known == name).copied()
}
