//! The instructions that have a counterpart here, by all their names, and what their operands are. What the translation,
//! the types of undeclared tags and the reader of RSLogix 500's text know of an instruction is in this table.

use std::collections::HashMap;
use std::sync::LazyLock;

/// An instruction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Op {
    Xic,
    Xio,
    Ote,
    Otl,
    Otu,
    Ons,
    Osr,
    Osf,
    Timer(&'static str),
    Counter(&'static str),
    Res,
    Compare(&'static str),
    Lim,
    Meq,
    Cmp,
    /// An operator between two values.
    Binary(&'static str),
    /// A function of one value, or a sign before it.
    Unary(&'static str),
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
    Jmp,
    Lbl,
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
    /// A function of strings: its name here.
    Strings(&'static str),
    /// A number as text, and back.
    ToText,
    FromText,
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
/// A letter is an operand, see [`role`].
type Row = (&'static [&'static str], Op, &'static str, Option<&'static str>);

const fn row(names: &'static [&'static str], op: Op, operands: &'static str) -> Row {
    (names, op, operands, None)
}

const ROWS: &[Row] = &[
    row(&["XIC"], Op::Xic, "b"),
    row(&["XIO"], Op::Xio, "b"),
    row(&["OTE", "EOT"], Op::Ote, "b"),
    row(&["OTL"], Op::Otl, "b"),
    row(&["OTU"], Op::Otu, "b"),
    row(&["ONS"], Op::Ons, "b"),
    (&["OSR"], Op::Osr, "bb", Some("b")),
    row(&["OSF"], Op::Osf, "bb"),
    (&["TON"], Op::Timer("TON"), "tpp", Some("twpp")),
    (&["TOF"], Op::Timer("TOF"), "tpp", Some("twpp")),
    (&["RTO"], Op::Timer("RTO"), "tpp", Some("twpp")),
    row(&["CTU"], Op::Counter("CTU"), "cpp"),
    row(&["CTD"], Op::Counter("CTD"), "cpp"),
    row(&["RES"], Op::Res, "s"),
    row(&["EQU", "EQ"], Op::Compare("EQ"), "vv"),
    row(&["NEQ", "NE"], Op::Compare("NE"), "vv"),
    row(&["LES", "LT"], Op::Compare("LT"), "vv"),
    row(&["LEQ", "LE"], Op::Compare("LE"), "vv"),
    row(&["GRT", "GT"], Op::Compare("GT"), "vv"),
    row(&["GEQ", "GE"], Op::Compare("GE"), "vv"),
    row(&["LIM", "LIMIT"], Op::Lim, "vvv"),
    row(&["MEQ"], Op::Meq, "vvv"),
    row(&["CMP"], Op::Cmp, "f"),
    row(&["ADD"], Op::Binary("+"), "vvv"),
    row(&["SUB"], Op::Binary("-"), "vvv"),
    row(&["MUL"], Op::Binary("*"), "vvv"),
    row(&["DIV"], Op::Binary("/"), "vvv"),
    row(&["MOD"], Op::Binary("MOD"), "vvv"),
    row(&["XPY", "EXPT"], Op::Binary("**"), "vvv"),
    row(&["AND"], Op::Binary("AND"), "vvv"),
    row(&["OR"], Op::Binary("OR"), "vvv"),
    row(&["XOR"], Op::Binary("XOR"), "vvv"),
    row(&["NOT"], Op::Unary("NOT"), "vv"),
    row(&["NEG"], Op::Unary("-"), "vv"),
    row(&["ABS"], Op::Unary("ABS"), "vv"),
    row(&["SQR", "SQRT"], Op::Unary("SQRT"), "vv"),
    row(&["SIN"], Op::Unary("SIN"), "vv"),
    row(&["COS"], Op::Unary("COS"), "vv"),
    row(&["TAN"], Op::Unary("TAN"), "vv"),
    row(&["ASN", "ASIN"], Op::Unary("ASIN"), "vv"),
    row(&["ACS", "ACOS"], Op::Unary("ACOS"), "vv"),
    row(&["ATN", "ATAN"], Op::Unary("ATAN"), "vv"),
    row(&["ATAN2"], Op::Atan2, "vvv"),
    row(&["LN"], Op::Unary("LN"), "vv"),
    row(&["LOG"], Op::Unary("LOG"), "vv"),
    row(&["DEG"], Op::Unary("DEG"), "vv"),
    row(&["RAD"], Op::Unary("RAD"), "vv"),
    row(&["TRN", "TRUNC"], Op::Trunc, "vv"),
    row(&["CPT"], Op::Cpt, "vf"),
    row(&["MOV", "MOVE"], Op::Mov, "vv"),
    row(&["MVM"], Op::Mvm, "vvv"),
    row(&["BTD"], Op::Btd, "vwvww"),
    row(&["CLR"], Op::Clr, "v"),
    row(&["COP", "CPS"], Op::Cop, "aaw"),
    row(&["FLL"], Op::Fll, "vaw"),
    row(&["BSL"], Op::Shift("BSL"), "arbp"),
    row(&["BSR"], Op::Shift("BSR"), "arbp"),
    row(&["FFL"], Op::Load("FFL"), "varpp"),
    row(&["LFL"], Op::Load("LFL"), "varpp"),
    row(&["FFU"], Op::Unload("FFU"), "avrpp"),
    row(&["LFU"], Op::Unload("LFU"), "avrpp"),
    row(&["SQI", "SQC"], Op::Sqi, "avvrpp"),
    row(&["SQO"], Op::Sqo, "avvrpp"),
    row(&["SQL"], Op::Sql, "avrpp"),
    row(&["FAL"], Op::Fal, "rppwvf"),
    row(&["FSC"], Op::Fsc, "rppwf"),
    row(&["AVE"], Op::Statistic("AVE"), "awvrpp"),
    row(&["STD"], Op::Statistic("STD"), "awvrpp"),
    row(&["SRT"], Op::Srt, "awrpp"),
    row(&["SIZE"], Op::Size, "awv"),
    row(&["SWPB"], Op::Swpb, "vwv"),
    row(&["TOD", "TO_BCD"], Op::ToBcd, "vv"),
    row(&["FRD", "BCD_TO"], Op::FromBcd, "vv"),
    row(&["FOR"], Op::For, "wvvvv"),
    row(&["BRK"], Op::Brk, ""),
    row(&["JMP"], Op::Jmp, "w"),
    row(&["LBL"], Op::Lbl, "w"),
    (&["JSR"], Op::Jsr, "w", Some("w")),
    (&["SBR"], Op::Sbr, "", Some("")),
    (&["RET"], Op::Ret, "", Some("")),
    row(&["MCR"], Op::Mcr, ""),
    row(&["AFI"], Op::Afi, ""),
    row(&["NOP"], Op::Nop, ""),
    row(&["TND", "END"], Op::Tnd, ""),
    row(&["SCL"], Op::Scl, "vvvv"),
    row(&["SCP"], Op::Scp, "vvvvvv"),
    row(&["PID"], Op::Pid, "ivvvwwv"),
    row(&["CONCAT"], Op::Strings("CONCAT"), "$$$"),
    row(&["MID"], Op::Strings("MID"), "$vv$"),
    row(&["DELETE"], Op::Strings("DELETE"), "$vv$"),
    row(&["INSERT"], Op::Strings("INSERT"), "$$v$"),
    row(&["FIND"], Op::Strings("FIND"), "$$vv"),
    row(&["DTOS"], Op::ToText, "v$"),
    row(&["STOD", "STOR"], Op::FromText, "$v"),
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

/// What an operand is, of an instruction with this many.
pub(crate) fn role(name: &str, operands: usize, index: usize) -> Option<Role> {
    let (_, op, own, in_ascii) = row_of(name)?;
    let own = in_ascii.filter(|own| own.len() == operands).unwrap_or(own);
    Some(match own.as_bytes().get(index) {
        Some(b'b') => Role::Bit,
        Some(b'v') => Role::Value,
        Some(b't') => Role::Timer,
        Some(b'c') => Role::Counter,
        Some(b'r') => Role::Control,
        Some(b's') => Role::State,
        Some(b'a') => Role::Array,
        Some(b'f') => Role::Formula,
        Some(b'p') => Role::Preset,
        Some(b'$') => Role::Text,
        None if matches!(op, Op::Sbr | Op::Ret) => Role::Value,
        None if *op == Op::Jsr && index > 0 => Role::Value,
        _ => Role::Word,
    })
}
