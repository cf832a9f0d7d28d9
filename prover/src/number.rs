//! Whole numbers as bits of a graph: two's complement, the last bit the sign, and no more bits than are needed.
//!
//! A word of the simulator holds the value of a 64-bit number whatever the type of its tag; here it has as many bits as its
//! values take, and whatever holds for it holds for the value.

use crate::graph::{Graph, Lit};
use ladder_simulator::compiled::Width;

/// A number.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Number {
    /// From the lowest on; never empty.
    bits: Vec<Lit>,
}

/// Words of the simulator have this many bits.
const WORD: usize = 64;

impl Number {
    /// Of these bits, the last one the sign.
    pub(crate) fn of_bits(mut bits: Vec<Lit>) -> Number {
        if bits.is_empty() {
            bits.push(Lit::FALSE);
        }
        while let [.., before, sign] = bits[..]
            && before == sign
        {
            bits.pop();
        }
        Number { bits }
    }

    /// Of these bits and never negative.
    pub(crate) fn unsigned(mut bits: Vec<Lit>) -> Number {
        bits.push(Lit::FALSE);
        Number::of_bits(bits)
    }

    /// One that is known.
    pub(crate) fn constant(value: i64) -> Number {
        let bits = (0..WORD).map(|bit| Lit::constant(value >> bit & 1 != 0));
        Number::of_bits(bits.collect())
    }

    /// 0 or 1.
    pub(crate) fn of_bit(bit: Lit) -> Number {
        Number::unsigned(vec![bit])
    }

    /// Its value, if that is known.
    pub(crate) fn known(&self) -> Option<i64> {
        let mut value = if self.sign() == Lit::TRUE { -1i64 } else { 0 };
        for (n, bit) in self.bits.iter().enumerate() {
            let bit = i64::from(bit.known()?);
            value = value & !(1 << n.min(63)) | bit << n.min(63);
        }
        Some(value)
    }

    /// How many bits it has, the sign included.
    pub(crate) fn len(&self) -> usize {
        self.bits.len()
    }

    /// The bit of a number: the sign, beyond its last.
    pub(crate) fn bit(&self, n: usize) -> Lit {
        self.bits.get(n).copied().unwrap_or(self.sign())
    }

    /// Whether it is below 0.
    pub(crate) fn sign(&self) -> Lit {
        self.bits[self.bits.len() - 1]
    }

    /// Its lowest bits, as many as are asked for.
    pub(crate) fn low(&self, count: usize) -> Vec<Lit> {
        (0..count).map(|n| self.bit(n)).collect()
    }

    /// The value that a type holds of it: two's complement.
    #[must_use]
    pub(crate) fn wrapped(&self, width: Width) -> Number {
        let bits = width.bits() as usize;
        let is_unsigned = matches!(width, Width::U8 | Width::U16 | Width::U32);
        let low = self.low(bits);
        if is_unsigned {
            Number::unsigned(low)
        } else {
            Number::of_bits(low)
        }
    }

    /// The bits of a word as the number that a type sees in them: 64 unsigned bits are not negative.
    #[must_use]
    pub(crate) fn seen_as(&self, width: Width) -> Number {
        match width {
            Width::U64 => Number::unsigned(self.low(WORD)),
            _ => self.clone(),
        }
    }

    /// The word that holds it.
    #[must_use]
    pub(crate) fn as_word(&self) -> Number {
        Number::of_bits(self.low(WORD))
    }
}

impl Graph {
    fn sum(&mut self, a: &[Lit], b: &[Lit], mut carry: Lit) -> Vec<Lit> {
        let mut out = Vec::with_capacity(a.len());
        for (&a, &b) in a.iter().zip(b) {
            let half = self.xor(a, b);
            out.push(self.xor(half, carry));
            let both = self.and(a, b);
            let carried = self.and(half, carry);
            carry = self.or(both, carried);
        }
        out
    }

    /// a + b
    pub(crate) fn add(&mut self, a: &Number, b: &Number) -> Number {
        let len = a.len().max(b.len()) + 1;
        Number::of_bits(self.sum(&a.low(len), &b.low(len), Lit::FALSE))
    }

    /// a - b
    pub(crate) fn sub(&mut self, a: &Number, b: &Number) -> Number {
        let len = a.len().max(b.len()) + 1;
        let b: Vec<Lit> = b.low(len).into_iter().map(|bit| !bit).collect();
        Number::of_bits(self.sum(&a.low(len), &b, Lit::TRUE))
    }

    /// a × b, its lowest bits right.
    pub(crate) fn mul(&mut self, a: &Number, b: &Number, most: usize) -> Number {
        let (a, b) = if a.known().is_some() || a.bits < b.bits {
            (b, a)
        } else {
            (a, b)
        };
        let len = most.min(a.len() + b.len());
        let shifted = |by: usize| -> Vec<Lit> {
            let zeros = std::iter::repeat_n(Lit::FALSE, by.min(len));
            zeros.chain(a.low(len - by.min(len))).collect()
        };
        let mut total = vec![Lit::FALSE; len];
        let mut digits: Vec<(Lit, bool)> = b.bits.iter().map(|&bit| (bit, false)).collect();
        if let Some(last) = digits.last_mut() {
            // The sign counts negative.
            last.1 = true;
        }
        if let Some(value) = b.known() {
            digits = signed_digits(value);
        }
        for (n, (bit, is_negative)) in digits.into_iter().enumerate().take(len) {
            if bit == Lit::FALSE {
                continue;
            }
            let row: Vec<Lit> = shifted(n).into_iter().map(|lit| self.and(lit, bit)).collect();
            total = if is_negative {
                let row: Vec<Lit> = row.into_iter().map(|lit| !lit).collect();
                self.sum(&total, &row, Lit::TRUE)
            } else {
                self.sum(&total, &row, Lit::FALSE)
            };
        }
        Number::of_bits(total)
    }

    /// The absolute value.
    pub(crate) fn abs(&mut self, a: &Number) -> Number {
        let negative = self.sub(&Number::constant(0), a);
        self.choose_number(a.sign(), &negative, a)
    }

    /// a divided by b, cut towards 0, and the rest. Where b is 0 both are something.
    pub(crate) fn div(&mut self, a: &Number, b: &Number) -> (Number, Number) {
        if b.known() == Some(1) {
            return (a.clone(), Number::constant(0));
        }
        let (top, bottom) = (self.abs(a), self.abs(b));
        let (count, len) = (top.len() - 1, bottom.len() + 1);
        let divisor = bottom.low(len);
        let mut rest = vec![Lit::FALSE; len];
        let mut quotient = vec![Lit::FALSE; count];
        let not_divisor: Vec<Lit> = divisor.iter().map(|&bit| !bit).collect();
        for n in (0..count).rev() {
            rest.rotate_right(1);
            rest[0] = top.bit(n);
            let less = self.sum(&rest, &not_divisor, Lit::TRUE);
            let fits = !less[len - 1];
            quotient[n] = fits;
            rest = rest
                .iter()
                .zip(&less)
                .map(|(&rest, &less)| self.choose(fits, less, rest))
                .collect();
        }
        let (quotient, rest) = (Number::unsigned(quotient), Number::of_bits(rest));
        let zero = Number::constant(0);
        let differ = self.xor(a.sign(), b.sign());
        let (minus_quotient, minus_rest) = (self.sub(&zero, &quotient), self.sub(&zero, &rest));
        (
            self.choose_number(differ, &minus_quotient, &quotient),
            self.choose_number(a.sign(), &minus_rest, &rest),
        )
    }

    /// a divided by b, which is more than 0, cut downwards, and the rest, which is never negative.
    pub(crate) fn div_floor(&mut self, a: &Number, b: i64) -> (Number, Number) {
        let (quotient, rest) = self.div(a, &Number::constant(b));
        let less = self.sub(&quotient, &Number::constant(1));
        let more = self.add(&rest, &Number::constant(b));
        let is_below = rest.sign();
        (
            self.choose_number(is_below, &less, &quotient),
            self.choose_number(is_below, &more, &rest),
        )
    }

    /// a divided by b, which is even and more than 0: the nearest whole number, of two the even one.
    pub(crate) fn rounded_quotient(&mut self, a: &Number, b: i64) -> Number {
        let (quotient, rest) = self.div_floor(a, b);
        let half = Number::constant(b / 2);
        let (is_half, is_more) = (self.equal(&rest, &half), self.less(&half, &rest));
        let is_odd_half = self.and(is_half, quotient.bit(0));
        let rounds_up = self.or(is_more, is_odd_half);
        self.add(&quotient, &Number::of_bit(rounds_up))
    }

    /// a = b
    pub(crate) fn equal(&mut self, a: &Number, b: &Number) -> Lit {
        let len = a.len().max(b.len());
        let mut equal = Lit::TRUE;
        for n in 0..len {
            let same = self.same(a.bit(n), b.bit(n));
            equal = self.and(equal, same);
        }
        equal
    }

    /// a < b
    pub(crate) fn less(&mut self, a: &Number, b: &Number) -> Lit {
        let len = a.len().max(b.len());
        let mut less = Lit::FALSE;
        for n in 0..len {
            // The sign's weight is negative.
            let (low, high) = if n + 1 == len {
                (b.bit(n), a.bit(n))
            } else {
                (a.bit(n), b.bit(n))
            };
            let here = self.and(!low, high);
            let same = self.same(low, high);
            let below = self.and(same, less);
            less = self.or(here, below);
        }
        less
    }

    /// The one where `which` is high, else the other.
    pub(crate) fn choose_number(&mut self, which: Lit, high: &Number, low: &Number) -> Number {
        let len = high.len().max(low.len());
        let bits = (0..len).map(|n| self.choose(which, high.bit(n), low.bit(n)));
        Number::of_bits(bits.collect())
    }

    /// The smaller.
    pub(crate) fn min(&mut self, a: &Number, b: &Number) -> Number {
        let less = self.less(b, a);
        self.choose_number(less, b, a)
    }

    /// The larger.
    pub(crate) fn max(&mut self, a: &Number, b: &Number) -> Number {
        let less = self.less(a, b);
        self.choose_number(less, b, a)
    }
}

/// A number as digits 1, 0 and -1, few of them not 0: with whether each is negative.
fn signed_digits(value: i64) -> Vec<(Lit, bool)> {
    let (mut rest, mut digits) = (i128::from(value), Vec::new());
    while rest != 0 {
        let digit = if rest & 1 == 0 { 0 } else { 2 - (rest & 3) };
        digits.push((Lit::constant(digit != 0), digit < 0));
        rest = (rest - digit) / 2;
    }
    digits
}

/// The greatest common divisor.
pub(crate) fn common(mut a: i64, mut b: i64) -> i64 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a.max(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SOME: [i64; 13] = [0, 1, -1, 2, -2, 3, 7, -8, 100, -128, 127, 32767, -32768];

    #[test]
    fn numbers_that_are_known_are_computed() {
        let mut graph = Graph::default();
        for a in SOME {
            assert_eq!(Number::constant(a).known(), Some(a));
            for b in SOME {
                let (x, y) = (Number::constant(a), Number::constant(b));
                assert_eq!(graph.add(&x, &y).known(), Some(a + b));
                assert_eq!(graph.sub(&x, &y).known(), Some(a - b));
                assert_eq!(graph.mul(&x, &y, 64).known(), Some(a * b), "{a} * {b}");
                assert_eq!(graph.less(&x, &y).known(), Some(a < b));
                assert_eq!(graph.equal(&x, &y).known(), Some(a == b));
                if b != 0 {
                    let (quotient, rest) = graph.div(&x, &y);
                    assert_eq!(
                        (quotient.known(), rest.known()),
                        (Some(a / b), Some(a % b)),
                        "{a} / {b}"
                    );
                }
            }
        }
        for end in [i64::MIN, i64::MAX] {
            assert_eq!(Number::constant(end).known(), Some(end));
        }
        // What is not known but cannot be other: the sign of a product is that of the digits.
        let bits = vec![graph.leaf(), graph.leaf(), graph.leaf()];
        let number = Number::unsigned(bits);
        let product = graph.mul(&number, &Number::constant(1_000), 64);
        assert_eq!(product.bit(2).known(), Some(false));
        assert_eq!(Number::constant(70_000).wrapped(Width::I16).known(), Some(4464));
        assert_eq!(Number::constant(-1).wrapped(Width::U16).known(), Some(65_535));
        assert_eq!(Number::constant(-1).seen_as(Width::U64).len(), 65);
    }
}
