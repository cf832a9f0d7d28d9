//! The values of tags: by name and type.

use super::Lost;
use super::matching::Matching;
use super::renamed::Renamed;
use crate::layout::{Home, state_size};
use crate::memory::{Bit, Memory, Word};
use crate::overlap::{dimensions, overlap};
use crate::places::{BlockAt, EdgeOf};
use crate::simulation::Simulation;
use ladder_analysis::program::{Tag, TagId};
use ladder_analysis::values::compound::{EnumId, Enumeration};
use ladder_analysis::values::types::{Scalar, Type};
use ladder_analysis::values::value::Value;
use ladder_analysis::with_article;
use ladder_instructions::StateType;
use ladder_syntax::Name;
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

/// Where a tag lives, and what it is.
pub(super) type Living<'p> = (&'p Tag, Home);

/// The same tag in the old program and in the new one.
pub(super) type Pair<'p> = (Living<'p>, (Tag, Home));

/// Copies what tags hold.
pub(super) fn carry(
    old: &Simulation,
    new: &mut Simulation,
    matching: &Matching,
    renamed: &Renamed,
    lost: &mut Vec<Lost>,
) {
    let (pairs, gone) = pairs(old, new, matching, renamed);
    let mut copied = Copied {
        old,
        memory: &mut new.machine.memory,
        of_tags: &new.compiled.places.of_tags,
    };
    for (was, is) in &pairs {
        if is.0.constant {
            continue;
        }
        let is_block = |tag: &Tag| matches!(tag.ty, Type::Compound(_));
        if is_block(was.0) && was.0.ty == is.0.ty {
            // The tags of its body are tags of their own.
            continue;
        }
        let Some(missing) = copied.tag(*was, is) else {
            lost.push(Lost {
                message: format!(
                    "{} was {} and is {} now: it begins with its initial value",
                    is.0.name,
                    with_article(was.0.ty),
                    with_article(is.0.ty)
                ),
                location: Some(is.0.location),
            });
            continue;
        };
        for (number, value) in missing {
            let name = match is.0.ty {
                Type::Array { first, .. } => is.0.element_name(first + i64::from(number)),
                _ => is.0.name.clone(),
            };
            lost.push(Lost {
                message: format!(
                    "{name} was {value}, which is no value any more: it begins with its initial value"
                ),
                location: Some(is.0.location),
            });
        }
        if dimensions(was.0) == dimensions(&is.0) && was.0.initial != is.0.initial {
            lost.push(Lost {
                message: format!(
                    "{} keeps its value: its initial value counts from the next cold start on",
                    is.0.name
                ),
                location: Some(is.0.location),
            });
        }
    }
    for (tag, home) in gone {
        if !tag.constant && !is_initial(home, &old.machine.memory, &old.compiled.initial) {
            lost.push(Lost {
                message: format!("{} is no more, and what it held is gone", tag.name),
                location: None,
            });
        }
    }
}

/// Tags of both programs that are the same one, and those that are no more.
pub(super) fn pairs<'s>(
    old: &'s Simulation,
    new: &Simulation,
    matching: &Matching,
    renamed: &Renamed,
) -> (Vec<Pair<'s>>, Vec<Living<'s>>) {
    let mut pairs = Vec::new();
    let mut known: HashMap<Name, TagId> = HashMap::new();
    let mut at_address: HashMap<Name, TagId> = HashMap::new();
    let old_ones = (0..).map(TagId).zip(&old.program.tags);
    for (id, tag) in old_ones.filter(|(_, tag)| tag.block.is_none()) {
        known.insert(Name::new(&tag.name), id);
        if let Some(address) = &tag.address {
            at_address.insert(Name::new(address), id);
        }
    }
    let old_tag = |id: TagId| {
        (
            &old.program.tags[id.0 as usize],
            old.compiled.homes[id.0 as usize],
        )
    };
    let mut taken = HashSet::new();
    let mut match_tag = |tag: &Tag, home: Home, id: TagId| {
        if taken.insert(id) {
            pairs.push((old_tag(id), (tag.clone(), home)));
        }
    };
    let new_ones = new.program.tags.iter().zip(&new.compiled.homes);
    let mut by_name = Vec::new();
    for (tag, &home) in new_ones.filter(|(tag, _)| tag.block.is_none()) {
        // What is at an address is the same tag by whichever names.
        let was = tag.address.as_deref().map(Name::new);
        match was.and_then(|address| at_address.get(&address)) {
            Some(&id) => match_tag(tag, home, id),
            None => by_name.push((tag, home)),
        }
    }
    for (tag, home) in by_name {
        if let Some(&id) = known.get(&Name::new(renamed.former_name(tag))) {
            match_tag(tag, home, id);
        }
    }
    let mut gone = Vec::new();
    for (id, tag) in (0..).map(TagId).zip(&old.program.tags) {
        if tag.block.is_none() && !taken.contains(&id) {
            gone.push(old_tag(id));
        }
    }
    let mut bodies: HashMap<(&[_], Option<u32>, Name), Living<'_>> = HashMap::new();
    for (path, number, id, home) in of_bodies(old) {
        let tag = &old.program.tags[id.0 as usize];
        bodies.insert((path, number, Name::new(&tag.name)), (tag, home));
    }
    for (path, number, id, home) in of_bodies(new) {
        let tag = &new.program.tags[id.0 as usize];
        let was = matching.path(path).and_then(|path| {
            let key = (path.as_slice(), number, Name::new(&tag.name));
            bodies.get(&key).copied()
        });
        if let Some(was) = was {
            pairs.push((was, (tag.clone(), home)));
        }
    }
    (pairs, gone)
}

/// The tags of bodies: the path of the place, and of which of several states they are that are tags.
fn of_bodies(simulation: &Simulation) -> impl Iterator<Item = (&[BlockAt], Option<u32>, TagId, Home)> {
    let places = &simulation.compiled.places;
    let own = places.body_tags.iter();
    let own = own.map(|(path, tag, home)| (path.as_slice(), None, *tag, *home));
    let owned = places.owned_tags.iter();
    own.chain(owned.map(|(path, number, tag, home)| (path.as_slice(), Some(*number), *tag, *home)))
}

struct Copied<'s> {
    old: &'s Simulation,
    memory: &'s mut Memory,
    of_tags: &'s HashMap<EdgeOf, Bit>,
}

impl Copied<'_> {
    /// Copies what a tag holds. Returns the elements of an enumeration whose value is no more. None: nothing can be copied.
    fn tag(&mut self, (was, from): Living<'_>, (is, to): &(Tag, Home)) -> Option<Vec<(u32, String)>> {
        let (element, is_element) = (element(was.ty)?, element(is.ty)?);
        let names = match (element, is_element) {
            (Element::Value(Scalar::Enum(was)), Element::Value(Scalar::Enum(is))) if was != is => {
                let both = same_enumeration(was, is)?;
                Some(both)
            }
            (Element::Value(was), Element::Value(is)) if was == is || (was.is_string() && is.is_string()) => {
                None
            }
            (Element::State(was), Element::State(is)) if was == is => None,
            _ => return None,
        };
        let (was_dimensions, is_dimensions) = (dimensions(was), dimensions(is));
        if was_dimensions.len() != is_dimensions.len() {
            return None;
        }
        let runs = overlap(&was_dimensions, &is_dimensions);
        let slots = |from: u32, to: u32| {
            let runs = runs.iter();
            runs.flat_map(move |run| (0..run.count).map(move |n| (from + run.from + n, to + run.to + n)))
        };
        let mut missing = Vec::new();
        match (from, *to) {
            (Home::Bits { at, .. }, Home::Bits { at: to, .. }) => {
                for (from, to) in slots(at.0, to.0) {
                    self.bit(Bit(from), Bit(to));
                }
            }
            (Home::Words { at, .. }, Home::Words { at: first, .. }) => {
                for (from, to) in slots(at.0, first.0) {
                    let Some((was, is)) = &names else {
                        self.word(Word(from), Word(to));
                        continue;
                    };
                    let held = self.old.machine.memory.words[from as usize];
                    let name = was.name_of(held).map_or_else(String::new, ToString::to_string);
                    match is.number(&name) {
                        Some(number) => self.memory.words[to as usize] = i64::from(number),
                        None => missing.push((to - first.0, name)),
                    }
                }
            }
            (Home::Texts { at, .. }, Home::Texts { at: to, .. }) => {
                for (from, to) in slots(at.0, to.0) {
                    let text = self.old.machine.memory.texts[from as usize].bytes();
                    self.memory.texts[to as usize].set(text);
                }
            }
            (
                Home::State { state, bits, words },
                Home::State {
                    bits: to_bits,
                    words: to_words,
                    ..
                },
            ) => {
                let (bit_count, word_count) = state_size(state);
                for n in 0..bit_count {
                    self.bit(bits.offset(n), to_bits.offset(n));
                }
                for n in 0..word_count {
                    self.word(words.offset(n), to_words.offset(n));
                }
            }
            _ => return None,
        }
        Some(missing)
    }

    fn bit(&mut self, from: Bit, to: Bit) {
        self.memory.bits[to.0 as usize] = self.old.machine.memory.bits[from.0 as usize];
        self.edge(EdgeOf::Bit(from), EdgeOf::Bit(to));
    }

    fn word(&mut self, from: Word, to: Word) {
        self.memory.words[to.0 as usize] = self.old.machine.memory.words[from.0 as usize];
        self.edge(EdgeOf::Word(from), EdgeOf::Word(to));
    }

    /// What edges of a tag share.
    fn edge(&mut self, from: EdgeOf, to: EdgeOf) {
        let was = self.old.compiled.places.of_tags.get(&from);
        if let (Some(was), Some(is)) = (was, self.of_tags.get(&to)) {
            self.memory.bits[is.0 as usize] = self.old.machine.memory.bits[was.0 as usize];
        }
    }
}

/// Both enumerations, if the one is a later form of the other: by its name, or all of its values.
fn same_enumeration(was: EnumId, is: EnumId) -> Option<(Arc<Enumeration>, Arc<Enumeration>)> {
    let (was, is) = (was.get(), is.get());
    let is_same = Name::new(&was.name) == Name::new(&is.name) || was.values == is.values;
    is_same.then_some((was, is))
}

/// The value of a type that is another one in its later form; none if it has none.
pub(super) fn kept(value: Value, was: Scalar, is: Scalar) -> Option<Value> {
    match (value, was, is) {
        (value, was, is) if was == is => Some(value),
        (Value::Int(number), Scalar::Enum(was), Scalar::Enum(is)) => {
            let (was, is) = same_enumeration(was, is)?;
            let number = is.number(was.name_of(number)?)?;
            Some(Value::Int(i64::from(number)))
        }
        _ => None,
    }
}

/// What a tag holds, or each of its elements.
#[derive(Clone, Copy)]
enum Element {
    Value(Scalar),
    State(StateType),
}

fn element(ty: Type) -> Option<Element> {
    match ty {
        Type::Scalar(scalar) | Type::Array { element: scalar, .. } => Some(Element::Value(scalar)),
        Type::State(state) => Some(Element::State(state)),
        Type::Compound(_) => None,
    }
}

/// Whether a tag holds what it began with.
fn is_initial(home: Home, memory: &Memory, initial: &Memory) -> bool {
    let same_bits = |at: Bit, len: u32| {
        let range = at.0 as usize..(at.0 + len) as usize;
        memory.bits[range.clone()] == initial.bits[range]
    };
    let same_words = |at: Word, len: u32| {
        let range = at.0 as usize..(at.0 + len) as usize;
        memory.words[range.clone()] == initial.words[range]
    };
    match home {
        Home::Bits { at, len, .. } => same_bits(at, len),
        Home::Words { at, len, .. } => same_words(at, len),
        Home::Texts { at, len, .. } => {
            let range = at.0 as usize..(at.0 + len) as usize;
            memory.texts[range.clone()] == initial.texts[range]
        }
        Home::State { state, bits, words } => {
            let (bit_count, word_count) = state_size(state);
            same_bits(bits, bit_count) && same_words(words, word_count)
        }
        Home::Borrowed(_) => true,
    }
}
