//! Which of many names is one letter away from another, without comparing each with each.
//!
//! Two names that differ by one letter (one too many, one missing, one wrong, two swapped) become equal when one
//! letter is taken out of each. So all names with one letter taken out are in a table.

use ladder_syntax::Name;
use rustc_hash::FxHashMap;

/// Shorter names are alike too easily: `a` and `b` differ by one letter.
const SHORTEST: usize = 3;
/// Nobody has seen a longer name for a tag.
const LONGEST: usize = 100;
/// Any large odd number spreads the letters over the hash.
const BASE: u64 = 0x9E37_79B9_7F4A_7C15;

/// Names that can be asked for.
pub(super) struct NearNames<'n> {
    names: Vec<(&'n str, Vec<char>)>,
    /// The hash of a name with one letter taken out, and the first name that it comes from: where several do,
    /// they differ in that letter alone, and one is as near as the other.
    shortened: FxHashMap<u64, u32>,
}

impl<'n> NearNames<'n> {
    pub(super) fn new(names: impl Iterator<Item = &'n str>) -> NearNames<'n> {
        let mut near = NearNames {
            names: Vec::new(),
            shortened: FxHashMap::default(),
        };
        for name in names {
            let letters = letters(name);
            if !(SHORTEST..=LONGEST).contains(&letters.len()) {
                continue;
            }
            let index = near.names.len() as u32;
            each_shortened(&letters, |hash| {
                near.shortened.entry(hash).or_insert(index);
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
            let near = self.shortened.get(&hash).copied();
            // The first of the file, whichever letter led to it.
            if let Some(near) = near.filter(|&near| found.is_none_or(|found| near < found))
                && differ_by_a_letter(&wanted, &self.names[near as usize].1)
            {
                found = Some(near);
            }
        });
        found.map(|index| self.names[index as usize].0)
    }
}

fn letters(name: &str) -> Vec<char> {
    Name::new(name).as_str().chars().collect()
}

/// Hashes of the name itself, and of the name without each of its letters. A name's hash is a polynomial in its
/// letters, so that each of the shorter names costs one step.
fn each_shortened(letters: &[char], mut give: impl FnMut(u64)) {
    let step = |hash: u64, letter: char| hash.wrapping_mul(BASE).wrapping_add(u64::from(letter) + 1);
    let whole = letters.iter().fold(0, |hash, &letter| step(hash, letter));
    give(whole);
    // From the last letter to the first: the letters behind the one taken out, and BASE to the power of their
    // number.
    let mut before = whole;
    let (mut behind, mut power) = (0u64, 1u64);
    let inverse = inverse(BASE);
    for &letter in letters.iter().rev() {
        before = before.wrapping_sub(u64::from(letter) + 1).wrapping_mul(inverse);
        if !letter.is_numeric() {
            give(before.wrapping_mul(power).wrapping_add(behind));
        }
        behind = behind.wrapping_add(power.wrapping_mul(u64::from(letter) + 1));
        power = power.wrapping_mul(BASE);
    }
}

/// The number that undoes a multiplication by an odd number, modulo 2^64 (Newton's iteration).
const fn inverse(odd: u64) -> u64 {
    let mut x = odd;
    let mut round = 0;
    while round < 5 {
        x = x.wrapping_mul(2u64.wrapping_sub(odd.wrapping_mul(x)));
        round += 1;
    }
    x
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
    fn shorter_names_have_the_hash_that_they_have_by_themselves() {
        let hashes = |name: &str| {
            let mut hashes = Vec::new();
            each_shortened(&letters(name), |hash| hashes.push(hash));
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
