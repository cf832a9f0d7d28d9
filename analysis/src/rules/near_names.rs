//! Which of many names is one letter away from another, without comparing each with each.
//!
//! Two names that differ by one letter (one too many, one missing, one wrong, two swapped) become equal when one
//! letter is taken out of each. So all names with one letter taken out stand in a table.

use ladder_syntax::Name;
use std::collections::HashMap;
use std::hash::{BuildHasherDefault, DefaultHasher, Hash, Hasher};

/// Shorter names are alike too easily: `a` and `b` differ by one letter.
const SHORTEST: usize = 3;
/// Taking letters out costs the square of a name's length; nobody has seen a longer name for a tag.
const LONGEST: usize = 100;
/// Names that only differ in one place, like those of a row of lamps, are all kept under one key.
const MOST_IN_A_ROW: usize = 50;

/// Names that can be asked for.
pub(super) struct NearNames<'n> {
    names: Vec<(&'n str, Vec<char>)>,
    /// The hash of a name with one letter taken out, and which names it may come from.
    shortened: HashMap<u64, Vec<u32>, BuildHasherDefault<DefaultHasher>>,
}

impl<'n> NearNames<'n> {
    pub(super) fn new(names: impl Iterator<Item = &'n str>) -> NearNames<'n> {
        let mut near = NearNames {
            names: Vec::new(),
            shortened: HashMap::default(),
        };
        for name in names {
            let letters = letters(name);
            if !(SHORTEST..=LONGEST).contains(&letters.len()) {
                continue;
            }
            let index = near.names.len() as u32;
            each_shortened(&letters, |hash| {
                let row = near.shortened.entry(hash).or_default();
                if row.len() < MOST_IN_A_ROW && row.last() != Some(&index) {
                    row.push(index);
                }
            });
            near.names.push((name, letters));
        }
        near
    }

    /// A name that differs by one letter. Another digit is another tag, not a slip.
    pub(super) fn one_letter_from(&self, name: &str) -> Option<&'n str> {
        let wanted = letters(name);
        if self.names.is_empty() || !(SHORTEST..=LONGEST).contains(&wanted.len()) {
            return None;
        }
        let mut found: Option<u32> = None;
        each_shortened(&wanted, |hash| {
            let row = self.shortened.get(&hash).map_or(&[][..], Vec::as_slice);
            let fits = row
                .iter()
                .copied()
                .find(|&n| differ_by_a_letter(&wanted, &self.names[n as usize].1));
            // The first of the file, whichever letter led to it.
            found = match (found, fits) {
                (Some(a), Some(b)) => Some(a.min(b)),
                (a, b) => a.or(b),
            };
        });
        found.map(|index| self.names[index as usize].0)
    }
}

fn letters(name: &str) -> Vec<char> {
    Name::new(name).as_str().chars().collect()
}

/// The name itself, and the name without each of its letters.
fn each_shortened(letters: &[char], mut give: impl FnMut(u64)) {
    let hash = |before: &[char], behind: &[char]| {
        let mut hasher = DefaultHasher::new();
        for letter in before.iter().chain(behind) {
            letter.hash(&mut hasher);
        }
        hasher.finish()
    };
    give(hash(letters, &[]));
    for (index, letter) in letters.iter().enumerate() {
        if !letter.is_numeric() {
            give(hash(&letters[..index], &letters[index + 1..]));
        }
    }
}

/// Whether exactly one letter is too many, missing, wrong, or swapped with its neighbour.
fn differ_by_a_letter(a: &[char], b: &[char]) -> bool {
    let same_before = a.iter().zip(b).take_while(|(a, b)| a == b).count();
    let (a, b) = (&a[same_before..], &b[same_before..]);
    let same_behind = a
        .iter()
        .rev()
        .zip(b.iter().rev())
        .take_while(|(a, b)| a == b)
        .count();
    let (a, b) = (&a[..a.len() - same_behind], &b[..b.len() - same_behind]);
    let is_letter = |c: &char| !c.is_numeric();
    match (a, b) {
        ([one], []) | ([], [one]) => is_letter(one),
        ([a], [b]) => is_letter(a) || is_letter(b),
        ([a, b], [c, d]) => a == d && b == c,
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_letter() {
        let near = NearNames::new(["start", "motor_run", "lamp1", "ab", "vor_ort"].into_iter());
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
        ] {
            assert_eq!(near.one_letter_from(wanted), expected, "{wanted}");
        }
    }
}
