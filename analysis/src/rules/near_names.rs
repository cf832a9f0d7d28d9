//! Which of many names is one letter away from another, without comparing each with each.
//!
//! Two names that differ by one letter (one too many, one missing, one wrong, two swapped) become equal when one
//! letter is taken out of each. So all names with one letter taken out are in a table.

use ladder_syntax::Name;
use rustc_hash::{FxHashMap, FxHasher};
use std::collections::BTreeSet;
use std::hash::{Hash, Hasher};

/// Shorter names are alike too easily: `a` and `b` differ by one letter.
const SHORTEST: usize = 3;
/// Nobody has seen a longer name for a tag.
const LONGEST: usize = 100;

/// Names that can be asked for. Names come and go.
#[derive(Debug, Default)]
pub(crate) struct NearNames {
    /// The names by their numbers; none for a number that is free.
    names: Vec<Option<Name>>,
    numbers: FxHashMap<Name, u32>,
    free: Vec<u32>,
    /// The hash of a name with one letter taken out, and the number of the name.
    shortened: BTreeSet<(u32, u32)>,
}

impl NearNames {
    /// Names of which none is there twice.
    pub(crate) fn new(names: impl Iterator<Item = Name>) -> NearNames {
        let mut near = NearNames::default();
        let mut shortened: Vec<(u32, u32)> = Vec::new();
        for name in names {
            let letters = letters(&name);
            if is_long_enough(&letters) {
                let number = near.number(name);
                each_shortened(&letters, |hash| shortened.push((hash, number)));
            }
        }
        // A tree of what is in order already is put together at once.
        shortened.sort_unstable();
        near.shortened = shortened.into_iter().collect();
        near
    }

    /// Whether a name can be asked for.
    pub(crate) fn has(&self, name: &Name) -> bool {
        self.numbers.contains_key(name)
    }

    /// Adds a name that is not there.
    pub(crate) fn insert(&mut self, name: &Name) {
        let letters = letters(name);
        if is_long_enough(&letters) {
            let number = self.number(name.clone());
            each_shortened(&letters, |hash| {
                self.shortened.insert((hash, number));
            });
        }
    }

    /// Takes a name away.
    pub(crate) fn remove(&mut self, name: &Name) {
        let Some(number) = self.numbers.remove(name) else {
            return;
        };
        each_shortened(&letters(name), |hash| {
            self.shortened.remove(&(hash, number));
        });
        self.names[number as usize] = None;
        self.free.push(number);
    }

    fn number(&mut self, name: Name) -> u32 {
        let number = self.free.pop().unwrap_or_else(|| {
            self.names.push(None);
            self.names.len() as u32 - 1
        });
        self.names[number as usize] = Some(name.clone());
        self.numbers.insert(name, number);
        number
    }

    /// The names that differ by one letter, in no order. Another digit is another tag, not a slip.
    pub(crate) fn one_letter_from(&self, name: &Name) -> Vec<&Name> {
        let wanted = letters(name);
        if self.numbers.is_empty() || !is_long_enough(&wanted) {
            return Vec::new();
        }
        let mut numbers: Vec<u32> = Vec::new();
        each_shortened(&wanted, |hash| {
            let near = self.shortened.range((hash, 0)..=(hash, u32::MAX));
            numbers.extend(near.map(|(_, number)| *number));
        });
        numbers.sort_unstable();
        numbers.dedup();
        let names = numbers
            .into_iter()
            .filter_map(|number| self.names[number as usize].as_ref());
        names
            .filter(|near| differ_by_a_letter(name.as_str(), near.as_str()))
            .collect()
    }
}

fn is_long_enough(letters: &[char]) -> bool {
    (SHORTEST..=LONGEST).contains(&letters.len())
}

fn letters(name: &Name) -> Vec<char> {
    name.as_str().chars().collect()
}

/// Hashes of the name itself, and of the name without each of its letters.
fn each_shortened(letters: &[char], mut give: impl FnMut(u32)) {
    give(hash(letters.iter()));
    for (at, letter) in letters.iter().enumerate() {
        if !letter.is_numeric() {
            give(hash(letters[..at].iter().chain(&letters[at + 1..])));
        }
    }
}

fn hash<'l>(letters: impl Iterator<Item = &'l char>) -> u32 {
    let mut hasher = FxHasher::default();
    letters.for_each(|letter| letter.hash(&mut hasher));
    let hash = hasher.finish();
    (hash >> 32) as u32 ^ hash as u32
}

/// Whether exactly one letter is too many, missing, wrong, or swapped with its neighbour.
fn differ_by_a_letter(a: &str, b: &str) -> bool {
    let digits = |name: &str| name.chars().filter(|c| c.is_numeric()).collect::<String>();
    let others = |name: &str| name.chars().filter(|c| !c.is_numeric()).collect::<String>();
    strsim::osa_distance(a, b) == 1 && (others(a) != others(b) || digits(a) == digits(b))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shorter_names_have_the_hash_that_they_have_by_themselves() {
        let hashes = |name: &str| {
            let mut hashes = Vec::new();
            each_shortened(&letters(&Name::new(name)), |hash| hashes.push(hash));
            hashes
        };
        let shortened = hashes("lamp_1");
        for shorter in ["lamp_1", "lamp1", "lam_1", "lap_1", "lmp_1", "amp_1"] {
            assert!(shortened.contains(&hashes(shorter)[0]), "{shorter}");
        }
        assert!(!shortened.contains(&hashes("lamp_")[0]), "a digit stays");
    }

    #[test]
    fn one_letter() {
        let names = ["start", "motor_run", "lamp1", "ab", "vor_ort"].map(Name::new);
        let near = NearNames::new(names.into_iter());
        for (wanted, expected) in [
            ("strat", Some("start")),
            ("stat", Some("start")),
            ("sttart", Some("start")),
            ("stard", Some("start")),
            ("Start", None),
            ("tart", Some("start")),
            ("starts", Some("start")),
            ("sttarts", None),
            ("moter_run", Some("motor_run")),
            ("lamp2", None),
            ("lamp", None),
            ("lamb1", Some("lamp1")),
            ("ac", None),
            ("vorort", Some("vor_ort")),
            ("lam1p", Some("lamp1")),
        ] {
            let expected: Vec<Name> = expected.map(Name::new).into_iter().collect();
            let found = near.one_letter_from(&Name::new(wanted));
            assert_eq!(found, expected.iter().collect::<Vec<_>>(), "{wanted}");
        }
    }

    #[test]
    fn names_come_and_go() {
        let [lamp, lump, limp] = ["lamp", "lump", "limp"].map(Name::new);
        let mut near = NearNames::new([lamp.clone()].into_iter());
        near.insert(&lump);
        let mut both = near.one_letter_from(&limp);
        both.sort();
        assert_eq!(both, [&lamp, &lump]);
        near.remove(&lamp);
        near.remove(&lamp);
        assert_eq!(near.one_letter_from(&limp), [&lump]);
        assert!(near.has(&lump) && !near.has(&lamp));
        near.insert(&limp);
        assert_eq!(near.one_letter_from(&lump), [&limp]);
    }
}
