//! Instructions as outputs of column AF, with their pins.

use super::super::address::{Span, Tag};
use super::super::bank::{Bank, Kind};
use super::super::model::{
    Bits, Coil, Condition, CopyOptions, Counter, CounterKind, Instruction, Math, MathKind, Search, Shift,
    Timer, TimerKind,
};
use super::addresses::Addresses;
use super::operand::operand_text;
use super::token::Token;

/// An output and the pins below it, each with its condition.
pub(super) struct Written<'i> {
    pub(super) output: String,
    pub(super) pins: Vec<(String, &'i Condition)>,
}

/// An instruction as the grid writes it. None: it has an address by its nickname alone, or something that the grid
/// cannot say.
pub(super) fn write<'i>(what: &'i Instruction, oneshot: bool, addresses: &Addresses) -> Option<Written<'i>> {
    let mut pins: Vec<(&str, &Condition)> = Vec::new();
    let jump;
    let mut named: Vec<(String, String)> = Vec::new();
    let (name, values) = match what {
        Instruction::Out(coil) => ("out", vec![coil_text(coil, addresses)?]),
        Instruction::Set(coil) => ("latch", vec![coil_text(coil, addresses)?]),
        Instruction::Reset(coil) => ("reset", vec![coil_text(coil, addresses)?]),
        Instruction::Timer(Timer {
            kind,
            tag,
            setpoint,
            unit,
            reset,
        }) => {
            named.push(("preset".to_owned(), operand_text(setpoint, addresses)?));
            named.push(("unit".to_owned(), unit.name().to_owned()));
            pins.extend(reset.as_ref().map(|reset| (".reset()", reset)));
            let name = match kind {
                TimerKind::On | TimerKind::RetentiveOn => "on_delay",
                TimerKind::Off | TimerKind::RetentiveOff => "off_delay",
            };
            (name, pair(tag, Bank::Td, addresses)?)
        }
        Instruction::Counter(Counter {
            kind,
            tag,
            setpoint,
            count_down,
            reset,
        }) => {
            named.push(("preset".to_owned(), operand_text(setpoint, addresses)?));
            pins.extend(count_down.as_ref().map(|down| (".down()", down)));
            pins.extend(reset.as_ref().map(|reset| (".reset()", reset)));
            let name = match kind {
                CounterKind::Up | CounterKind::UpDown => "count_up",
                CounterKind::Down => "count_down",
            };
            (name, pair(tag, Bank::Ctd, addresses)?)
        }
        Instruction::Copy {
            source,
            target,
            options,
        } => {
            named.extend(option_list(options));
            (
                "copy",
                vec![operand_text(source, addresses)?, operand_text(target, addresses)?],
            )
        }
        Instruction::BlockCopy {
            source,
            target,
            options,
        } => {
            named.extend(option_list(options));
            let first = addresses.of_tag(target)?;
            let to = Span {
                bank: first.bank,
                first: first.number,
                last: first.number.checked_add(u16::try_from(source.len() - 1).ok()?)?,
            };
            ("blockcopy", vec![source.to_string(), to.to_string()])
        }
        Instruction::Fill {
            source,
            target,
            options,
        } => {
            named.extend(option_list(options));
            ("fill", vec![operand_text(source, addresses)?, target.to_string()])
        }
        Instruction::Pack {
            source,
            target,
            options,
        } => {
            named.extend(option_list(options));
            let name = match source.bank.kind() {
                Kind::Bit => "pack_bits",
                Kind::Text => "pack_text",
                _ => "pack_words",
            };
            (name, vec![source.to_string(), addresses.text(target)?])
        }
        Instruction::Unpack {
            source,
            target,
            options,
        } => {
            named.extend(option_list(options));
            let name = match target.bank.kind() {
                Kind::Bit => "unpack_to_bits",
                _ => "unpack_to_words",
            };
            (name, vec![addresses.text(source)?, target.to_string()])
        }
        Instruction::Shift(Shift { bits, clock, reset }) => {
            pins.extend(clock.as_ref().map(|clock| (".clock()", clock)));
            pins.extend(reset.as_ref().map(|reset| (".reset()", reset)));
            ("shift", vec![bits.to_string()])
        }
        Instruction::Search(Search {
            relation,
            value,
            among,
            result,
            flag,
            continuous,
        }) => {
            named.push(("result".to_owned(), addresses.text(result)?));
            named.push(("found".to_owned(), addresses.text(flag)?));
            if *continuous {
                named.push(("continuous".to_owned(), "1".to_owned()));
            }
            let value = operand_text(value, addresses)?;
            ("search", vec![format!("{among} {} {value}", relation.sign())])
        }
        Instruction::Math(Math {
            kind,
            formula,
            target,
        }) => {
            let mode = match kind {
                MathKind::Decimal => "decimal",
                MathKind::Hex => "hex",
            };
            named.push(("mode".to_owned(), mode.to_owned()));
            (
                "math",
                vec![
                    super::formula::write(formula, addresses)?,
                    operand_text(target, addresses)?,
                ],
            )
        }
        Instruction::Drum(drum) => {
            let (name, all) = super::drum::write(drum, addresses)?;
            named = all;
            let step = match &drum.jump_step {
                Some(step) => operand_text(step, addresses)?,
                None => String::new(),
            };
            jump = format!(".jump({step})");
            for (pin, condition) in [
                (".reset()", &drum.reset),
                (&*jump, &drum.jump),
                (".jog()", &drum.jog),
            ] {
                pins.extend(condition.as_ref().map(|condition| (pin, condition)));
            }
            (name, Vec::new())
        }
        Instruction::Call(name) => ("call", vec![format!("\"{}\"", name.replace('"', "\"\""))]),
        Instruction::For(count) => ("for", vec![operand_text(count, addresses)?]),
        Instruction::Next => ("next", Vec::new()),
        Instruction::End => ("end", Vec::new()),
        Instruction::Return => ("return", Vec::new()),
        Instruction::Nop => {
            let output = "NOP".to_owned();
            let pins = Vec::new();
            return Some(Written { output, pins });
        }
        // What is not an output would not be read again, and a pin would be taken for one of the output above.
        Instruction::Kept { text, .. } if text.starts_with('.') || Token::read(text).is_err() => return None,
        Instruction::Kept { text, .. } => {
            let output = text.clone();
            let pins = Vec::new();
            return Some(Written { output, pins });
        }
    };
    if oneshot {
        named.push(("oneshot".to_owned(), "1".to_owned()));
    }
    let named = named.into_iter().map(|(name, value)| format!("{name}={value}"));
    let inside: Vec<String> = values.into_iter().chain(named).collect();
    let output = format!("{name}({})", inside.join(","));
    let pins = pins
        .into_iter()
        .map(|(pin, condition)| (pin.to_owned(), condition))
        .collect();
    Some(Written { output, pins })
}

/// The options of a copy by name.
fn option_list(options: &CopyOptions) -> impl Iterator<Item = (String, String)> {
    let convert = options
        .convert
        .map(|convert| ("convert".to_owned(), convert.grid()));
    let blanks = options
        .allow_whitespace
        .then(|| ("allow_whitespace".to_owned(), "1".to_owned()));
    convert
        .into_iter()
        .chain(blanks)
        .chain(options.named.iter().cloned())
}

/// The bit of a timer or counter and its current value.
fn pair(tag: &Tag, values: Bank, addresses: &Addresses) -> Option<Vec<String>> {
    let done = addresses.of_tag(tag)?;
    let current = Tag::number(values, done.number);
    Some(vec![done.to_string(), addresses.text(&current)?])
}

fn coil_text(coil: &Coil, addresses: &Addresses) -> Option<String> {
    let bits = match &coil.bits {
        Bits::One(tag) => addresses.text(tag)?,
        Bits::Many(span) => span.to_string(),
    };
    let immediate = |bits| format!("immediate({bits})");
    Some(if coil.immediate { immediate(bits) } else { bits })
}
