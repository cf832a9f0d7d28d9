//! Values that show that two networks differ, in words.

use crate::decide::reach;
use crate::encode::{Input, InputTag};
use crate::graph::Lit;
use crate::model::Model;
use crate::number::Number;
use crate::unrolled::{Found, Unrolled};
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_simulator::value_text;
use std::fmt;

/// With more values than this nothing is asked about which of them matter.
const MOST_GIVEN: usize = 64;
/// So many numbers are made small.
const MOST_SMALL: usize = 8;
/// Conflicts that the question about one of them may have.
const CONFLICTS: u64 = 2_000;

/// Something that a network does.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Effect {
    Value(InputTag),
    Fault,
    End,
    Rail,
    Jump(String),
    GoesOn,
}

impl Effect {
    /// A memory that belongs to a place in the text: its name is `start before 1`. That of all edges of a tag has the number 0.
    pub(crate) fn is_of_place(&self) -> bool {
        matches!(self, Effect::Value(tag) if tag.name.contains(" before ") && !tag.name.ends_with(" before 0"))
    }

    /// What is shown first: tags, then members of timers and counters, then what has no name in the program.
    pub(crate) fn rank(&self) -> (u8, bool) {
        match self {
            Effect::Value(tag) if tag.name.contains(' ') => (3, false),
            Effect::Value(tag) if tag.name.contains('.') => (1, tag.ty != Scalar::Time),
            Effect::Value(tag) => (0, tag.ty != Scalar::Bool),
            Effect::Jump(_) | Effect::End | Effect::Fault => (2, false),
            Effect::Rail | Effect::GoesOn => (4, false),
        }
    }
}

/// Values with which a network does one thing in the old program and another in the new.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Difference {
    /// The tags that matter, with their values before the network runs.
    pub given: Vec<(String, String)>,
    /// What it does then: what differs, and how in the old and in the new program.
    pub effect: String,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.given.is_empty() {
            f.write_str("with ")?;
            for (n, (name, value)) in self.given.iter().enumerate() {
                let between = match n {
                    0 => "",
                    n if n + 1 == self.given.len() => " and ",
                    _ => ", ",
                };
                write!(f, "{between}{name} {value}")?;
            }
            f.write_str(", ")?;
        }
        f.write_str(&self.effect)
    }
}

/// The values that the solver has found, as far as they matter.
pub(crate) fn shown(
    model: &Model,
    solver: &mut Unrolled<'_>,
    differs: Lit,
    (effect, old, new): (&Effect, &Number, &Number),
) -> Difference {
    let bits: Vec<Lit> = [old, new].into_iter().flat_map(|number| number.low(64)).collect();
    let nodes = reach(model, bits.into_iter());
    let inputs = model.world.inputs.iter();
    let inputs: Vec<&Input> = inputs
        .filter(|input| input.bits.iter().any(|bit| nodes.contains(&bit.node())))
        .collect();
    make_small(solver, differs, &inputs);
    let value_of = |solver: &Unrolled<'_>, number: &Number| -> i64 {
        let bits = (0..64).map(|n| i64::from(solver.value(0, number.bit(n))) << n);
        bits.fold(0, |all, bit| all | bit)
    };
    let (was, is) = (value_of(solver, old), value_of(solver, new));
    // Each that it may depend on, with the literals that say its value.
    let mut given: Vec<(&InputTag, i64, Vec<Lit>)> = Vec::new();
    for input in inputs {
        let mut number = 0;
        let mut lits = Vec::new();
        for (n, bit) in input.bits.iter().enumerate() {
            let high = solver.value(0, *bit);
            number |= i64::from(high) << n;
            lits.push(solver.lit(0, bit.negated_if(!high)));
        }
        given.push((&input.tag, extended(number, input.bits.len(), input.tag.ty), lits));
    }
    given.sort_by_key(|(tag, ..)| !tag.name.contains(' '));
    // The values are left out that are not needed for the two to differ.
    let mut pairs = Vec::new();
    for (number, value) in [(old, was), (new, is)] {
        for n in 0..64 {
            let lit = solver.lit(0, number.bit(n));
            pairs.push((lit, Lit::constant(value >> n & 1 != 0)));
        }
    }
    let otherwise = solver.differ(&pairs);
    let mut at = 0;
    while given.len() <= MOST_GIVEN && at < given.len() {
        let others = given.iter().enumerate().filter(|(n, _)| *n != at);
        let mut asked: Vec<Lit> = others.flat_map(|(_, (.., lits))| lits.iter().copied()).collect();
        asked.push(otherwise);
        if solver.ask(&asked, CONFLICTS) == Found::No {
            given.remove(at);
        } else {
            at += 1;
        }
    }
    given.sort_by_key(|(tag, ..)| tag.name.contains(' '));
    let given = given.iter().map(|(tag, number, _)| named(tag, *number));
    Difference {
        given: given.collect(),
        effect: told(effect, was, is),
    }
}

/// Asks again for what differs, with small numbers.
fn make_small(solver: &mut Unrolled<'_>, differs: Lit, inputs: &[&Input]) {
    let differs = solver.lit(0, differs);
    let mut asked = vec![differs];
    let numbers = inputs.iter().filter(|input| input.bits.len() > 1);
    for input in numbers.take(MOST_SMALL) {
        for bit in input.bits.iter().rev() {
            let bit = solver.lit(0, *bit);
            asked.push(!bit);
            match solver.ask(&asked, CONFLICTS) {
                Found::Yes => {}
                Found::No => {
                    asked.pop();
                    asked.push(bit);
                }
                Found::Unknown => {
                    asked.pop();
                }
            }
        }
    }
    if solver.ask(&asked, CONFLICTS) != Found::Yes {
        solver.ask(&[differs], u64::MAX);
    }
}

/// A value of fewer than 64 bits as a word holds it.
fn extended(number: i64, bits: usize, ty: Scalar) -> i64 {
    if bits == 0 || bits >= 64 || ty == Scalar::Bool {
        return number;
    }
    ladder_simulator::compiled::Width::of(ty).wrap(number)
}

fn named(tag: &InputTag, number: i64) -> (String, String) {
    if let Some((name, _)) = tag.name.split_once(" before ") {
        let name = if name.is_empty() { "an edge" } else { name };
        return (name.to_owned(), format!("{} before", text(tag.ty, number)));
    }
    if let Some(name) = tag.name.strip_suffix(" age") {
        let since = value_text::display(&Value::Int(number), Scalar::Time);
        return (name.to_owned(), format!("begun {since} ago"));
    }
    if let Some(name) = tag.name.strip_suffix(" phase") {
        return (name.to_owned(), phase(number).to_owned());
    }
    (shown_name(&tag.name), text(tag.ty, number))
}

/// What a timer is doing, by the lowest two bits of its phase.
const fn phase(number: i64) -> &'static str {
    match number & 3 {
        0 => "idle",
        1 => "running",
        _ => "done",
    }
}

/// The left rail has no name in the program.
fn shown_name(name: &str) -> String {
    match name {
        "SYS.RAIL" => "the left rail".to_owned(),
        name => name.to_owned(),
    }
}

fn text(ty: Scalar, number: i64) -> String {
    let value = match ty {
        Scalar::Bool => return if number & 1 != 0 { "on" } else { "off" }.to_owned(),
        Scalar::Real | Scalar::Lreal => Value::Real(f64::from_bits(number as u64)),
        _ => Value::Int(number),
    };
    value_text::display(&value, ty)
}

fn told(effect: &Effect, was: i64, is: i64) -> String {
    let does = |what: &str| {
        let (side, other) = if was & 1 != 0 {
            ("old", "new")
        } else {
            ("new", "old")
        };
        format!("{what} in the {side} and not in the {other} program")
    };
    match effect {
        Effect::Fault => does("a fault happens"),
        Effect::End => does("the program ends"),
        Effect::Rail => does("the left rail stays live"),
        Effect::Jump(label) => does(&format!("it jumps to {label}")),
        Effect::GoesOn => does("the network below is reached"),
        Effect::Value(tag) if tag.ty == Scalar::Bool && !tag.name.contains(' ') => format!(
            "{} goes {} in the old and {} in the new program",
            shown_name(&tag.name),
            text(tag.ty, was),
            text(tag.ty, is)
        ),
        Effect::Value(tag) if tag.name.contains(' ') => {
            let ((name, was), (_, is)) = (named(tag, was), named(tag, is));
            format!("{name} is {was} in the old and {is} in the new program")
        }
        Effect::Value(tag) => format!(
            "{} becomes {} in the old and {} in the new program",
            tag.name,
            text(tag.ty, was),
            text(tag.ty, is)
        ),
    }
}
