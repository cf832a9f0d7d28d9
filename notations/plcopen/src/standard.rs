//! The functions and function blocks of IEC 61131-3, each next to the instruction that says the same.

use Pins::{Chosen, Fixed, Many};
use ladder_format::program::Operator;
use ladder_instructions::{Op, by_op};

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
    let name = match upper.as_str() {
        "ADD_TIME" => "ADD",
        "SUB_TIME" => "SUB",
        "MUL_TIME" | "MULTIME" => "MUL",
        "DIV_TIME" | "DIVTIME" => "DIV",
        other => other,
    };
    let known = FUNCTIONS.iter().find(|(known, ..)| *known == name);
    known.map(|(_, op, _)| Function::Value(by_op(*op).mnemonic))
}

/// The inputs of a function.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Pins {
    /// These.
    Fixed(&'static [&'static str]),
    /// `IN1`, `IN2`, as many as there are.
    Many,
    /// `K`, `IN0`, `IN1`, as many as there are.
    Chosen,
}

const ONE: Pins = Fixed(&["IN"]);
const TWO: Pins = Fixed(&["IN1", "IN2"]);
const SHIFT: Pins = Fixed(&["IN", "N"]);

/// The functions of the standard, each with the instruction that says the same, and its inputs.
const FUNCTIONS: &[(&str, Op, Pins)] = &[
    ("MOVE", Op::Mov, ONE),
    ("ADD", Op::Add, Many),
    ("MUL", Op::Mul, Many),
    ("SUB", Op::Sub, TWO),
    ("DIV", Op::Div, TWO),
    ("MOD", Op::Mod, TWO),
    ("EXPT", Op::Exp, TWO),
    ("NOT", Op::Not, ONE),
    ("AND", Op::And, Many),
    ("OR", Op::Or, Many),
    ("XOR", Op::Xor, Many),
    ("SHL", Op::Shl, SHIFT),
    ("SHR", Op::Shr, SHIFT),
    ("ROL", Op::Rol, SHIFT),
    ("ROR", Op::Ror, SHIFT),
    ("ABS", Op::Abs, ONE),
    ("SQRT", Op::Sqrt, ONE),
    ("LN", Op::Ln, ONE),
    ("LOG", Op::Log, ONE),
    ("EXP", Op::Expe, ONE),
    ("SIN", Op::Sin, ONE),
    ("COS", Op::Cos, ONE),
    ("TAN", Op::Tan, ONE),
    ("ASIN", Op::Asin, ONE),
    ("ACOS", Op::Acos, ONE),
    ("ATAN", Op::Atan, ONE),
    ("MIN", Op::Min, Many),
    ("MAX", Op::Max, Many),
    ("LIMIT", Op::Limit, Fixed(&["MN", "IN", "MX"])),
    ("SEL", Op::Sel, Fixed(&["G", "IN0", "IN1"])),
    ("MUX", Op::Mux, Chosen),
    ("LEN", Op::Len, ONE),
    ("LEFT", Op::Left, Fixed(&["IN", "L"])),
    ("RIGHT", Op::Right, Fixed(&["IN", "L"])),
    ("MID", Op::Mid, Fixed(&["IN", "L", "P"])),
    ("CONCAT", Op::Concat, Many),
    ("INSERT", Op::Insert, Fixed(&["IN1", "IN2", "P"])),
    ("DELETE", Op::Delete, Fixed(&["IN", "L", "P"])),
    ("REPLACE", Op::Replace, Fixed(&["IN1", "IN2", "L", "P"])),
    ("FIND", Op::Find, TWO),
    ("EQ", Op::Eq, Many),
    ("NE", Op::Ne, TWO),
    ("GT", Op::Gt, Many),
    ("GE", Op::Ge, Many),
    ("LT", Op::Lt, Many),
    ("LE", Op::Le, Many),
];

/// The function of an instruction, and its inputs. None: the standard has none.
pub(crate) fn function_of(op: Op) -> Option<(&'static str, Pins)> {
    let row = FUNCTIONS.iter().find(|(_, known, _)| *known == op)?;
    Some((row.0, row.2))
}

impl Pins {
    /// The names of so many inputs. None: it has another number of them.
    pub(crate) fn names(self, count: usize) -> Option<Vec<String>> {
        match self {
            Fixed(names) => {
                (names.len() == count).then(|| names.iter().map(|name| (*name).to_owned()).collect())
            }
            Many => (count > 1).then(|| (1..=count).map(|n| format!("IN{n}")).collect()),
            Chosen => (count > 1).then(|| {
                let rest = (0..count - 1).map(|n| format!("IN{n}"));
                std::iter::once("K".to_owned()).chain(rest).collect()
            }),
        }
    }
}

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
