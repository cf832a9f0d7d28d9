//! From the outputs of column AF to instructions, and the pins that go with them.

use super::super::address::{Address, Span, Tag};
use super::super::bank::Bank;
use super::super::conversion::Convert;
use super::super::model::{
    Bits, Coil, Condition, Constant, CopyOptions, Counter, CounterKind, Instruction, Math, MathKind, Operand,
    Relation, Search, Shift, Timer, TimerKind, Unit,
};
use super::contact;
use super::operand::{constant, operand, span, tag};
use super::token::Token;

/// An instruction, and whether it acts only on the scan in which the power comes.
#[derive(Debug)]
pub(super) struct Read {
    pub(super) what: Instruction,
    pub(super) oneshot: bool,
}

/// An output that is not a pin.
///
/// # Errors
///
/// Why ladder text has no counterpart for it.
pub(super) fn read(text: &str) -> Result<Read, String> {
    if text == "NOP" {
        return Ok(Read {
            what: Instruction::Nop,
            oneshot: false,
        });
    }
    let mut token = Token::read(text)?;
    let oneshot = token.switch("oneshot")?;
    let what = instruction(&mut token)?;
    match token.named.first() {
        Some((name, _)) => Err(format!("`{}` has no `{name}` here", token.name)),
        None => Ok(Read { what, oneshot }),
    }
}

/// The names of the outputs that are known.
const OUTPUTS: [&str; 26] = [
    "out",
    "latch",
    "reset",
    "on_delay",
    "off_delay",
    "count_up",
    "count_down",
    "copy",
    "blockcopy",
    "fill",
    "pack_bits",
    "pack_words",
    "pack_text",
    "unpack_to_bits",
    "unpack_to_words",
    "shift",
    "search",
    "event_drum",
    "time_drum",
    "calc",
    "math",
    "call",
    "for",
    "next",
    "end",
    "return",
];

fn instruction(token: &mut Token<'_>) -> Result<Instruction, String> {
    let values = std::mem::take(&mut token.values);
    Ok(match (token.name, &values[..]) {
        ("out", [bits]) => Instruction::Out(coil(bits)?),
        ("latch", [bits]) => Instruction::Set(coil(bits)?),
        ("reset", [bits]) => Instruction::Reset(coil(bits)?),
        ("on_delay", [done, current]) => timer(TimerKind::On, done, current, token)?,
        ("off_delay", [done, current]) => timer(TimerKind::Off, done, current, token)?,
        ("count_up", [done, current]) => counter(CounterKind::Up, done, current, token)?,
        ("count_down", [done, current]) => counter(CounterKind::Down, done, current, token)?,
        ("copy", [source, target]) => Instruction::Copy {
            source: operand(source)?,
            target: place(target)?,
            options: options(token)?,
        },
        ("blockcopy", [source, target]) => block_copy(source, target, options(token)?)?,
        ("fill", [source, target]) => Instruction::Fill {
            source: operand(source)?,
            target: span(target)?,
            options: options(token)?,
        },
        ("pack_bits" | "pack_words" | "pack_text", [source, target]) => Instruction::Pack {
            source: span(source)?,
            target: tag(target)?,
            options: options(token)?,
        },
        ("unpack_to_bits" | "unpack_to_words", [source, target]) => Instruction::Unpack {
            source: tag(source)?,
            target: span(target)?,
            options: options(token)?,
        },
        ("shift", [bits]) => Instruction::Shift(Shift {
            bits: span(bits)?,
            clock: None,
            reset: None,
        }),
        ("search", [sought]) => {
            let (among, relation, value) = contact::split(sought).ok_or_else(|| {
                format!("`{sought}` does not say what is searched for: `DS1..DS9 >= 5` does")
            })?;
            let (result, flag) = (token.must("result")?, token.must("found")?);
            search((relation, value, among), result, flag, token)?
        }
        // Earlier exports have all by its place, and call formulas `calc`.
        ("search", [relation, value, among, result, flag]) => {
            let relation = relation.trim_matches('"');
            let relation =
                Relation::named(relation).ok_or_else(|| format!("`{relation}` is not a relation"))?;
            search((relation, value, among), result, flag, token)?
        }
        ("math" | "calc", [formula, target]) => {
            let kind = match token.take("mode") {
                None | Some("decimal") => MathKind::Decimal,
                Some("hex") => MathKind::Hex,
                Some(other) => return Err(format!("`mode` is decimal or hex, not `{other}`")),
            };
            Instruction::Math(Math {
                kind,
                formula: super::formula::read(formula)?,
                target: place(target)?,
            })
        }
        ("event_drum", []) => super::drum::read(token, false)?,
        ("time_drum", []) => super::drum::read(token, true)?,
        ("call", [name]) => match constant(name) {
            Some(Constant::Text(name)) => Instruction::Call(name),
            _ => return Err("`call` names a subroutine in quotes".to_owned()),
        },
        ("for", [count]) => Instruction::For(operand(count)?),
        ("next", []) => Instruction::Next,
        ("end", []) => Instruction::End,
        ("return", []) => Instruction::Return,
        (name, _) if OUTPUTS.contains(&name) => {
            return Err(format!("`{name}` has other values than these"));
        }
        (name, _) => return Err(format!("ladder text has no counterpart for `{name}`")),
    })
}

/// A value's place: an address, or what one points to.
fn place(text: &str) -> Result<Operand, String> {
    match operand(text)? {
        Operand::Constant(_) => Err(format!("`{text}` is a value and cannot be written")),
        place => Ok(place),
    }
}

fn coil(text: &str) -> Result<Coil, String> {
    let immediate = text
        .strip_prefix("immediate(")
        .and_then(|text| text.strip_suffix(')'));
    let bits = immediate.unwrap_or(text);
    let bits = if bits.contains("..") {
        Bits::Many(span(bits)?)
    } else {
        Bits::One(tag(bits)?)
    };
    Ok(Coil {
        bits,
        immediate: immediate.is_some(),
    })
}

/// The bit of a timer or counter. Its current value has the same number.
fn done(done: &str, current: &str, banks: (Bank, Bank)) -> Result<Tag, String> {
    let is_pair =
        |bit: Address, value: Address| (bit.bank, value.bank) == banks && bit.number == value.number;
    match (Address::parse(done), Address::parse(current)) {
        (Some(bit), Some(value)) if is_pair(bit, value) => contact::exists(bit),
        _ => Err(format!(
            "`{done}` and `{current}` are no pair like {}1 and {}1",
            banks.0.row().name,
            banks.1.row().name
        )),
    }
}

fn preset(token: &mut Token<'_>) -> Result<Operand, String> {
    operand(token.must("preset")?)
}

fn timer(kind: TimerKind, bit: &str, current: &str, token: &mut Token<'_>) -> Result<Instruction, String> {
    let unit = token.take("unit").unwrap_or("Tms");
    Ok(Instruction::Timer(Timer {
        kind,
        tag: done(bit, current, (Bank::T, Bank::Td))?,
        setpoint: preset(token)?,
        unit: Unit::named(unit)
            .ok_or_else(|| format!("`{unit}` is not a unit: Tms, Ts, Tm, Th and Td are"))?,
        reset: None,
    }))
}

fn counter(
    kind: CounterKind,
    bit: &str,
    current: &str,
    token: &mut Token<'_>,
) -> Result<Instruction, String> {
    Ok(Instruction::Counter(Counter {
        kind,
        tag: done(bit, current, (Bank::Ct, Bank::Ctd))?,
        setpoint: preset(token)?,
        count_down: None,
        reset: None,
    }))
}

fn options(token: &mut Token<'_>) -> Result<CopyOptions, String> {
    let convert = token.take("convert").map(convert).transpose()?;
    let allow_whitespace = token.switch("allow_whitespace")?;
    let named = std::mem::take(&mut token.named).into_iter();
    Ok(CopyOptions {
        convert,
        allow_whitespace,
        named: named
            .map(|(name, value)| (name.to_owned(), value.to_owned()))
            .collect(),
    })
}

/// `to_value`, `to_text(suppress_zero=1)`
pub(in super::super) fn convert(text: &str) -> Result<Convert, String> {
    let unknown =
        || format!("`{text}` is not a conversion: to_value, to_ascii, to_binary and to_text(..) are");
    let token = if text.contains('(') {
        Token::read(text)?
    } else {
        Token::named(text)
    };
    let mut convert = Convert::named(token.name).ok_or_else(unknown)?;
    if !token.values.is_empty() {
        return Err(unknown());
    }
    for (name, value) in token.named {
        convert.set(name, value)?;
    }
    Ok(convert)
}

/// The grid names both ranges whole.
fn block_copy(source: &str, target: &str, options: CopyOptions) -> Result<Instruction, String> {
    let (source, to): (Span, Span) = (span(source)?, span(target)?);
    if to.len() != source.len() && target.contains("..") {
        return Err(format!("{source} and {to} have not the same length"));
    }
    Ok(Instruction::BlockCopy {
        source,
        target: Tag::number(to.bank, to.first),
        options,
    })
}

fn search(
    (relation, value, among): (Relation, &str, &str),
    result: &str,
    flag: &str,
    token: &mut Token<'_>,
) -> Result<Instruction, String> {
    Ok(Instruction::Search(Search {
        relation,
        value: operand(value)?,
        among: span(among)?,
        result: tag(result)?,
        flag: tag(flag)?,
        continuous: token.switch("continuous")?,
    }))
}

/// Joins a pin to the output above it.
///
/// # Errors
///
/// Why it has no such pin.
pub(super) fn pin(what: &mut Instruction, text: &str, condition: Condition) -> Result<(), String> {
    let mut token = Token::read(text)?;
    let pin = match (what, token.name) {
        (Instruction::Drum(drum), ".jump") => {
            let step = token.values.pop().ok_or("`.jump(..)` says to which step")?;
            drum.jump_step = Some(operand(step)?);
            &mut drum.jump
        }
        (Instruction::Drum(drum), ".reset") => &mut drum.reset,
        (Instruction::Drum(drum), ".jog") => &mut drum.jog,
        (Instruction::Timer(timer), ".reset") => {
            timer.kind = match timer.kind {
                TimerKind::On | TimerKind::RetentiveOn => TimerKind::RetentiveOn,
                TimerKind::Off | TimerKind::RetentiveOff => TimerKind::RetentiveOff,
            };
            &mut timer.reset
        }
        (Instruction::Counter(counter), ".reset") => &mut counter.reset,
        (Instruction::Counter(counter), ".down") if counter.kind != CounterKind::Down => {
            counter.kind = CounterKind::UpDown;
            &mut counter.count_down
        }
        (Instruction::Shift(shift), ".clock") => &mut shift.clock,
        (Instruction::Shift(shift), ".reset") => &mut shift.reset,
        _ => return Err(format!("the output above `{text}` has no such pin here")),
    };
    if !token.values.is_empty() || !token.named.is_empty() {
        return Err(format!("`{}` takes no values here", token.name));
    }
    match pin.replace(condition) {
        None => Ok(()),
        Some(_) => Err(format!("the output has two pins `{}`", token.name)),
    }
}
