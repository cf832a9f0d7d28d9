//! What became of each element of a program on its way to another notation.

use super::{Finding, LineColumn};
use std::collections::HashSet;

/// An account of a conversion.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Report {
    /// In the order of the source.
    pub entries: Vec<Entry>,
}

/// One element.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Entry {
    /// Where it is in the source.
    pub place: LineColumn,
    /// What it is, as the source writes it: `TON Ta 40000`.
    pub element: String,
    /// What became of it.
    pub outcome: Outcome,
}

/// What became of an element.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Outcome {
    /// It says the same.
    Translated,
    /// It says nearly the same; why not quite.
    Approximated(String),
    /// It has no counterpart and is a comment at its place; why.
    Refused(String),
}

/// How many elements there are of each kind.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Tally {
    /// [`Outcome::Translated`]
    pub translated: usize,
    /// [`Outcome::Approximated`]
    pub approximated: usize,
    /// [`Outcome::Refused`]
    pub refused: usize,
}

impl Report {
    /// An element that says the same.
    pub fn translated(&mut self, place: LineColumn, element: impl Into<String>) {
        self.push(place, element.into(), Outcome::Translated);
    }

    /// An element that says nearly the same.
    pub fn approximated(&mut self, place: LineColumn, element: impl Into<String>, why: impl Into<String>) {
        self.push(place, element.into(), Outcome::Approximated(why.into()));
    }

    /// An element without a counterpart.
    pub fn refused(&mut self, place: LineColumn, element: impl Into<String>, why: impl Into<String>) {
        self.push(place, element.into(), Outcome::Refused(why.into()));
    }

    /// Which findings an entry already tells: what is about a refused element, or says the same as the entry.
    pub fn told(&self) -> impl Fn(&Finding) -> bool {
        let mut told = HashSet::new();
        for entry in &self.entries {
            match &entry.outcome {
                Outcome::Translated => {}
                Outcome::Approximated(why) => {
                    told.insert((entry.place, Some(why.as_str())));
                }
                Outcome::Refused(_) => {
                    told.insert((entry.place, None));
                }
            }
        }
        move |found| {
            told.contains(&(found.place, None)) || told.contains(&(found.place, Some(found.message.as_str())))
        }
    }

    fn push(&mut self, place: LineColumn, element: String, outcome: Outcome) {
        self.entries.push(Entry {
            place,
            element,
            outcome,
        });
    }

    /// How many there are of each.
    pub fn tally(&self) -> Tally {
        let mut tally = Tally::default();
        for entry in &self.entries {
            match entry.outcome {
                Outcome::Translated => tally.translated += 1,
                Outcome::Approximated(_) => tally.approximated += 1,
                Outcome::Refused(_) => tally.refused += 1,
            }
        }
        tally
    }

    /// The entries about which there is something to say: all but what was translated.
    pub fn remarks(&self) -> impl Iterator<Item = &Entry> {
        self.entries
            .iter()
            .filter(|entry| entry.outcome != Outcome::Translated)
    }
}
