//! The elements of LDmicro 2.2, each next to the instruction that says the same. Import, export and checks read this
//! table. What its fork has next to them is in [`fork`].

use super::field::{Coil, Slot, fields, is_literal, literal, wrapped};
use super::fork;
use super::model::{Dialect, Version};
use ladder_instructions::Op;

/// An element: the word that its line begins with, and what it is.
#[derive(Debug, Clone, Copy)]
pub(super) struct Row {
    pub(super) word: &'static str,
    pub(super) form: Form,
    /// LDmicro's editor lets nothing are to its right.
    pub(super) ends_rung: bool,
}

/// What an element's fields are, and which instruction it becomes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    /// Fields as they come, each an operand of the instruction.
    Values(Op, &'static [Slot]),
    /// `CONTACTS name negated`
    Contact,
    /// `COIL name negated set reset`
    Coil,
    /// A contact that is always on or off.
    Constant(bool),
    /// `TON name delay`
    Timer(Op),
    /// `CTU name max`
    Counter(Op),
    /// `RES name`
    Reset,
    /// `READ_ADC name`
    Adc,
    /// `SHIFT_REGISTER name stages`
    Shift,
    /// `LOOK_UP_TABLE dest index count editAsString v0 ..`
    Table,
    /// `PIECEWISE_LINEAR dest index count x0 y0 ..`
    Curve,
    /// `FORMATTED_STRING var length c0 ..`
    Text,
    /// `COMMENT text`
    Comment,
    /// An empty rung.
    Placeholder,
}

const fn row(word: &'static str, form: Form) -> Row {
    Row {
        word,
        form,
        ends_rung: false,
    }
}

const fn last(word: &'static str, form: Form) -> Row {
    Row {
        word,
        form,
        ends_rung: true,
    }
}

const MATH: &[Slot] = &[Slot::Place, Slot::Value, Slot::Value];
const COMPARE: &[Slot] = &[Slot::Value, Slot::Value];

/// All that LDmicro 2.2 knows.
pub(super) const ROWS: &[Row] = &[
    row("PLACEHOLDER", Form::Placeholder),
    row("COMMENT", Form::Comment),
    row("CONTACTS", Form::Contact),
    last("COIL", Form::Coil),
    row("TON", Form::Timer(Op::Ton)),
    row("TOF", Form::Timer(Op::Tof)),
    row("RTO", Form::Timer(Op::Rto)),
    last("RES", Form::Reset),
    row("CTU", Form::Counter(Op::Ctu)),
    row("CTD", Form::Counter(Op::Ctd)),
    last("CTC", Form::Counter(Op::Ctc)),
    row("OSR", Form::Values(Op::OneShotRising, &[])),
    row("OSF", Form::Values(Op::OneShotFalling, &[])),
    row("OPEN", Form::Constant(false)),
    row("SHORT", Form::Constant(true)),
    last("MASTER_RELAY", Form::Values(Op::Mcr, &[])),
    last("MOVE", Form::Values(Op::Mov, &[Slot::Place, Slot::Value])),
    last("ADD", Form::Values(Op::Add, MATH)),
    last("SUB", Form::Values(Op::Sub, MATH)),
    last("MUL", Form::Values(Op::Mul, MATH)),
    last("DIV", Form::Values(Op::Div, MATH)),
    row("EQU", Form::Values(Op::Eq, COMPARE)),
    row("NEQ", Form::Values(Op::Ne, COMPARE)),
    row("GRT", Form::Values(Op::Gt, COMPARE)),
    row("GEQ", Form::Values(Op::Ge, COMPARE)),
    row("LES", Form::Values(Op::Lt, COMPARE)),
    row("LEQ", Form::Values(Op::Le, COMPARE)),
    last("SHIFT_REGISTER", Form::Shift),
    last("LOOK_UP_TABLE", Form::Table),
    last("PIECEWISE_LINEAR", Form::Curve),
    row("FORMATTED_STRING", Form::Text),
    row("UART_SEND", Form::Values(Op::Usnd, &[Slot::Value])),
    row("UART_RECV", Form::Values(Op::Urcv, &[Slot::Place])),
    last("READ_ADC", Form::Adc),
    last("SET_PWM", Form::Values(Op::Pwm, &[Slot::Value, Slot::Number])),
    last("PERSIST", Form::Values(Op::Persist, &[Slot::Place])),
];

/// The row of a line.
pub(super) fn row_of(text: &str) -> Option<&'static Row> {
    let word = text.split(' ').next()?;
    ROWS.iter().find(|row| row.word == word)
}

/// A line with one blank between its fields. The text of a comment stays.
pub(super) fn normal_blanks(line: &str) -> String {
    let is_text = |word: &str| word == "COMMENT" || word == "STRING";
    match line.split_once([' ', '\t']) {
        Some((word, text)) if is_text(word) => format!("{word} {}", text.trim()),
        _ => line.split_whitespace().collect::<Vec<_>>().join(" "),
    }
}

/// Whether LDmicro or its fork has such an element, with enough fields.
pub(super) fn check(text: &str) -> Result<(), String> {
    let word = text.split(' ').next().unwrap_or_default();
    let Some(row) = row_of(text) else {
        if let Some(row) = fork::table::row_of(text) {
            let least = row.least();
            if fields(text).len() < least {
                return Err(format!("`{word}` has {least} fields or more"));
            }
            return Ok(());
        }
        let word: String = word.chars().take(40).collect();
        return Err(format!("LDmicro has no element `{word}`"));
    };
    let (least, names) = match row.form {
        Form::Values(_, slots) => (slots.len(), "its operands"),
        Form::Contact => (2, "a name and 0 or 1"),
        Form::Coil => (4, "a name and three times 0 or 1"),
        Form::Timer(_) => (2, "a name and a delay"),
        Form::Counter(_) => (2, "a name and a limit"),
        Form::Reset | Form::Adc => (1, "a name"),
        Form::Shift => (2, "a name and the number of stages"),
        Form::Table => (
            4,
            "a result, an index, the number of values, 0 or 1, and the values",
        ),
        Form::Curve => (3, "a result, an input, the number of points, and the points"),
        Form::Text => (2, "a variable or `(none)`, a length, and the characters"),
        Form::Comment | Form::Placeholder | Form::Constant(_) => (0, ""),
    };
    if fields(text).len() < least {
        return Err(format!("`{word}` has {least} fields or more: {names}"));
    }
    Ok(())
}

/// The line that says the same in the plainest way: what export writes. None if it has no counterpart.
pub(super) fn plain(text: &str, dialect: Dialect) -> Option<String> {
    if let Some(read) = fork::read(text, dialect) {
        return fork::plain(text, &read.ok()?, dialect);
    }
    let row = row_of(text)?;
    let fields = fields(text);
    let fork = |line: String, more: &str| match dialect.version {
        Version::V01 => line,
        Version::V02 => line + more,
    };
    let operand = |text: &str| {
        if !is_literal(text) {
            return Some(text.to_owned());
        }
        literal(text).map(|number| wrapped(number).to_string())
    };
    Some(match row.form {
        Form::Values(_, slots) => {
            let mut line = row.word.to_owned();
            for (field, _) in fields.iter().zip(slots) {
                line.push(' ');
                line.push_str(&operand(field)?);
            }
            match row.form {
                Form::Values(Op::Usnd | Op::Urcv, _) => fork(line, " 1 0"),
                _ => line,
            }
        }
        Form::Contact => fork(format!("CONTACTS {} {}", fields[0], flag(fields[1])), " 0"),
        Form::Coil => fork(coil(fields[0], Coil::of(&fields)), " 0"),
        Form::Timer(_) => timer(row.word, fields[0], preset(&fields, dialect)?, dialect),
        Form::Counter(_) => format!("{} {} {}", row.word, fields[0], literal(fields[1])?),
        Form::Reset => format!("RES {}", fields[0]),
        Form::Adc => fork(format!("READ_ADC {}", fields[0]), " 0"),
        Form::Shift => format!("{} {} {}", row.word, fields[0], fields[1].parse::<u32>().ok()?),
        Form::Table => {
            let values = numbers(values(&fields, row.form))?;
            table(fields[0], &operand(fields[1])?, &values)
        }
        Form::Curve => {
            let values = numbers(values(&fields, row.form))?;
            curve(fields[0], &operand(fields[1])?, &values)
        }
        Form::Text => {
            let text = super::text::read(&fields)?;
            super::text::line(fields[0], &text)
        }
        Form::Constant(_) | Form::Placeholder => row.word.to_owned(),
        Form::Comment => return None,
    })
}

/// The values of a table or curve, without the name that the fork gives it.
pub(super) fn values<'f, 'l>(fields: &'f [&'l str], form: Form) -> &'f [&'l str] {
    let (first, each) = if form == Form::Table { (4, 1) } else { (3, 2) };
    let values = fields.get(first..).unwrap_or_default();
    let count = fields.get(2).and_then(|count| count.parse::<usize>().ok());
    match values.split_last() {
        Some((name, others))
            if !is_literal(name) || count.and_then(|count| count.checked_mul(each)) == Some(others.len()) =>
        {
            others
        }
        _ => values,
    }
}

/// The delay of a timer as `[TON]` has it, in microseconds: the timer counts as many cycles as go into it, less one. The
/// fork adds its last field to the cycles that go into the delay. None if that is nothing, or too long.
pub(super) fn preset(fields: &[&str], dialect: Dialect) -> Option<u64> {
    const LONGEST: i128 = 1 << 53;
    let adjust: i64 = match (fields.get(2), dialect.version) {
        (Some(adjust), _) => adjust.parse().ok()?,
        (None, Version::V01) => -1,
        (None, Version::V02) => 0,
    };
    let delay: u64 = fields[1].parse().ok()?;
    let preset = i128::from(delay) + (i128::from(adjust) + 1) * i128::from(dialect.cycle);
    u64::try_from(preset)
        .ok()
        .filter(|_| (1..=LONGEST).contains(&preset))
}

/// The line of a timer.
pub(super) fn timer(word: &str, name: &str, preset: u64, dialect: Dialect) -> String {
    match (dialect.version, preset.checked_sub(dialect.cycle)) {
        (Version::V01, _) => format!("{word} {name} {preset}"),
        (Version::V02, Some(delay)) if delay > 0 => format!("{word} {name} {delay} 0"),
        (Version::V02, _) => format!("{word} {name} {preset} -1"),
    }
}

fn flag(field: &str) -> u8 {
    u8::from(field != "0")
}

/// All of them as numbers.
pub(super) fn numbers(fields: &[&str]) -> Option<Vec<i64>> {
    fields.iter().map(|field| literal(field)).collect()
}

pub(super) fn table(to: &str, index: &str, values: &[i64]) -> String {
    let mut line = format!("LOOK_UP_TABLE {to} {index} {} 0", values.len());
    for value in values {
        line.push_str(&format!(" {value}"));
    }
    line
}

pub(super) fn curve(to: &str, input: &str, points: &[i64]) -> String {
    let mut line = format!("PIECEWISE_LINEAR {to} {input} {}", points.len() / 2);
    for value in points {
        line.push_str(&format!(" {value}"));
    }
    line
}

pub(super) fn coil(name: &str, coil: Coil) -> String {
    let flags = match coil {
        Coil::Plain => "0 0 0",
        Coil::Negated => "1 0 0",
        Coil::Set => "0 1 0",
        Coil::Reset => "0 0 1",
    };
    format!("COIL {name} {flags}")
}
