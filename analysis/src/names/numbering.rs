//! Numbers that the things of a list keep while others come and go, so that whoever refers to one need not know how many
//! are before it.

use std::ops::Range;

/// What `index_of` holds of a number that nothing has any more.
const GONE: u32 = u32::MAX;

/// The numbers of the things of a list.
#[derive(Debug, Clone, Default)]
pub(crate) struct Numbering {
    /// In the order of the list.
    numbers: Vec<u32>,
    /// By the numbers. No number is given twice.
    index_of: Vec<u32>,
}

impl Numbering {
    /// Makes room for this many things more.
    pub(crate) fn reserve(&mut self, things: usize) {
        self.numbers.reserve(things);
        self.index_of.reserve(things);
    }

    /// Adds a thing at the end. Gives its number.
    pub(crate) fn push(&mut self) -> u32 {
        let number = self.index_of.len() as u32;
        self.index_of.push(self.numbers.len() as u32);
        self.numbers.push(number);
        number
    }

    /// How many numbers there are, with those that nothing has any more.
    pub(crate) fn count(&self) -> usize {
        self.index_of.len()
    }

    /// The number of a thing.
    pub(crate) fn number(&self, index: usize) -> u32 {
        self.numbers[index]
    }

    /// Which thing has a number; none if it is gone.
    pub(crate) fn index(&self, number: u32) -> Option<usize> {
        let index = self.index_of[number as usize];
        (index != GONE).then_some(index as usize)
    }

    /// Puts this many things in the place of some. As many of these as there are new ones hand their numbers on.
    pub(crate) fn exchange(&mut self, old: Range<usize>, count: usize) {
        let kept = old.start + old.len().min(count);
        for index in kept..old.end {
            self.index_of[self.numbers[index] as usize] = GONE;
        }
        if old.len() == count {
            return;
        }
        let first = self.index_of.len() as u32;
        let fresh = first..first + count.saturating_sub(old.len()) as u32;
        self.index_of.resize(fresh.end as usize, GONE);
        self.numbers.splice(kept..old.end, fresh);
        for index in kept..self.numbers.len() {
            self.index_of[self.numbers[index] as usize] = index as u32;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Numbering;

    #[test]
    fn things_keep_their_numbers() {
        let mut numbering = Numbering::default();
        for number in 0..5 {
            assert_eq!(numbering.push(), number);
        }
        let numbers = |it: &Numbering| it.numbers.clone();
        numbering.exchange(1..3, 3);
        assert_eq!(numbers(&numbering), [0, 1, 2, 5, 3, 4]);
        numbering.exchange(0..4, 1);
        assert_eq!(numbers(&numbering), [0, 3, 4]);
        numbering.exchange(2..2, 1);
        assert_eq!(numbers(&numbering), [0, 3, 6, 4]);
        for index in 0..4 {
            assert_eq!(numbering.index(numbering.number(index)), Some(index));
        }
        assert_eq!([1, 2, 5].map(|gone| numbering.index(gone)), [None; 3]);
        assert_eq!(numbering.push(), 7);
    }
}
