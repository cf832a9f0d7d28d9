//! What is around the diagram: the settings above it, and the names with their pins below.

use super::super::element::{self, Form};
use super::super::model::{File, number};
use super::chips::{Chip, by_name};
use crate::field;
use ladder_instructions::Op;
use std::collections::HashMap;

fn setting<'f>(file: &'f File, name: &str) -> Option<&'f str> {
    let line = file.header.iter().find_map(|line| line.strip_prefix(name));
    line?.strip_prefix('=')
}

fn chip(file: &File) -> Option<&'static Chip> {
    by_name(setting(file, "MICRO")?)
}

/// `for 'ANSI C Code', 4.000000 MHz crystal, 10.0 ms cycle time`
pub(super) fn settings(file: &File) -> String {
    let controller = match chip(file) {
        Some(chip) => format!("for '{}'", chip.name),
        None => "no MCU assigned".to_owned(),
    };
    let crystal = setting(file, "CRYSTAL").and_then(number).unwrap_or(4_000_000);
    format!(
        "{controller}, {:.6} MHz crystal, {:.1} ms cycle time",
        crystal as f64 / 1e6,
        file.cycle() as f64 / 1e3
    )
}

/// What a name is for. The order is that of the list.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    Input,
    Output,
    Analog,
    Sent,
    Received,
    Pulses,
    Relay,
    OnDelay,
    OffDelay,
    Retentive,
    Counter,
    Variable,
}

impl Kind {
    const fn title(self) -> &'static str {
        match self {
            Kind::Input => "digital in",
            Kind::Output => "digital out",
            Kind::Analog => "adc input",
            Kind::Sent => "UART tx",
            Kind::Received => "UART rx",
            Kind::Pulses => "PWM out",
            Kind::Relay => "int. relay",
            Kind::OnDelay => "turn-on delay",
            Kind::OffDelay => "turn-off delay",
            Kind::Retentive => "retentive timer",
            Kind::Counter => "counter",
            Kind::Variable => "general var",
        }
    }
}

/// The kinds that are given a pin by the user.
pub(super) const WITH_PIN: [&str; 3] = ["digital in", "digital out", "adc input"];
/// What stands for no pin.
pub(super) const NO_PIN: &str = "(not assigned)";

/// The list of names; `used` are the elements in their order.
pub(super) fn names(file: &File, used: &[&str]) -> String {
    let mut out = String::from("  Name                       | Type               | Pin\n");
    out.push_str(" ----------------------------+--------------------+------\n");
    let chip = chip(file);
    let kinds = kinds(used);
    let is_used = |kinds_of: &[Kind]| kinds.values().any(|kind| kinds_of.contains(kind));
    let (serial, pulses) = (is_used(&[Kind::Sent, Kind::Received]), is_used(&[Kind::Pulses]));
    let given: HashMap<&str, u32> = file
        .io
        .iter()
        .filter_map(|(_, entry)| {
            let (name, pin) = entry.split_once(" at ")?;
            Some((name, number(pin)? as u32))
        })
        .collect();
    let mut listed: Vec<(Kind, bool, &str, String)> = Vec::new();
    for (name, kind) in &kinds {
        let pin = given.get(name.as_ref()).copied().unwrap_or(0);
        let of_chip = |pin: fn(&Chip) -> u32, none: &str| match chip.map(pin) {
            None => String::new(),
            Some(0) => none.to_owned(),
            Some(pin) => pin.to_string(),
        };
        let shown = match kind {
            Kind::Input | Kind::Output | Kind::Analog if pin == 0 => NO_PIN.to_owned(),
            Kind::Input | Kind::Output | Kind::Analog => {
                let is = |wanted: fn(&Chip) -> u32| chip.is_some_and(|chip| wanted(chip) == pin);
                match () {
                    () if pulses && is(|chip| chip.pulses) => "<PWM needs!>".to_owned(),
                    () if serial && (is(|chip| chip.receives) || is(|chip| chip.sends)) => {
                        "<UART needs!>".to_owned()
                    }
                    () => pin.to_string(),
                }
            }
            Kind::Sent => of_chip(|chip| chip.sends, "<no UART!>"),
            Kind::Received => of_chip(|chip| chip.receives, "<no UART!>"),
            Kind::Pulses => of_chip(|chip| chip.pulses, "<no PWM!>"),
            _ => String::new(),
        };
        listed.push((*kind, pin == 0, name, shown));
    }
    listed.sort();
    for (kind, _, name, pin) in listed {
        out.push_str(&format!("  {name:<26} | {:<18} | {pin}\n", kind.title()));
    }
    out
}

/// The names that the elements give something to, or that are inputs. The first use that says more than that it is a
/// variable decides.
fn kinds<'e>(used: &[&'e str]) -> HashMap<std::borrow::Cow<'e, str>, Kind> {
    let mut kinds = HashMap::new();
    for element in used {
        let Some(row) = element::row_of(element) else {
            continue;
        };
        let fields = field::fields(element);
        let first = fields.first().copied().unwrap_or_default();
        let by_letter = |other: Kind| match first.chars().next() {
            Some('R') => Kind::Relay,
            Some('X') if row.form == Form::Contact => Kind::Input,
            _ => other,
        };
        let kind = match row.form {
            Form::Contact | Form::Coil => by_letter(Kind::Output),
            Form::Timer(Op::Ton) => Kind::OnDelay,
            Form::Timer(Op::Tof) => Kind::OffDelay,
            Form::Timer(_) => Kind::Retentive,
            Form::Counter(_) => Kind::Counter,
            Form::Adc => Kind::Analog,
            Form::Text if first == "(none)" => continue,
            Form::Text | Form::Values(Op::Usnd, _) => Kind::Sent,
            Form::Values(Op::Urcv, _) => Kind::Received,
            Form::Values(Op::Pwm, _) => Kind::Pulses,
            Form::Values(Op::Mov | Op::Add | Op::Sub | Op::Mul | Op::Div, _) | Form::Table | Form::Curve => {
                Kind::Variable
            }
            Form::Shift => {
                let stages: u32 = fields.get(1).and_then(|stages| stages.parse().ok()).unwrap_or(0);
                for stage in 0..stages.min(super::super::tags::MOST_STAGES) {
                    kinds
                        .entry(format!("{first}{stage}").into())
                        .or_insert(Kind::Variable);
                }
                continue;
            }
            _ => continue,
        };
        let known = kinds.entry(first.into()).or_insert(kind);
        if *known == Kind::Variable {
            *known = kind;
        }
    }
    kinds
}
