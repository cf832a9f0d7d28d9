//! What LDmicro's fork has next to LDmicro 2.2: elements of its own, and other fields of the old ones.
//!
//! ```text
//! line --read--> Read: an instruction, or a block that the program brings along (made)
//! rungs --jumps--> labels, jumps and subprograms
//! ```

pub(super) mod jumps;
pub(super) mod made;
pub(super) mod outside;
pub(super) mod table;

use super::field::{self, Coil, Slot};
use super::model::{Dialect, Version};
use ladder_instructions::Op;
use made::{Count, Kind, Made, MadeCounter, MadeTimer, Segments};
use outside::Outside;
use table::Form;

/// An element of the fork.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Read<'l> {
    pub(super) what: What,
    pub(super) given: Vec<Given<'l>>,
    /// Why it is not quite the same here.
    pub(super) remark: Option<&'static str>,
    /// The value that what it changes begins with.
    pub(super) initial: Option<i64>,
}

/// What an element becomes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum What {
    Instruction(Op),
    Made(Made),
    /// What is not read, with its fields.
    Outside(Outside),
}

/// What is in an operand's place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Given<'l> {
    /// A variable that is written.
    Place(&'l str),
    /// A variable or a literal.
    Value(&'l str),
    /// A number of scans.
    Scans(i64),
    /// A bit of LDmicro's.
    Relay(&'l str),
    /// One bit of a variable.
    Bit(&'l str, u8),
    /// An output of pulses, by its name.
    Pulses(&'l str),
    /// All fields of an element that is not read.
    Fields(&'l str),
}

impl<'l> Read<'l> {
    fn new(what: What, given: Vec<Given<'l>>) -> Read<'l> {
        Read {
            what,
            given,
            remark: None,
            initial: None,
        }
    }

    /// The counter that it is, and where that begins.
    pub(super) fn counter(&self) -> Option<(&'l str, String)> {
        let What::Made(Made::Counter(_)) = self.what else {
            return None;
        };
        let Given::Place(name) = self.given.first()? else {
            return None;
        };
        let init = match (self.initial, self.given.get(2)) {
            (Some(number), _) => number.to_string(),
            (None, Some(Given::Value(variable))) => (*variable).to_owned(),
            _ => return None,
        };
        Some((name, init))
    }
}

/// An element as the fork has it; none for what LDmicro 2.2 has too. The error says why there is nothing like it here.
pub(super) fn read(text: &str, dialect: Dialect) -> Option<Result<Read<'_>, String>> {
    let fields = field::fields(text);
    if let Some(row) = table::row_of(text) {
        return match row.form {
            Form::Outside(_) => outside(text),
            form => Some(own(form, &fields, dialect)),
        };
    }
    let is_forks = |plain: usize| dialect.version == Version::V02 || fields.len() > plain;
    match text.split(' ').next()? {
        "TON" if !is_number(fields.get(1)?) => Some(timer(MadeTimer::On, &fields, dialect)),
        "TOF" if !is_number(fields.get(1)?) => Some(Err(
            "LDmicro's fork works out from its delay what it begins with, and stops where that is a variable"
                .to_owned(),
        )),
        "RTO" if !is_number(fields.get(1)?) => Some(Err(NUMBER_ONLY.to_owned())),
        word @ ("CTU" | "CTD" | "CTC") if is_forks(2) => Some(counter(Count::of(word)?, &fields)),
        "COIL"
            if Coil::of(&fields) == Coil::Plain && fields.get(4).is_some_and(|toggles| *toggles != "0") =>
        {
            let given = vec![Given::Relay(fields[0])];
            Some(Ok(Read::new(What::Made(Made::Toggle), given)))
        }
        "UART_SEND" | "UART_RECV" if is_more_than_a_byte(text, &fields) => outside(text),
        "SET_PWM" if field::literal(fields.get(1)?).is_none() => outside(text),
        "SET_PWM" if is_forks(2) && fields.len() > 2 => Some(Ok(pulses(&fields))),
        _ => None,
    }
}

/// An element that is not read.
pub(super) fn outside(text: &str) -> Option<Result<Read<'_>, String>> {
    let (word, fields) = text.split_once(' ').unwrap_or((text, ""));
    let what = What::Outside(Outside::of(word)?);
    Some(Ok(Read::new(what, vec![Given::Fields(fields)])))
}

/// How finely a duty is given, where it is in percent.
pub(super) const RESOLUTION: &str = "0-100%";

/// Whether it sends or takes several bytes, or waits within the cycle until the line is free.
fn is_more_than_a_byte(text: &str, fields: &[&str]) -> bool {
    let waits = text.starts_with("UART_SEND") && fields.get(2).is_some_and(|waits| *waits != "0");
    waits || fields.get(1).is_some_and(|bytes| *bytes != "1")
}

/// `SET_PWM duty frequency P1 resolution`
fn pulses<'l>(fields: &[&'l str]) -> Read<'l> {
    let given = vec![
        Given::Value(fields[0]),
        Given::Value(fields[1]),
        Given::Pulses(fields[2]),
    ];
    let mut read = Read::new(What::Instruction(Op::Pwm), given);
    if fields.get(3).is_some_and(|resolution| *resolution != RESOLUTION) {
        read.remark = Some("its duty is not in percent in LDmicro; here it is");
    }
    read
}

/// Why a delay that is a variable has no counterpart.
const NUMBER_ONLY: &str = "its delay is not a number, and LDmicro's fork takes nothing else here";

fn is_number(field: &str) -> bool {
    field.bytes().all(|byte| byte.is_ascii_digit())
}

fn own<'l>(form: Form, fields: &[&'l str], dialect: Dialect) -> Result<Read<'l>, String> {
    match form {
        Form::Values(op, slots) => Ok(Read::new(What::Instruction(op), given(fields, slots)?)),
        Form::Bits(op) => {
            let given = given(fields, &[Slot::Place, Slot::Value, Slot::Value])?;
            let mut read = Read::new(What::Instruction(op), given);
            read.remark = shifted(fields[2])?;
            Ok(read)
        }
        Form::OneBit(op) => {
            if field::is_literal(fields[0]) {
                return Err(format!("{} is a number and has no bits to change", fields[0]));
            }
            if !field::is_literal(fields[1]) {
                let (made, slots) = Made::of_bit(op).ok_or("which bit it is, is a variable")?;
                return Ok(Read::new(What::Made(made), given(fields, slots)?));
            }
            let bit = field::literal(fields[1]).ok_or("which bit it is, is no number")?;
            let bit = u8::try_from(bit).ok().filter(|bit| *bit < 16);
            let bit = bit.ok_or_else(|| format!("bit {} is outside of 16 bits", fields[1]))?;
            Ok(Read::new(What::Instruction(op), vec![Given::Bit(fields[0], bit)]))
        }
        Form::Made(made, slots) => {
            let mut read = Read::new(What::Made(made), given(fields, slots)?);
            read.remark = match made {
                Made::ShiftRight => {
                    shifted(fields[2])?;
                    Some("that the sign of a number below 0 stays is what SR0 next to it suggests")
                }
                Made::ToBcd | Made::FromBcd => {
                    Some("its digits are a byte each in LDmicro, and 16 bits hold two of them")
                }
                _ => None,
            };
            Ok(read)
        }
        Form::Timer(word) => timer(word, fields, dialect),
        Form::Counter => counter(Count::Reverse, fields),
        Form::Count => {
            let scans = scans(fields, dialect)?;
            let given = vec![place(fields[0])?, Given::Scans(scans)];
            Ok(Read::new(What::Made(Made::TimeToCount), given))
        }
        Form::Segments => segments(fields),
        Form::Jump(_) => Err("it must be in a rung".to_owned()),
        Form::Outside(_) => Err("it is not read".to_owned()),
    }
}

fn given<'l>(fields: &[&'l str], slots: &[Slot]) -> Result<Vec<Given<'l>>, String> {
    let given = fields.iter().zip(slots).map(|(field, slot)| match slot {
        Slot::Place => place(field),
        Slot::Value | Slot::Number => Ok(Given::Value(field)),
    });
    given.collect()
}

fn place(field: &str) -> Result<Given<'_>, String> {
    if field::is_literal(field) {
        return Err(format!("{field} is a number and cannot be written"));
    }
    Ok(Given::Place(field))
}

/// `7SEGMENTS dest src common`, whose last field is `C` or `A`.
fn segments<'l>(fields: &[&'l str]) -> Result<Read<'l>, String> {
    let fixed = field::is_literal(fields[1]);
    let anode = if fixed {
        fields[2].starts_with('A')
    } else {
        !fields[2].starts_with('C')
    };
    let character = if fixed {
        Given::Value(fields[1])
    } else {
        Given::Place(fields[1])
    };
    let made = Made::Segments(Segments { anode, fixed });
    Ok(Read::new(What::Made(made), vec![place(fields[0])?, character]))
}

/// By how many bits something is shifted.
fn shifted(count: &str) -> Result<Option<&'static str>, String> {
    match field::literal(count) {
        Some(0..=16) => Ok(None),
        Some(count) => Err(format!(
            "{count} is not a number of bits to shift 16 bits by: 0 to 16"
        )),
        None if field::is_literal(count) => Err("its literal is not a number".to_owned()),
        None => Ok(Some("where the number of bits is below 0, there is a fault here")),
    }
}

/// `TCY name delay adjust`
fn timer<'l>(timer: MadeTimer, fields: &[&'l str], dialect: Dialect) -> Result<Read<'l>, String> {
    let period = if is_number(fields[1]) {
        Given::Scans(scans(fields, dialect)?)
    } else if timer == MadeTimer::RetentiveLow {
        return Err(NUMBER_ONLY.to_owned());
    } else if field::is_literal(fields[1]) {
        return Err("its delay is not a number".to_owned());
    } else {
        Given::Value(fields[1])
    };
    let given = vec![Given::Place(fields[0]), period];
    Ok(Read::new(What::Made(Made::Timer(timer)), given))
}

/// How many scans the delay in `name delay adjust` is.
fn scans(fields: &[&str], dialect: Dialect) -> Result<i64, String> {
    let adjust = fields.get(2).copied().unwrap_or("0");
    let adjust: i64 = adjust.parse().map_err(|_| "its last field is not a number")?;
    if !is_number(fields[1]) {
        return Err("its delay is not a number".to_owned());
    }
    let delay: u64 = fields[1].parse().map_err(|_| "its delay is too long")?;
    let scans = i64::try_from(delay / dialect.cycle).unwrap_or(i64::MAX);
    let scans = scans.saturating_add(adjust);
    if !(1..=32_767).contains(&scans) {
        return Err(format!("its delay is {scans} cycles: 1 to 32767 are possible"));
    }
    Ok(scans)
}

/// `CTU name max init kind`
fn counter<'l>(count: Count, fields: &[&'l str]) -> Result<Read<'l>, String> {
    let kind = fields.get(3).copied().unwrap_or("/");
    let kind = Kind::of(kind).ok_or("its last field is none of `/`, `\\`, `-` and `o`")?;
    let init = fields.get(2).copied().unwrap_or("0");
    let from_variable = !field::is_literal(init);
    let number = |field: &str| {
        let number = field::literal(field).ok_or("its limit or first value is not a number")?;
        if field::wrapped(number) != number {
            return Err(format!("{number} does not fit 16 bits"));
        }
        Ok(number)
    };
    let initial = (!from_variable).then(|| number(init)).transpose()?;
    if field::is_literal(fields[1]) {
        number(fields[1])?;
    }
    let mut given = vec![Given::Place(fields[0]), Given::Value(fields[1])];
    if from_variable || count.returns() {
        given.push(Given::Value(init));
    }
    let made = Made::Counter(MadeCounter {
        count,
        kind,
        from_variable,
    });
    let mut read = Read::new(What::Made(made), given);
    read.initial = initial;
    Ok(read)
}

/// The line that says the same in the plainest way. None if there is nothing like it here.
pub(super) fn plain(text: &str, read: &Read<'_>, dialect: Dialect) -> Option<String> {
    let mut words = Vec::with_capacity(read.given.len());
    for given in &read.given {
        words.push(match given {
            Given::Value(field) if field::is_literal(field) => {
                field::wrapped(field::literal(field)?).to_string()
            }
            Given::Place(name) | Given::Value(name) | Given::Relay(name) | Given::Fields(name) => {
                (*name).to_owned()
            }
            Given::Scans(scans) => scans.to_string(),
            Given::Bit(name, bit) => format!("{name} {bit}"),
            Given::Pulses(name) => format!("{name} {RESOLUTION}"),
        });
    }
    Some(match read.what {
        What::Made(made) => made.line(&words, read.initial.unwrap_or(0), dialect),
        What::Outside(_) => text.to_owned(),
        What::Instruction(_) => {
            let word = text.split(' ').next()?;
            [&[word.to_owned()][..], &words[..]].concat().join(" ")
        }
    })
}
