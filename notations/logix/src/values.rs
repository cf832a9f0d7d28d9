//! Initial values: what a file says, and what the controller does before its first scan.

use crate::model::Raw;
use crate::operand::{Expr, number};
use crate::types::{Elem, Slot, Ty, Types};
use std::collections::BTreeMap;

/// A value. What a structure or an array does not hold is 0.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Value {
    Int(i64),
    Real(f64),
    Text(String),
    Parts(BTreeMap<usize, Value>),
}

impl Value {
    fn is_zero(&self) -> bool {
        match self {
            Value::Int(int) => *int == 0,
            Value::Real(real) => *real == 0.0,
            Value::Text(text) => text.is_empty(),
            Value::Parts(parts) => parts.values().all(Value::is_zero),
        }
    }

    /// What a file says of a tag's value.
    pub(crate) fn of(raw: &Raw, ty: &Ty, types: &Types) -> Option<Value> {
        let parts = |parts: BTreeMap<usize, Value>| (!parts.is_empty()).then_some(Value::Parts(parts));
        let value = match (raw, ty) {
            (Raw::Scalar(_, text), Ty::Elem(elem)) => scalar(text, *elem)?,
            (Raw::Structure(_, members), Ty::Elem(Elem::String(length))) => {
                let data = members.iter().find(|(name, _)| name == "DATA");
                let Some((_, Raw::Scalar(_, text))) = data else {
                    return None;
                };
                scalar(text, Elem::String(*length))?
            }
            (Raw::List(values), Ty::Elem(Elem::String(_))) => match &values[..] {
                [Raw::Scalar(_, length), Raw::Scalar(_, text)] => {
                    let text = text.trim_matches('\'');
                    Value::Text(first_characters(text, length.parse().unwrap_or(0)))
                }
                _ => return None,
            },
            (Raw::Structure(_, members), Ty::Structure(index)) => {
                let members = members.iter().filter_map(|(name, raw)| {
                    let (number, field) = types.member(*index, name)?;
                    Some((number, Value::of(raw, &field.ty, types)?))
                });
                parts(members.collect())?
            }
            (Raw::List(values), Ty::Structure(index)) => {
                let structure = &types.all[*index];
                let mut members = BTreeMap::new();
                for (slot, raw) in structure.slots.iter().zip(values) {
                    match slot {
                        Slot::Member(number) => {
                            let value = Value::of(raw, &structure.members[*number].ty, types);
                            members.extend(value.map(|value| (*number, value)));
                        }
                        Slot::Bits(bits) => {
                            let Raw::Scalar(_, text) = raw else { continue };
                            let Some(Expr::Int(all)) = number(text) else {
                                continue;
                            };
                            let set = bits.iter().filter(|(_, bit)| all >> (bit & 63) & 1 == 1);
                            members.extend(set.map(|(number, _)| (*number, Value::Int(1))));
                        }
                        Slot::Unknown => {}
                    }
                }
                parts(members)?
            }
            (Raw::Array(_, _, elements) | Raw::List(elements), Ty::Array(ty, _)) => {
                let elements = elements.iter().enumerate();
                let elements = elements.filter_map(|(n, raw)| Some((n, Value::of(raw, ty, types)?)));
                parts(elements.collect())?
            }
            _ => return None,
        };
        (!value.is_zero()).then_some(value)
    }

    /// The part at a path of members and elements, made if there is none yet.
    fn part(&mut self, path: &[usize]) -> &mut Value {
        let Some((first, rest)) = path.split_first() else {
            return self;
        };
        if !matches!(self, Value::Parts(_)) {
            *self = Value::Parts(BTreeMap::new());
        }
        match self {
            Value::Parts(parts) => parts.entry(*first).or_insert(Value::Int(0)).part(rest),
            other => other,
        }
    }

    /// Changes a part, or one bit of it.
    pub(crate) fn set(&mut self, path: &[usize], bit: Option<u32>, number: i64) {
        let part = self.part(path);
        *part = match (bit, &part) {
            (None, _) => Value::Int(number),
            (Some(bit), Value::Int(before)) if bit < 64 => {
                let mask = 1i64 << bit;
                Value::Int(if number == 0 {
                    before & !mask
                } else {
                    before | mask
                })
            }
            (Some(_), other) => (*other).clone(),
        };
    }

    /// The number at a path.
    pub(crate) fn get(&self, path: &[usize]) -> i64 {
        match (self, path.split_first()) {
            (Value::Int(int), None) => *int,
            (Value::Parts(parts), Some((first, rest))) => parts.get(first).map_or(0, |part| part.get(rest)),
            _ => 0,
        }
    }

    /// As a declaration has it; none if it is the one that the type has.
    pub(crate) fn text(&self, ty: &Ty, types: &Types) -> Option<String> {
        if self.is_zero() {
            return None;
        }
        match (self, ty) {
            (value, Ty::Elem(elem)) => Some(literal(value, *elem)),
            (Value::Parts(parts), Ty::Structure(index)) => {
                let members = &types.all[*index].members;
                let texts = parts.iter().filter_map(|(number, value)| {
                    let field = members.get(*number)?;
                    Some(format!("{} := {}", field.name, value.text(&field.ty, types)?))
                });
                let texts: Vec<String> = texts.collect();
                (!texts.is_empty()).then(|| format!("({})", texts.join(", ")))
            }
            (Value::Parts(parts), Ty::Array(ty, sizes)) => elements(parts, ty, sizes, types),
            _ => None,
        }
    }
}

/// The elements of an array, equal neighbours together.
fn elements(parts: &BTreeMap<usize, Value>, ty: &Ty, sizes: &[u32], types: &Types) -> Option<String> {
    let all = sizes
        .iter()
        .fold(1u64, |all, size| all.saturating_mul(u64::from(*size)));
    let mut runs: Vec<(Option<String>, u64)> = Vec::new();
    let mut push = |text: Option<String>, count: u64| match runs.last_mut() {
        _ if count == 0 => {}
        Some((last, times)) if *last == text => *times += count,
        _ => runs.push((text, count)),
    };
    let mut next = 0;
    for (number, value) in parts {
        let number = *number as u64;
        if number >= all {
            break;
        }
        push(None, number - next);
        push(value.text(ty, types), 1);
        next = number + 1;
    }
    let texts: Vec<String> = runs
        .into_iter()
        .map(|(text, count)| match (text, count) {
            (Some(text), 1) => text,
            (text, count) => format!("{count}({})", text.unwrap_or_default()),
        })
        .collect();
    (!texts.is_empty()).then(|| format!("[{}]", texts.join(", ")))
}

/// A value as a literal of a type.
pub(crate) fn literal(value: &Value, elem: Elem) -> String {
    match (value, elem) {
        (Value::Int(int), Elem::Bool) => if *int != 0 { "TRUE" } else { "FALSE" }.to_owned(),
        (Value::Int(int), elem) if elem.is_real() => real(*int as f64),
        (Value::Real(value), elem) if elem.is_real() => real(*value),
        (Value::Real(value), _) => elem.wrap(value.round_ties_even() as i64).to_string(),
        (Value::Int(int), Elem::Ulint) => (*int as u64).to_string(),
        (Value::Int(int), _) => elem.wrap(*int).to_string(),
        (Value::Text(text), _) => format!("'{text}'"),
        (Value::Parts(_), _) => "0".to_owned(),
    }
}

/// A real as ladder text writes it.
pub(crate) fn real(value: f64) -> String {
    let text = format!("{value:?}");
    match text.split_once('e') {
        Some((digits, exponent)) if !digits.contains('.') => format!("{digits}.0e{exponent}"),
        _ => text,
    }
}

fn scalar(text: &str, elem: Elem) -> Option<Value> {
    let text = text.trim();
    if let Some(characters) = text.strip_prefix('\'').and_then(|text| text.strip_suffix('\'')) {
        if matches!(elem, Elem::String(_)) {
            return Some(Value::Text(characters.to_owned()));
        }
        return Some(Value::Int(elem.wrap(characters_as_number(characters))));
    }
    let found = number(text).or_else(|| crate::times::date(text).map(Expr::Int));
    match found? {
        Expr::Int(int) if elem.is_real() => Some(Value::Real(int as f64)),
        Expr::Int(int) => Some(Value::Int(elem.wrap(int))),
        // A real has 32 bits: what is written is its nearest.
        Expr::Real(value) if elem == Elem::Real => {
            let shortest: f64 = format!("{}", value as f32).parse().ok()?;
            shortest.is_finite().then_some(Value::Real(shortest))
        }
        Expr::Real(value) => Some(Value::Real(value)),
        _ => None,
    }
}

/// Each character of a text with its `$` escapes.
fn characters(text: &str) -> Vec<String> {
    let mut out = Vec::new();
    let mut rest = text.chars();
    while let Some(c) = rest.next() {
        let mut one = String::from(c);
        if c == '$'
            && let Some(next) = rest.next()
        {
            one.push(next);
            if next.is_ascii_hexdigit() {
                one.extend(rest.next());
            }
        }
        out.push(one);
    }
    out
}

fn first_characters(text: &str, count: usize) -> String {
    characters(text).into_iter().take(count).collect()
}

/// `'$00$00$01$02'`: the bytes of a number, the highest first.
fn characters_as_number(text: &str) -> i64 {
    characters(text).iter().fold(0i64, |number, one| {
        let byte = match one.strip_prefix('$') {
            Some(hex) => i64::from_str_radix(hex, 16).unwrap_or_else(|_| match hex {
                "L" | "l" | "N" | "n" => 10,
                "P" | "p" => 12,
                "R" | "r" => 13,
                "T" | "t" => 9,
                other => other.bytes().next().unwrap_or_default().into(),
            }),
            None => one.bytes().next().unwrap_or_default().into(),
        };
        number << 8 | (byte & 0xff)
    })
}
