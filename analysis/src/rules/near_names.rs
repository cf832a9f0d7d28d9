//! Which of many names is one letter away from another, without comparing each with each.
//!
//! Two names that differ by one letter (one too many, one missing, one wrong, two swapped) become equal when one
//! letter is taken out of each. So all names with one letter taken out are in a table.

use crate::findings::diagnostic::{Applicability, Diagnostic};
use ladder_syntax::{Name, TextRange};
use rustc_hash::FxHasher;
use std::hash::{Hash, Hasher};

/// Shorter names are alike too easily: `a` and `b` differ by one letter.
const SHORTEST: usize = 3;
/// Nobody has seen a longer name for a tag.
const LONGEST: usize = 100;

/// Names that can be asked for.
#[derive(Debug, Default)]
pub(crate) struct NearNames {
    names: Vec<Name>,
    /// Sorted: the hash of a name with one letter taken out, and which name that is.
    shortened: Vec<(u32, u32)>,
}

impl NearNames {
    /// Names of which none is there twice.
    pub(crate) fn new(names: impl Iterator<Item = Name>) -> NearNames {
        let mut near = NearNames::default();
        for name in names {
            let letters = letters(&name);
            if is_long_enough(&letters) {
                let number = near.names.len() as u32;
                each_shortened(&letters, |hash| near.shortened.push((hash, number)));
                near.names.push(name);
            }
        }
        near.shortened.sort_unstable();
        near
    }

    /// The names that differ by one letter, in no order. Another digit is another tag, not a slip.
    pub(crate) fn one_letter_from(&self, name: &Name) -> Vec<&Name> {
        let wanted = letters(name);
        if self.names.is_empty() || !is_long_enough(&wanted) {
            return Vec::new();
        }
        let mut numbers: Vec<u32> = Vec::new();
        each_shortened(&wanted, |hash| {
            let first = self.shortened.partition_point(|(other, _)| *other < hash);
            let near = self.shortened[first..].iter();
            let near = near.take_while(|(other, _)| *other == hash);
            numbers.extend(near.map(|(_, number)| *number));
        });
        numbers.sort_unstable();
        numbers.dedup();
        let names = numbers.into_iter().map(|number| &self.names[number as usize]);
        names
            .filter(|near| differ_by_a_letter(name.as_str(), near.as_str()))
            .collect()
    }
}

/// Whether a name is so near to another that it is one with a typing error: names of three letters are alike too easily.
fn is_slip(name: &str, near: &str) -> bool {
    let (name, near) = (Name::new(name), Name::new(near));
    name.as_str().chars().count() > SHORTEST && differ_by_a_letter(name.as_str(), near.as_str())
}

/// Asks whether a nearer name was meant, and puts it there where that is plausible.
pub(crate) fn ask(found: Diagnostic, wanted: &str, near: &str, meant: Meant) -> Diagnostic {
    let found = found.help(format!("did you mean {}?", meant.shown));
    if !is_slip(wanted, near) {
        return found;
    }
    found.fix(Applicability::Unsafe, meant.title, meant.range, meant.written)
}

/// What is put in the place of a misspelt name.
pub(crate) struct Meant {
    /// As the message shows it.
    pub(crate) shown: String,
    /// What the fix does.
    pub(crate) title: String,
    pub(crate) range: TextRange,
    pub(crate) written: String,
}

impl Meant {
    /// The name itself.
    pub(crate) fn name(near: &str, action: &str, range: TextRange) -> Meant {
        Meant {
            shown: format!("`{near}`"),
            title: format!("{action} `{near}`"),
            range,
            written: near.to_owned(),
        }
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
}
