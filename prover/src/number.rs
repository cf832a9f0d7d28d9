//! Whole numbers as bits of a graph: two's complement, the last bit the sign, and no more bits than are needed.
//!
//! A word of the simulator holds the value of a 64-bit number whatever the type of its tag; here it has as many bits as its
//! values take, and whatever holds for it holds for the value. Between which ends they lie is known of each, so that what a
//! program keeps within limits takes few bits, and so does what is computed from it.

use crate::graph::{Graph, Lit};
use ladder_simulator::compiled::Width;

/// A number.
#[derive(Debug, Clone)]
pub(crate) struct Number {
    /// From the lowest on; never empty.
    bits: Vec<Lit>,
    ends: Ends,
}

/// The least and the greatest value that a number can have, as far as is known. None: it has more bits than these.
pub(crate) type Ends = Option<(i128, i128)>;

/// The ends of what is computed from numbers, if that is defined for both.
fn ends_of(a: &Number, b: &Number, of: impl Fn(i128, i128) -> Option<i128>) -> Ends {
    let ((a, b), (c, d)) = (a.ends?, b.ends?);
    let corners = [of(a, c)?, of(a, d)?, of(b, c)?, of(b, d)?];
    Some((*corners.iter().min()?, *corners.iter().max()?))
}

/// How many bits the numbers between two ends take, the sign included.
pub(crate) fn room((least, most): (i128, i128)) -> usize {
    let of = |end: i128| 129 - (if end < 0 { !end } else { end }).leading_zeros() as usize;
    of(least).max(of(most))
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
        let room = bits.len() - 1;
        let ends = (room < 127).then(|| {
            let end = 1i128 << room;
            match bits[room].known() {
                Some(false) => (0, end - 1),
                Some(true) => (-end, -1),
                None => (-end, end - 1),
            }
        });
        Number { bits, ends }
    }

    /// The same, of which it is known that it lies between these ends.
    pub(crate) fn within(mut self, ends: Ends) -> Number {
        let Some((least, most)) = ends else { return self };
        let (least, most) = match self.ends {
            Some((a, b)) => (least.max(a), most.min(b)),
            None => (least, most),
        };
        if least > most {
            return self;
        }
        self.bits.truncate(room((least, most)));
        if let Some(sign) = self.bits.last_mut() {
            match (least >= 0, most < 0) {
                (true, _) => *sign = Lit::FALSE,
                (_, true) => *sign = Lit::TRUE,
                _ => {}
            }
        }
        let ends = Some((least, most));
        Number {
            ends,
            ..Number::of_bits(self.bits)
        }
    }

    /// The least and the greatest value that it can have. None: it has more bits than these.
    pub(crate) fn ends(&self) -> Ends {
        self.ends
    }

    /// Whether it surely lies between these ends.
    fn fits(&self, least: i128, most: i128) -> bool {
        self.ends.is_some_and(|ends| least <= ends.0 && ends.1 <= most)
    }

    /// Of these bits and never negative.
    pub(crate) fn unsigned(mut bits: Vec<Lit>) -> Number {
        bits.push(Lit::FALSE);
        Number::of_bits(bits)
    }

    /// One that is known.
    pub(crate) fn constant(value: i64) -> Number {
        let bits = (0..WORD).map(|bit| Lit::constant(value >> bit & 1 != 0));
        let value = i128::from(value);
        Number::of_bits(bits.collect()).within(Some((value, value)))
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

    /// Whether it is surely less than another.
    fn is_below(&self, other: &Number) -> bool {
        let ends = self.ends.zip(other.ends);
        ends.is_some_and(|((_, most), (least, _))| most < least)
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
        let (least, most) = if is_unsigned {
            (0, (1 << bits) - 1)
        } else {
            (-1 << (bits - 1), (1 << (bits - 1)) - 1)
        };
        if self.fits(least, most) {
            return self.clone();
        }
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
            Width::U64 if !self.fits(0, i128::from(u64::MAX)) => Number::unsigned(self.low(WORD)),
            _ => self.clone(),
        }
    }

    /// The word that holds it.
    #[must_use]
    pub(crate) fn as_word(&self) -> Number {
        self.wrapped(Width::I64)
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
        let ends = ends_of(a, b, i128::checked_add);
        let len = ends.map_or(a.len().max(b.len()) + 1, room);
        Number::of_bits(self.sum(&a.low(len), &b.low(len), Lit::FALSE)).within(ends)
    }

    /// a - b
    pub(crate) fn sub(&mut self, a: &Number, b: &Number) -> Number {
        let ends = ends_of(a, b, i128::checked_sub);
        let len = ends.map_or(a.len().max(b.len()) + 1, room);
        let b: Vec<Lit> = b.low(len).into_iter().map(|bit| !bit).collect();
        Number::of_bits(self.sum(&a.low(len), &b, Lit::TRUE)).within(ends)
    }

    /// a × b, its lowest bits right.
    pub(crate) fn mul(&mut self, a: &Number, b: &Number, most: usize) -> Number {
        let (a, b) = if a.known().is_some() || a.bits < b.bits {
            (b, a)
        } else {
            (a, b)
        };
        let ends = ends_of(a, b, i128::checked_mul).filter(|ends| room(*ends) <= most);
        let len = ends.map_or(most.min(a.len() + b.len()), room);
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
        Number::of_bits(total).within(ends)
    }

    /// The absolute value.
    pub(crate) fn abs(&mut self, a: &Number) -> Number {
        let negative = self.sub(&Number::constant(0), a);
        let ends = a.ends.and_then(|(least, most)| {
            let far = least.checked_neg()?.max(most);
            Some((least.max(most.checked_neg()?).max(0), far))
        });
        self.choose_number(a.sign(), &negative, a).within(ends)
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
        // Of a divisor that can be 0 nothing is known.
        let divisor = b.known().filter(|b| *b != 0).map(i128::from);
        let ends = a.ends.zip(divisor).and_then(|((least, most), divisor)| {
            let (one, other) = (least.checked_div(divisor)?, most.checked_div(divisor)?);
            let far = divisor.checked_abs()? - 1;
            let rest = (least.max(-far).min(0), most.min(far).max(0));
            Some(((one.min(other), one.max(other)), rest))
        });
        let (of_quotient, of_rest) = ends.unzip();
        (
            self.choose_number(differ, &minus_quotient, &quotient)
                .within(of_quotient),
            self.choose_number(a.sign(), &minus_rest, &rest).within(of_rest),
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
        if a.is_below(b) || b.is_below(a) {
            return Lit::FALSE;
        }
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
        if a.is_below(b) {
            return Lit::TRUE;
        }
        if let (Some((least, _)), Some((_, most))) = (a.ends, b.ends)
            && least >= most
        {
            return Lit::FALSE;
        }
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
        match which.known() {
            Some(true) => return high.clone(),
            Some(false) => return low.clone(),
            None => {}
        }
        let len = high.len().max(low.len());
        let bits = (0..len).map(|n| self.choose(which, high.bit(n), low.bit(n)));
        let ends = high.ends.zip(low.ends).map(|(a, b)| (a.0.min(b.0), a.1.max(b.1)));
        Number::of_bits(bits.collect()).within(ends)
    }

    /// The smaller.
    pub(crate) fn min(&mut self, a: &Number, b: &Number) -> Number {
        let less = self.less(b, a);
        let ends = a.ends.zip(b.ends).map(|(a, b)| (a.0.min(b.0), a.1.min(b.1)));
        self.choose_number(less, b, a).within(ends)
    }

    /// The larger.
    pub(crate) fn max(&mut self, a: &Number, b: &Number) -> Number {
        let less = self.less(a, b);
        let ends = a.ends.zip(b.ends).map(|(a, b)| (a.0.max(b.0), a.1.max(b.1)));
        self.choose_number(less, b, a).within(ends)
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

    #[test]
    fn what_is_kept_within_limits_takes_few_bits() {
        let mut graph = Graph::default();
        let any = |graph: &mut Graph| Number::of_bits((0..32).map(|_| graph.leaf()).collect());
        let limited = |graph: &mut Graph, least: i64, most: i64| {
            let number = any(graph);
            let number = graph.max(&number, &Number::constant(least));
            graph.min(&number, &Number::constant(most))
        };
        let volume = limited(&mut graph, 0, 100_000);
        assert_eq!((volume.len(), volume.sign()), (18, Lit::FALSE));
        let scaled = graph.mul(&volume, &Number::constant(27_648), 64);
        let (raw, rest) = graph.div(&scaled, &Number::constant(100_000));
        assert_eq!((raw.len(), rest.len()), (16, 18));
        assert_eq!(graph.less(&Number::constant(27_648), &raw), Lit::FALSE);
        assert_eq!(raw.wrapped(Width::I16).ends, Some((0, 27_648)));
        let below = limited(&mut graph, -999, -1);
        assert_eq!((below.len(), below.sign()), (11, Lit::TRUE));
        let sum = graph.add(&below, &volume);
        assert_eq!((sum.ends, sum.len()), (Some((-999, 99_999)), 18));
        let away = graph.abs(&below);
        assert_eq!(away.ends, Some((1, 999)));
        // What may divide by 0, and what no longer fits a product, may be anything.
        let divisor = any(&mut graph);
        assert!(graph.div(&volume, &divisor).0.len() >= 18);
        let (a, b) = (any(&mut graph), any(&mut graph));
        assert_eq!(graph.mul(&a, &b, 16).len(), 16);
        assert_eq!(graph.mul(&a, &b, 128).len(), 64);
    }
}
