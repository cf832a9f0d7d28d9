//! The instructions that have a counterpart here, by all their names, and what their operands are. What the translation,
//! the types of undeclared tags and the reader of RSLogix 500's text know of an instruction is in this table.

use ladder_format::program::{Operator, Sign};
use ladder_instructions::Op as Own;
use std::collections::HashMap;
use std::sync::LazyLock;

/// An instruction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Op {
    /// A contact, as it is here.
    Contact(Own),
    Coil(Own),
    Ons,
    Osr,
    Osf,
    Timer(&'static str),
    Counter(&'static str),
    /// Of structured text: all its inputs are members of a tag.
    Tagged(&'static str),
    Res,
    Compare(Own),
    Lim,
    Meq,
    Cmp,
    /// An operator between two values.
    Binary(Operator),
    /// A sign before a value.
    Unary(Sign),
    /// A function of one value.
    Function(&'static str),
    Atan2,
    Trunc,
    Cpt,
    Mov,
    Mvm,
    Btd,
    Clr,
    Cop,
    Fll,
    Shift(&'static str),
    Load(&'static str),
    Unload(&'static str),
    Sqi,
    Sqo,
    Sql,
    Fal,
    Fsc,
    /// `AVE` and `STD`
    Statistic(&'static str),
    Srt,
    Size,
    Swpb,
    ToBcd,
    FromBcd,
    For,
    Brk,
    /// A label, or a jump to one.
    Label(Own),
    Jsr,
    Sbr,
    Ret,
    Mcr,
    Afi,
    Nop,
    Tnd,
    Scl,
    Scp,
    Pid,
    /// A function of strings.
    Strings(Own),
    /// A number as text, and back.
    ToText,
    FromText,
}

impl Op {
    /// Whether it decides about the power of its rung. All others act, and pass it.
    pub(crate) const fn is_condition(self, operands: usize) -> bool {
        match self {
            Op::Contact(_) | Op::Ons | Op::Compare(_) | Op::Lim | Op::Meq | Op::Cmp => true,
            Op::Osr => operands == 1,
            _ => false,
        }
    }

    /// Whether the routine may not go on after it, or goes on elsewhere or with other rails.
    pub(crate) const fn may_leave(self) -> bool {
        matches!(
            self,
            Op::Label(_) | Op::Ret | Op::Brk | Op::Tnd | Op::Mcr | Op::Sbr
        )
    }
}

/// What an operand is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Role {
    Bit,
    Value,
    Timer,
    Counter,
    Control,
    /// A timer, counter or control.
    State,
    /// An array, or the element that a part of one begins with.
    Array,
    /// A formula.
    Formula,
    /// A number that is a member of another operand, or `?`.
    Preset,
    /// A name, a mode, a constant: no tag.
    Word,
    Text,
}

/// A row of the table: the names, the instruction, its operands, and those that it has in RSLogix 500 if they differ.
/// A letter is an operand, see [`role`]; a capital letter one that it writes.
type Row = (&'static [&'static str], Op, &'static str, Option<&'static str>);

const fn row(names: &'static [&'static str], op: Op, operands: &'static str) -> Row {
    (names, op, operands, None)
}

const ROWS: &[Row] = &[
    row(&["XIC"], Op::Contact(Own::Contact), "b"),
    row(&["XIO"], Op::Contact(Own::NegatedContact), "b"),
    row(&["OTE", "EOT"], Op::Coil(Own::Coil), "B"),
    row(&["OTL"], Op::Coil(Own::SetCoil), "B"),
    row(&["OTU"], Op::Coil(Own::ResetCoil), "B"),
    row(&["ONS"], Op::Ons, "B"),
    (&["OSR"], Op::Osr, "BB", Some("B")),
    row(&["OSF"], Op::Osf, "BB"),
    (&["TON"], Op::Timer("TON"), "Tpp", Some("Twpp")),
    (&["TOF"], Op::Timer("TOF"), "Tpp", Some("Twpp")),
    (&["RTO"], Op::Timer("RTO"), "Tpp", Some("Twpp")),
    row(&["CTU"], Op::Counter("CTU"), "Cpp"),
    row(&["CTD"], Op::Counter("CTD"), "Cpp"),
    row(&["RES"], Op::Res, "S"),
    row(&["EQU", "EQ"], Op::Compare(Own::Eq), "vv"),
    row(&["NEQ", "NE"], Op::Compare(Own::Ne), "vv"),
    row(&["LES", "LT"], Op::Compare(Own::Lt), "vv"),
    row(&["LEQ", "LE"], Op::Compare(Own::Le), "vv"),
    row(&["GRT", "GT"], Op::Compare(Own::Gt), "vv"),
    row(&["GEQ", "GE"], Op::Compare(Own::Ge), "vv"),
    row(&["LIM", "LIMIT"], Op::Lim, "vvv"),
    row(&["MEQ"], Op::Meq, "vvv"),
    row(&["CMP"], Op::Cmp, "f"),
    row(&["ADD"], Op::Binary(Operator::Plus), "vvV"),
    row(&["SUB"], Op::Binary(Operator::Minus), "vvV"),
    row(&["MUL"], Op::Binary(Operator::Times), "vvV"),
    row(&["DIV"], Op::Binary(Operator::Divide), "vvV"),
    row(&["MOD"], Op::Binary(Operator::Mod), "vvV"),
    row(&["XPY", "EXPT"], Op::Binary(Operator::Power), "vvV"),
    row(&["AND"], Op::Binary(Operator::And), "vvV"),
    row(&["OR"], Op::Binary(Operator::Or), "vvV"),
    row(&["XOR"], Op::Binary(Operator::Xor), "vvV"),
    row(&["NOT"], Op::Unary(Sign::Not), "vV"),
    row(&["NEG"], Op::Unary(Sign::Minus), "vV"),
    row(&["ABS"], Op::Function("ABS"), "vV"),
    row(&["SQR", "SQRT"], Op::Function("SQRT"), "vV"),
    row(&["SIN"], Op::Function("SIN"), "vV"),
    row(&["COS"], Op::Function("COS"), "vV"),
    row(&["TAN"], Op::Function("TAN"), "vV"),
    row(&["ASN", "ASIN"], Op::Function("ASIN"), "vV"),
    row(&["ACS", "ACOS"], Op::Function("ACOS"), "vV"),
    row(&["ATN", "ATAN"], Op::Function("ATAN"), "vV"),
    row(&["ATAN2"], Op::Atan2, "vvV"),
    row(&["LN"], Op::Function("LN"), "vV"),
    row(&["LOG"], Op::Function("LOG"), "vV"),
    row(&["DEG"], Op::Function("DEG"), "vV"),
    row(&["RAD"], Op::Function("RAD"), "vV"),
    row(&["TRN", "TRUNC"], Op::Trunc, "vV"),
    row(&["CPT"], Op::Cpt, "Vf"),
    row(&["MOV", "MOVE"], Op::Mov, "vV"),
    row(&["MVM"], Op::Mvm, "vvV"),
    row(&["BTD"], Op::Btd, "vwVww"),
    row(&["CLR"], Op::Clr, "V"),
    row(&["COP", "CPS"], Op::Cop, "aAw"),
    row(&["FLL"], Op::Fll, "vAw"),
    row(&["BSL"], Op::Shift("BSL"), "ARbp"),
    row(&["BSR"], Op::Shift("BSR"), "ARbp"),
    row(&["FFL"], Op::Load("FFL"), "vARpp"),
    row(&["LFL"], Op::Load("LFL"), "vARpp"),
    row(&["FFU"], Op::Unload("FFU"), "AVRpp"),
    row(&["LFU"], Op::Unload("LFU"), "AVRpp"),
    row(&["SQI", "SQC"], Op::Sqi, "avvRpp"),
    row(&["SQO"], Op::Sqo, "avVRpp"),
    row(&["SQL"], Op::Sql, "AvRpp"),
    row(&["FAL"], Op::Fal, "RppwVf"),
    row(&["FSC"], Op::Fsc, "Rppwf"),
    row(&["AVE"], Op::Statistic("AVE"), "awVRpp"),
    row(&["STD"], Op::Statistic("STD"), "awVRpp"),
    row(&["SRT"], Op::Srt, "AwRpp"),
    row(&["SIZE"], Op::Size, "awV"),
    row(&["SWPB"], Op::Swpb, "vwV"),
    row(&["TOD", "TO_BCD"], Op::ToBcd, "vV"),
    row(&["FRD", "BCD_TO"], Op::FromBcd, "vV"),
    row(&["FOR"], Op::For, "wVvvv"),
    row(&["BRK"], Op::Brk, ""),
    row(&["JMP"], Op::Label(Own::Jmp), "w"),
    row(&["LBL"], Op::Label(Own::Lbl), "w"),
    (&["JSR"], Op::Jsr, "w", Some("w")),
    (&["SBR"], Op::Sbr, "", Some("")),
    (&["RET"], Op::Ret, "", Some("")),
    row(&["MCR"], Op::Mcr, ""),
    row(&["AFI"], Op::Afi, ""),
    row(&["NOP"], Op::Nop, ""),
    row(&["TND", "END"], Op::Tnd, ""),
    (&["SCL"], Op::Scl, "W", Some("vvvV")),
    row(&["TONR"], Op::Tagged("TONR"), "W"),
    row(&["RTOR"], Op::Tagged("RTOR"), "W"),
    row(&["SCP"], Op::Scp, "vvvvvV"),
    row(&["PID"], Op::Pid, "IvvVwwv"),
    row(&["CONCAT"], Op::Strings(Own::Concat), "xxX"),
    row(&["MID"], Op::Strings(Own::Mid), "xvvX"),
    row(&["DELETE"], Op::Strings(Own::Delete), "xvvX"),
    row(&["INSERT"], Op::Strings(Own::Insert), "xxvX"),
    row(&["FIND"], Op::Strings(Own::Find), "xxvV"),
    row(&["DTOS"], Op::ToText, "vX"),
    row(&["STOD", "STOR"], Op::FromText, "xV"),
];

/// The rows by the names in capitals.
static BY_NAME: LazyLock<HashMap<&str, &Row>> = LazyLock::new(|| {
    let named = |row: &'static Row| row.0.iter().map(move |name| (*name, row));
    ROWS.iter().flat_map(named).collect()
});

fn row_of(name: &str) -> Option<&'static Row> {
    let found = BY_NAME.get(name).copied();
    found.or_else(|| BY_NAME.get(name.to_ascii_uppercase().as_str()).copied())
}

/// The instruction of a name, with this many operands. None: it has no counterpart, or not with so many.
pub(crate) fn instruction(name: &str, operands: usize) -> Option<Op> {
    let (_, op, own, in_ascii) = row_of(name)?;
    let any = matches!(op, Op::Jsr | Op::Sbr | Op::Ret | Op::Pid);
    let fits = any || own.len() == operands || in_ascii.is_some_and(|own| own.len() == operands);
    fits.then_some(*op)
}

/// Whether there is such an instruction at all.
pub(crate) fn is_known(name: &str) -> bool {
    row_of(name).is_some()
}

/// Instructions of RSLogix 500 without a counterpart, and how many operands they have.
const WITHOUT: &[(&str, usize)] = &[
    ("DDV", 2),
    ("DCD", 2),
    ("ENC", 2),
    ("SUS", 1),
    ("REF", 0),
    ("SVC", 0),
];

/// How many operands an instruction has in the text of RSLogix 500.
pub(crate) fn operands_in_ascii(name: &str) -> Option<usize> {
    match row_of(name) {
        Some((_, _, own, in_ascii)) => Some(in_ascii.unwrap_or(own).len()),
        None => WITHOUT
            .iter()
            .find(|(own, _)| *own == name)
            .map(|(_, count)| *count),
    }
}

/// The letters of an instruction with this many operands.
fn letters(name: &str, operands: usize) -> &'static str {
    row_of(name).map_or("", |(_, _, own, in_ascii)| {
        in_ascii.filter(|own| own.len() == operands).unwrap_or(own)
    })
}

/// Whether an instruction with this many operands writes one of them.
pub(crate) fn is_written(name: &str, operands: usize, index: usize) -> bool {
    let letter = letters(name, operands).as_bytes().get(index);
    letter.is_some_and(u8::is_ascii_uppercase)
}

/// What an operand is, of an instruction with this many.
pub(crate) fn role(name: &str, operands: usize, index: usize) -> Option<Role> {
    let (_, op, ..) = row_of(name)?;
    let letter = letters(name, operands).as_bytes().get(index);
    Some(match letter.map(u8::to_ascii_lowercase) {
        Some(b'b') => Role::Bit,
        Some(b'v') => Role::Value,
        Some(b't') => Role::Timer,
        Some(b'c') => Role::Counter,
        Some(b'r') => Role::Control,
        Some(b's') => Role::State,
        Some(b'a') => Role::Array,
        Some(b'f') => Role::Formula,
        Some(b'p') => Role::Preset,
        Some(b'x') => Role::Text,
        None if matches!(op, Op::Sbr | Op::Ret) => Role::Value,
        None if *op == Op::Jsr && index > 0 => Role::Value,
        _ => Role::Word,
    })
}
