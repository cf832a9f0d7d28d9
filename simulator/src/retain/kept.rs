//! Retentive tags as texts, for a file: out of memory and into it, perhaps of a program that was changed since.

use super::Retained;
use crate::layout::{Home, state_size, timer};
use crate::memory::{Bit, Memory, TextSlot, Word};
use crate::overlap::{dimensions, overlap};
use crate::value_text;
use ladder_analysis::program::{Program, Tag};
use ladder_analysis::values::types::{Scalar, Type};
use ladder_analysis::values::value::Value;
use ladder_analysis::with_article;
use ladder_instructions::StateType;
use ladder_syntax::Name;
use std::collections::HashMap;

/// The value of one retentive tag.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Kept {
    /// Its name.
    pub name: String,
    /// Its type, as it is declared.
    pub ty: String,
    /// Its values as the language writes them: one, or one for each element of an array. Of a timer, counter or
    /// bistable the numbers of its state.
    pub values: Vec<String>,
}

/// What the retentive tags hold; `now` is the clock.
pub(crate) fn kept(program: &Program, retained: &[Retained], memory: &Memory, now: i64) -> Vec<Kept> {
    let kept = retained.iter().map(|tag| Kept {
        name: tag.name.clone(),
        ty: type_text(declared(program, tag)),
        values: values(tag.home, memory, now),
    });
    kept.collect()
}

/// The tag that is kept; none of an edge, which is a BOOL.
fn declared<'p>(program: &'p Program, kept: &Retained) -> Option<&'p Tag> {
    kept.tag.map(|tag| &program.tags[tag.0 as usize])
}

fn type_of(tag: Option<&Tag>) -> Type {
    tag.map_or(Type::BOOL, |tag| tag.ty)
}

fn dimensions_of(tag: Option<&Tag>) -> Vec<(i64, i64)> {
    tag.map_or_else(Vec::new, dimensions)
}

/// The type of a tag as it is declared, of a column with all dimensions of the arrays around it.
fn type_text(tag: Option<&Tag>) -> String {
    match (type_of(tag), dimensions_of(tag)) {
        (Type::Array { element, .. }, dimensions) if dimensions.len() > 1 => {
            let bounds = dimensions.iter().map(|(first, last)| format!("{first}..{last}"));
            format!("ARRAY[{}] OF {element}", bounds.collect::<Vec<_>>().join(", "))
        }
        (ty, _) => ty.to_string(),
    }
}

/// The dimensions and the element of a type as it is declared.
fn shape(ty: &str) -> Option<(Vec<(i64, i64)>, &str)> {
    let Some(array) = ty.strip_prefix("ARRAY[") else {
        return Some((Vec::new(), ty));
    };
    let (bounds, element) = array.split_once("] OF ")?;
    let bounds = bounds.split(", ").map(|bounds| {
        let (first, last) = bounds.split_once("..")?;
        let (first, last): (i64, i64) = (first.parse().ok()?, last.parse().ok()?);
        (first <= last).then_some((first, last))
    });
    Some((bounds.collect::<Option<_>>()?, element))
}

fn values(home: Home, memory: &Memory, now: i64) -> Vec<String> {
    match home {
        Home::Bits { at, len, .. } => (0..len)
            .map(|n| value_text::display(&Value::Bool(memory.bit(at.offset(n))), Scalar::Bool))
            .collect(),
        Home::Words { at, len, ty, .. } => (0..len)
            .map(|n| {
                let word = at.offset(n);
                let value = if ty.is_real() {
                    Value::Real(memory.real(word))
                } else {
                    Value::Int(memory.word(word))
                };
                value_text::display(&value, ty)
            })
            .collect(),
        Home::Texts { at, len, max, .. } => (at.0..at.0 + len)
            .map(|slot| {
                let value = Value::Text(memory.text(TextSlot(slot)).into());
                value_text::display(&value, Scalar::String(max))
            })
            .collect(),
        Home::State { state, bits, words } => {
            let (bit_count, word_count) = state_size(state);
            let bits = (0..bit_count).map(|n| i64::from(memory.bits[bits.offset(n).0 as usize]));
            let words = (0..word_count).map(|n| match part(state, n) {
                WordKind::Instant => memory.word(words.offset(n)).saturating_sub(now),
                WordKind::Time | WordKind::Count => memory.word(words.offset(n)),
            });
            bits.chain(words).map(|number| number.to_string()).collect()
        }
        Home::Borrowed(_) => Vec::new(),
    }
}

/// What a word of a state is.
enum WordKind {
    /// A moment of the clock: kept as how long ago it was, for the clock starts again at 0.
    Instant,
    Time,
    Count,
}

fn part(state: StateType, word: u32) -> WordKind {
    match word {
        timer::SINCE if state.is_timer() => WordKind::Instant,
        _ if state.is_timer() => WordKind::Time,
        _ => WordKind::Count,
    }
}

/// Puts kept values into a memory whose clock is at 0. Returns why, for each tag that cannot be restored.
pub(crate) fn restore(
    program: &Program,
    retained: &[Retained],
    kept: &[Kept],
    memory: &mut Memory,
) -> Vec<String> {
    let tags: HashMap<Name, &Retained> = retained.iter().map(|tag| (Name::new(&tag.name), tag)).collect();
    let mut complaints = Vec::new();
    for kept in kept {
        let name = &kept.name;
        let Some(tag) = tags.get(&Name::new(name)) else {
            complaints.push(format!(
                "{name} was kept, but the program has no retentive tag of that name any more"
            ));
            continue;
        };
        let declared = declared(program, tag);
        let ty = type_text(declared);
        let element = shape(&ty).map_or(ty.as_str(), |(_, element)| element);
        let was =
            shape(&kept.ty).filter(|(was, of)| *of == element && was.len() == dimensions_of(declared).len());
        let Some((was, _)) = was else {
            complaints.push(format!(
                "{name} was kept as {}, but it is {ty} now: it begins with its initial value",
                kept.ty
            ));
            continue;
        };
        if let Err(problem) = put(tag.home, declared, (&was, &kept.values), memory) {
            complaints.push(format!("{name}: {problem}: it begins with its initial value"));
        }
    }
    complaints
}

/// The values of a tag: of an array those of the elements that it has still. What cannot be read leaves all as it is, of an
/// enumeration whose value is no more that element.
fn put(
    home: Home,
    tag: Option<&Tag>,
    (was, texts): (&[(i64, i64)], &[String]),
    memory: &mut Memory,
) -> Result<(), String> {
    let count = match home {
        Home::State { state, .. } => {
            let (bits, words) = state_size(state);
            u64::from(bits + words)
        }
        Home::Borrowed(_) => 0,
        _ => (was.iter()).fold(1u64, |all, (first, last)| {
            all.saturating_mul(last.abs_diff(*first).saturating_add(1))
        }),
    };
    if texts.len() as u64 != count {
        return Err(format!("{} values were kept where {count} belong", texts.len()));
    }
    if let Home::State { state, bits, words } = home {
        return put_state(state, bits, words, texts, memory);
    }
    let (Type::Scalar(scalar) | Type::Array { element: scalar, .. }) = type_of(tag) else {
        return Ok(());
    };
    let mut values = Vec::new();
    let mut missing = Ok(());
    for run in overlap(was, &dimensions_of(tag)) {
        for n in 0..run.count {
            match value_text::parse(&texts[(run.from + n) as usize], scalar) {
                Ok(value) => values.push((run.to + n, value)),
                Err(problem) if scalar.is_enumeration() => missing = Err(problem),
                Err(problem) => return Err(problem),
            }
        }
    }
    for (n, value) in values {
        match (home, value) {
            (Home::Bits { at, .. }, Value::Bool(high)) => memory.set_bit(at.offset(n), high),
            (Home::Texts { at, .. }, Value::Text(bytes)) => memory.texts[(at.0 + n) as usize].set(&bytes),
            (Home::Words { at, .. }, value) => {
                memory.words[at.offset(n).0 as usize] = crate::layout::word_of(&value);
            }
            _ => {}
        }
    }
    missing
}

fn put_state(
    state: StateType,
    bits: Bit,
    words: Word,
    texts: &[String],
    memory: &mut Memory,
) -> Result<(), String> {
    let (bit_count, _) = state_size(state);
    let numbers: Vec<i64> = texts
        .iter()
        .map(|text| text.parse().map_err(|_| format!("`{text}` is not a number")))
        .collect::<Result<_, _>>()?;
    let (bit_numbers, word_numbers) = numbers.split_at(bit_count as usize);
    let is_possible = |(n, &number): (u32, &i64)| {
        let most = if state.is_timer() && n == timer::PHASE {
            7
        } else {
            1
        };
        (0..=most).contains(&number)
    };
    let is_count = |(n, &number): (u32, &i64)| {
        !matches!(part(state, n), WordKind::Count) || i32::try_from(number).is_ok()
    };
    if !(0..).zip(bit_numbers).all(is_possible) || !(0..).zip(word_numbers).all(is_count) {
        return Err(format!("this is not a state of {}", with_article(state.name())));
    }
    for (n, &number) in (0..).zip(bit_numbers) {
        memory.bits[bits.offset(n).0 as usize] = number as u8;
    }
    for (n, &number) in (0..).zip(word_numbers) {
        memory.words[words.offset(n).0 as usize] = match part(state, n) {
            WordKind::Instant | WordKind::Time | WordKind::Count => number,
        };
    }
    Ok(())
}
