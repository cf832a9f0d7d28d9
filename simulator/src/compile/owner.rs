//! To what belongs that blocks remember besides the tags of the program: edges, and the tags of bodies. In the body of a block whose
//! state is a tag it belongs to that tag, everywhere else to the place in the text (LANGUAGE §5.7).

use super::place::Spot;
use super::{Compiler, Result};
use crate::layout::Home;
use crate::memory::{Bit, Word};
use crate::operation::IntegerOp;
use crate::places::{BlockAt, Cell};
use ladder_analysis::program::{Argument, BlockKind, Tag, TagId};
use ladder_analysis::values::types::Scalar;

/// One step on the way to what owns something.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
enum Step {
    /// The first of the tags of one block type that follow each other: an array of them, or more.
    Tags(TagId),
    /// A block in the body.
    Place(BlockAt),
}

/// A number that is known, or the word that holds it when the block is reached.
#[derive(Debug, Clone, Copy)]
enum Number {
    Known(u32),
    At(Word),
}

/// The state of a block that is a tag: one of several that are alike.
#[derive(Debug, Clone)]
pub(super) struct Owner {
    path: Vec<Step>,
    /// How many there are.
    count: u32,
    /// Which of them it is.
    number: Number,
    /// How many blocks stand around the body.
    depth: usize,
    /// How many things of it were found so far.
    found: u32,
}

/// Something that each of several owners has, by the order in which the body has it.
pub(super) type Thing = (OwnerPath, u32);

/// The way to the owners.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(super) struct OwnerPath(Vec<Step>);

impl<'p> Compiler<'p> {
    /// The state of a block that an argument names.
    pub(super) fn owner(&mut self, argument: &Argument) -> Result<Option<Owner>> {
        Ok(match argument {
            Argument::State(tag) => Some(self.owner_of(*tag)),
            Argument::ChosenState(chosen) => {
                let mut owner = self.owner_of(chosen.first);
                let number = self.count(&chosen.number)?;
                owner.number = self.added(owner.number, Number::At(number));
                Some(owner)
            }
            _ => None,
        })
    }

    fn owner_of(&mut self, tag: TagId) -> Owner {
        // What an in-out stands for.
        if let Some(owner) = self.passed_owners.get(&tag) {
            let depth = self.standing.len();
            return Owner {
                depth,
                ..owner.clone()
            };
        }
        let alike = |other: &Tag, tag: &Tag| other.ty == tag.ty && other.block == tag.block;
        let tags = &self.program.tags;
        let (before, after) = tags.split_at(tag.0 as usize);
        let own = &after[0];
        let offset = before.iter().rev().take_while(|it| alike(it, own)).count() as u32;
        let count = offset + after.iter().take_while(|it| alike(it, own)).count() as u32;
        let outer = self.owners.last().filter(|_| own.block.is_some());
        let mut path = outer.map_or_else(Vec::new, |outer| outer.path.clone());
        if own.block.is_some() {
            let around = outer.map_or(0, |outer| outer.depth)..self.standing.len().saturating_sub(1);
            let places = self.standing.get(around).unwrap_or_default();
            path.extend(places.iter().map(|at| Step::Place(*at)));
        }
        path.push(Step::Tags(TagId(tag.0 - offset)));
        let (all, number) = outer.map_or((1, Number::Known(0)), |outer| (outer.count, outer.number));
        let number = self.multiplied(number, count);
        Owner {
            path,
            count: all.saturating_mul(count),
            number: self.added(number, Number::Known(offset)),
            depth: self.standing.len(),
            found: 0,
        }
    }

    fn multiplied(&mut self, number: Number, by: u32) -> Number {
        match number {
            Number::Known(number) => Number::Known(number.saturating_mul(by)),
            Number::At(number) => {
                let by = self.constant(i64::from(by));
                Number::At(self.integer(IntegerOp::Mul, Scalar::Lint, number, by))
            }
        }
    }

    fn added(&mut self, a: Number, b: Number) -> Number {
        match (a, b) {
            (Number::Known(a), Number::Known(b)) => Number::Known(a + b),
            (Number::At(a), Number::Known(b)) | (Number::Known(b), Number::At(a)) => {
                Number::At(self.slot_offset(a, b))
            }
            (Number::At(a), Number::At(b)) => Number::At(self.integer(IntegerOp::Add, Scalar::Lint, a, b)),
        }
    }

    /// The next thing that the owner of the body has, which is compiled; none outside of such bodies.
    fn next_thing(&mut self) -> Option<(Thing, u32, Number)> {
        let outer = self.owners.last_mut()?;
        let mut path = outer.path.clone();
        let places = self.standing.get(outer.depth..).unwrap_or_default();
        path.extend(places.iter().map(|at| Step::Place(*at)));
        outer.found += 1;
        Some(((OwnerPath(path), outer.found), outer.count, outer.number))
    }

    /// A bit that the block remembers which is being compiled.
    pub(super) fn remembered_bit(&mut self) -> Spot {
        let Some((thing, count, number)) = self.next_thing() else {
            let bit = self.layout.bit();
            self.remember(Cell::Bit(bit));
            return Spot::Bit(bit);
        };
        let first = match self.owned_bits.get(&thing) {
            Some(first) => *first,
            None => {
                let first = self.layout.bit();
                self.layout.keep(first);
                for _ in 1..count {
                    let bit = self.layout.bit();
                    self.layout.keep(bit);
                }
                self.keep_edges(&thing, count, first);
                self.note_owned(
                    &thing,
                    Home::Bits {
                        at: first,
                        first: 0,
                        len: count,
                    },
                );
                self.owned_bits.insert(thing, first);
                first
            }
        };
        match number {
            Number::Known(number) => {
                let bit = first.offset(number);
                self.remember(Cell::Bit(bit));
                Spot::Bit(bit)
            }
            Number::At(number) => {
                for n in 0..count {
                    self.remember(Cell::Bit(first.offset(n)));
                }
                Spot::BitAt(self.slot_offset(number, first.0))
            }
        }
    }

    /// Notes the edges of those owners that are retentive.
    fn keep_edges(&mut self, thing: &Thing, count: u32, first: Bit) {
        let program = self.program;
        let roots = self.roots(thing);
        if !roots.iter().any(|tag| tag.retain) {
            return;
        }
        let at = self.standing.last();
        let block = at.map(|at| &program.networks[at.network].blocks[at.block].kind);
        let mnemonic = match block {
            Some(BlockKind::Instruction(row)) => row.mnemonic,
            _ => "",
        };
        let number = self.kept_things.entry(roots[0].name.as_str()).or_default();
        *number += 1;
        let number = *number;
        for (n, tag) in (0..count).zip(each(roots, count)) {
            if tag.retain {
                let at = first.offset(n);
                let home = Home::Bits { at, first: 0, len: 1 };
                // A tag may hold several states.
                let of_state = n % (count / roots.len() as u32).max(1);
                let state = if of_state == 0 {
                    String::new()
                } else {
                    format!(".{of_state}")
                };
                let name = format!("{}.{mnemonic}#{number}{state}", tag.name);
                self.retained_edges.push((name, home));
            }
        }
    }

    /// Notes what else belongs to a state: an unread part that may write that may write this.
    fn note_owned(&mut self, (path, _): &Thing, home: Home) {
        if let Some(Step::Tags(first)) = path.0.first() {
            self.owned.push((*first, home));
        }
    }

    /// The tags of the program that owners are, or are in.
    fn roots(&self, (path, _): &Thing) -> &'p [Tag] {
        let first = match path.0.first() {
            Some(Step::Tags(TagId(first))) => *first as usize,
            _ => 0,
        };
        let tags = &self.program.tags[first..];
        let alike = |tag: &Tag| tag.ty == tags[0].ty && tag.block == tags[0].block;
        let count = tags.iter().take_while(|tag| alike(tag)).count();
        &tags[..count]
    }

    /// Room for a tag of the body of a block whose state is not a tag.
    pub(super) fn body_tag(&mut self, tag: TagId) -> Result<Home> {
        let declared = &self.program.tags[tag.0 as usize];
        let Some((thing, count, number)) = self.next_thing() else {
            let home = self.layout.tag(declared)?;
            self.places.body_tags.push((self.standing.clone(), tag, home));
            if self.keeps[tag.0 as usize] {
                self.retained.push((tag, home));
            }
            return Ok(home);
        };
        let (zero, one) = match self.owned_tags.get(&thing) {
            Some(known) => *known,
            None => {
                let zero = self.layout.tag(declared)?;
                let mut homes = vec![zero];
                for _ in 1..count {
                    homes.push(self.layout.tag(declared)?);
                }
                for home in &homes {
                    self.note_owned(&thing, *home);
                }
                let one = homes.get(1).copied().unwrap_or(zero);
                let keeps = self.keeps[tag.0 as usize];
                let roots = each(self.roots(&thing), count);
                let kept = homes
                    .into_iter()
                    .zip(roots)
                    .filter(|(_, root)| keeps || root.retain);
                self.retained.extend(kept.map(|(home, _)| (tag, home)));
                self.owned_tags.insert(thing, (zero, one));
                (zero, one)
            }
        };
        Ok(match number {
            Number::Known(number) => {
                let home = zero.after(number, one);
                self.places.body_tags.push((self.standing.clone(), tag, home));
                home
            }
            Number::At(number) => {
                for n in 0..count {
                    let path = self.standing.clone();
                    self.places.owned_tags.push((path, n, tag, zero.after(n, one)));
                }
                self.nth(number, zero, one).unwrap_or(zero)
            }
        })
    }
}

/// For each of so many owners the tag of the program that it is, or is in.
fn each(roots: &[Tag], count: u32) -> impl Iterator<Item = &Tag> {
    let states = (count as usize / roots.len()).max(1);
    roots.iter().flat_map(move |tag| std::iter::repeat_n(tag, states))
}

impl Home {
    /// The home after so many others, by the first two.
    fn after(self, number: u32, one: Home) -> Home {
        let bits = |at: Bit, next: Bit| Bit(at.0 + number * (next.0 - at.0));
        let words = |at: Word, next: Word| Word(at.0 + number * (next.0 - at.0));
        let mut home = self;
        match (&mut home, one) {
            (Home::Bits { at, .. }, Home::Bits { at: next, .. }) => *at = bits(*at, next),
            (Home::Words { at, .. }, Home::Words { at: next, .. }) => *at = words(*at, next),
            (Home::Texts { at, .. }, Home::Texts { at: next, .. }) => at.0 += number * (next.0 - at.0),
            (
                Home::State {
                    bits: at,
                    words: word,
                    ..
                },
                Home::State {
                    bits: next,
                    words: next_word,
                    ..
                },
            ) => {
                *at = bits(*at, next);
                *word = words(*word, next_word);
            }
            _ => {}
        }
        home
    }
}
