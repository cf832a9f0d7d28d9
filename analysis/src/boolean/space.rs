//! Sets of combinations of values, one bit for each.

use std::ops::{BitAnd, BitOr, Not};

/// How many combinations are checked: as many as 14 contacts have.
pub(crate) const MOST_POINTS: usize = 1 << 14;

/// All combinations of the values of some variables.
#[derive(Debug, Clone)]
pub(crate) struct Space {
    /// How many values each variable has.
    sizes: Vec<usize>,
    points: usize,
}

/// A set of combinations: those in which a function is true.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Set {
    words: Box<[u64]>,
    points: usize,
}

impl Space {
    /// The space of variables with this many values each; none if it is too large.
    pub(crate) fn new(sizes: Vec<usize>) -> Option<Space> {
        let mut points = 1usize;
        for &size in &sizes {
            points = points.checked_mul(size).filter(|&points| points <= MOST_POINTS)?;
        }
        Some(Space { sizes, points })
    }

    /// No combination.
    pub(crate) fn none(&self) -> Set {
        Set {
            words: vec![0; self.points.div_ceil(64)].into(),
            points: self.points,
        }
    }

    /// All of them.
    pub(crate) fn all(&self) -> Set {
        !&self.none()
    }

    /// The combinations in which a variable has one of the values whose bits are given.
    pub(crate) fn values(&self, variable: usize, mask: u64) -> Set {
        let mut set = self.none();
        let stride: usize = self.sizes[..variable].iter().product();
        let size = self.sizes[variable];
        for value in (0..size).filter(|value| mask >> value & 1 == 1) {
            let mut start = value * stride;
            while start < self.points {
                set.fill(start, stride);
                start += stride * size;
            }
        }
        set
    }

    /// The value of each variable in a combination.
    pub(crate) fn at(&self, mut point: usize) -> Vec<usize> {
        self.sizes
            .iter()
            .map(|&size| {
                let value = point % size;
                point /= size;
                value
            })
            .collect()
    }

    /// The combination that is like `point`, with another value of a variable.
    pub(crate) fn with(&self, point: usize, variable: usize, value: usize) -> usize {
        let stride: usize = self.sizes[..variable].iter().product();
        let old = point / stride % self.sizes[variable];
        point - old * stride + value * stride
    }

    /// How many values a variable has.
    pub(crate) fn size(&self, variable: usize) -> usize {
        self.sizes[variable]
    }
}

impl Set {
    fn fill(&mut self, start: usize, length: usize) {
        let end = (start + length).min(self.points);
        let mut at = start;
        while at < end {
            let (word, bit) = (at / 64, at % 64);
            let count = (64 - bit).min(end - at);
            let ones = if count == 64 { u64::MAX } else { (1 << count) - 1 };
            self.words[word] |= ones << bit;
            at += count;
        }
    }

    /// Whether no combination is in it.
    pub(crate) fn is_empty(&self) -> bool {
        self.words.iter().all(|&word| word == 0)
    }

    /// Whether a combination is in it.
    pub(crate) fn holds(&self, point: usize) -> bool {
        self.words[point / 64] >> (point % 64) & 1 == 1
    }

    /// The first combination in it.
    pub(crate) fn first(&self) -> Option<usize> {
        let word = self.words.iter().position(|&word| word != 0)?;
        Some(word * 64 + self.words[word].trailing_zeros() as usize)
    }

    /// The combinations that are in one of the two.
    pub(crate) fn differing(&self, other: &Set) -> Set {
        self.zip(other, |a, b| a ^ b)
    }

    /// Whether every combination in it is in the other.
    pub(crate) fn implies(&self, other: &Set) -> bool {
        self.words.iter().zip(&other.words).all(|(a, b)| a & !b == 0)
    }

    fn zip(&self, other: &Set, of: impl Fn(u64, u64) -> u64) -> Set {
        let words = self.words.iter().zip(&other.words);
        Set {
            words: words.map(|(&a, &b)| of(a, b)).collect(),
            points: self.points,
        }
    }
}

impl BitAnd for &Set {
    type Output = Set;
    fn bitand(self, other: &Set) -> Set {
        self.zip(other, |a, b| a & b)
    }
}

impl BitOr for &Set {
    type Output = Set;
    fn bitor(self, other: &Set) -> Set {
        self.zip(other, |a, b| a | b)
    }
}

impl Not for &Set {
    type Output = Set;
    fn not(self) -> Set {
        let mut words: Box<[u64]> = self.words.iter().map(|&word| !word).collect();
        if let Some(last) = words.last_mut().filter(|_| !self.points.is_multiple_of(64)) {
            *last &= (1 << (self.points % 64)) - 1;
        }
        Set {
            words,
            points: self.points,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_combination_once() {
        let space = Space::new(vec![2, 3, 5, 2, 2]).unwrap();
        for variable in 0..5 {
            let mut together = space.none();
            for value in 0..space.size(variable) {
                let set = space.values(variable, 1 << value);
                for point in 0..120 {
                    assert_eq!(set.holds(point), space.at(point)[variable] == value);
                    assert_eq!(space.at(space.with(point, variable, value))[variable], value);
                }
                assert!((&together & &set).is_empty());
                together = &together | &set;
            }
            assert_eq!(together, space.all());
        }
    }

    #[test]
    fn sets() {
        let space = Space::new(vec![2, 3]).unwrap();
        let (a, b) = (space.values(0, 0b10), space.values(1, 0b101));
        assert!((&a & &b).implies(&a));
        assert!(!a.implies(&b));
        assert_eq!((&a & &!&a).first(), None);
        assert_eq!(&a | &!&a, space.all());
        assert_eq!(a.differing(&a), space.none());
        assert_eq!(a.first(), Some(1));
    }

    #[test]
    fn bounded() {
        assert!(Space::new(vec![2; 14]).is_some());
        assert!(Space::new(vec![2; 15]).is_none());
        assert!(Space::new(vec![2; 1000]).is_none());
        assert!(Space::new(Vec::new()).is_some());
    }
}
