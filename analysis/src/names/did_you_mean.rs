//! The nearest of some names to a misspelt one.

use crate::context::Context;
use ladder_syntax::Name;
use rustc_hash::FxHasher;
use smol_str::SmolStr;
use std::hash::{Hash, Hasher};

/// How many names are looked at: a file that consists of mistakes must not cost the square of its length.
const MOST: usize = 500;
/// Nobody has seen a longer name; to compare two costs the product of their lengths.
const LONGEST: usize = 100;

/// A misspelt name.
struct Misspelt {
    name: Name,
    /// How many letters it has.
    length: usize,
    /// How many of them may be wrong.
    limit: usize,
}

impl Misspelt {
    /// None: it is too long for a name.
    fn new(name: &str) -> Option<Misspelt> {
        let name = Name::new(name);
        let length = name.as_str().chars().count();
        let limit = if length <= 3 { 1 } else { 2 };
        (length <= LONGEST).then_some(Misspelt { name, length, limit })
    }

    /// How many letters another name is away, if that is near.
    fn distance(&self, other: &str) -> Option<usize> {
        let wanted = self.name.as_str();
        if other.len().abs_diff(wanted.len()) > 4 * self.limit {
            return None;
        }
        let other = Name::new(other);
        // A letter that is wrong is one that only this name has, and one that only the other has.
        let different = letters(wanted) ^ letters(other.as_str());
        if different.count_ones() as usize > 2 * self.limit {
            return None;
        }
        let distance = strsim::osa_distance(wanted, other.as_str());
        (distance <= self.limit && distance < self.length).then_some(distance)
    }
}

/// Which letters a name has, each as a bit that others may have too.
fn letters(name: &str) -> u64 {
    name.bytes().fold(0, |letters, byte| match byte {
        0x80.. => letters,
        _ => letters | 1 << (byte & 63),
    })
}

/// The name that is nearest, the first of them: at most two letters away, one for names of up to three letters, and not every
/// letter.
pub(crate) fn closest<'n>(wanted: &str, names: impl Iterator<Item = &'n str>) -> Option<&'n str> {
    let wanted = Misspelt::new(wanted)?;
    let names = names.take(MOST);
    let near = names.filter_map(|name| Some((wanted.distance(name)?, name)));
    near.min_by_key(|(distance, _)| *distance).map(|(_, name)| name)
}

/// The declared names of a file that slips are compared with.
#[derive(Debug)]
pub(crate) struct Compared {
    /// Stands for all of them.
    stamp: u64,
    /// Sorted: which of several is nearest does not depend on where they are declared.
    names: Vec<SmolStr>,
}

impl Compared {
    pub(crate) fn of(context: &Context) -> Compared {
        let mut names: Vec<SmolStr> = declared(context).cloned().collect();
        names.sort_unstable();
        Compared {
            stamp: stamp(context),
            names,
        }
    }

    /// The name that is nearest to one that is not declared.
    pub(crate) fn closest(&self, name: &str) -> Option<&str> {
        closest(name, self.names.iter().map(SmolStr::as_str))
    }

    /// Takes the names as they are now. Gives those that have come or gone.
    pub(crate) fn follow(&mut self, context: &Context) -> Vec<SmolStr> {
        if self.stamp == stamp(context) {
            return Vec::new();
        }
        let before = std::mem::replace(self, Compared::of(context));
        let only_in = |some: &[SmolStr], others: &[SmolStr]| {
            let some = some.iter().filter(|name| others.binary_search(name).is_err());
            some.cloned().collect::<Vec<_>>()
        };
        let mut changed = only_in(&before.names, &self.names);
        changed.extend(only_in(&self.names, &before.names));
        changed
    }
}

/// Whether one of some names is near to another.
pub(crate) fn is_near(wanted: &str, names: &[SmolStr]) -> bool {
    Misspelt::new(wanted).is_some_and(|wanted| names.iter().any(|name| wanted.distance(name).is_some()))
}

fn declared(context: &Context) -> impl Iterator<Item = &SmolStr> {
    let declared = context.scopes[0].tags.iter().filter(|tag| tag.is_declared());
    declared.take(MOST).map(|tag| &tag.name)
}

fn stamp(context: &Context) -> u64 {
    let mut hasher = FxHasher::default();
    declared(context).for_each(|name| name.hash(&mut hasher));
    hasher.finish()
}
