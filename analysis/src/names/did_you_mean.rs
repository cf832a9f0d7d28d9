//! The nearest of some names to a misspelt one.

use ladder_syntax::Name;

/// How many names are looked at: a file that consists of mistakes must not cost the square of its length.
const MOST: usize = 500;
/// Nobody has seen a longer name; to compare two costs the product of their lengths.
const LONGEST: usize = 100;

/// The name that is nearest: at most two letters away, one for names of up to three letters, and not every letter.
pub(crate) fn closest<'n>(wanted: &str, names: impl Iterator<Item = &'n str>) -> Option<&'n str> {
    let wanted = Name::new(wanted);
    let length = wanted.as_str().chars().count();
    if length > LONGEST {
        return None;
    }
    let limit = if length <= 3 { 1 } else { 2 };
    names
        .take(MOST)
        .filter(|name| name.len().abs_diff(wanted.as_str().len()) <= 4 * limit)
        .map(|name| {
            (
                strsim::osa_distance(wanted.as_str(), Name::new(name).as_str()),
                name,
            )
        })
        .filter(|(distance, _)| *distance <= limit && *distance < length)
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, name)| name)
}
