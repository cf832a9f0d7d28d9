//! Random choices that a seed repeats, or that bytes make.

/// A row of choices. The same seed gives the same row on every machine (SplitMix64).
#[derive(Debug, Clone)]
pub struct Dice {
    state: u64,
    /// Choices that were made already; the row goes on after them.
    made: std::vec::IntoIter<u8>,
}

impl Dice {
    /// The row of a seed.
    pub fn new(seed: u64) -> Dice {
        Dice {
            state: seed,
            made: Vec::new().into_iter(),
        }
    }

    /// The row that bytes make: changing a byte changes one choice, or a few. After the last one the row is that
    /// of a seed.
    pub fn of_bytes(bytes: &[u8]) -> Dice {
        Dice {
            made: Vec::from(bytes).into_iter(),
            ..Dice::new(0)
        }
    }

    /// Any number.
    pub fn any(&mut self) -> u64 {
        if let Some(first) = self.made.next() {
            let rest = self.made.by_ref().take(7);
            return rest.fold(u64::from(first), |number, byte| number << 8 | u64::from(byte));
        }
        self.state = self.state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut mixed = self.state;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        mixed ^ (mixed >> 31)
    }

    /// A number from 0, below `bound`, which is not 0.
    pub fn below(&mut self, bound: usize) -> usize {
        // One byte for one choice, if it is enough.
        if bound <= 1 << 8
            && let Some(byte) = self.made.next()
        {
            return usize::from(byte) % bound;
        }
        (self.any() % bound as u64) as usize
    }

    /// A number from `first` to `last`.
    pub fn between(&mut self, first: i64, last: i64) -> i64 {
        let count = last.wrapping_sub(first) as u64;
        match count.checked_add(1) {
            Some(count) => first.wrapping_add((self.any() % count) as i64),
            None => self.any() as i64,
        }
    }

    /// High once in `n` times.
    pub fn one_in(&mut self, n: usize) -> bool {
        self.below(n) == 0
    }

    /// One of several.
    pub fn of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.below(choices.len())]
    }

    /// Brings a list into another order.
    pub fn shuffle<T>(&mut self, list: &mut [T]) {
        for last in (1..list.len()).rev() {
            list.swap(last, self.below(last + 1));
        }
    }
}
