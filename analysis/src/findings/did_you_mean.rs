//! The nearest of some names to a misspelt one.

use ladder_syntax::Name;

/// How many names are checked: a file that consists of errors must not cost the square of its length.
pub(crate) const MOST: usize = 500;
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
