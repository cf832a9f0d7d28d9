//! Which bits of a controller's memory a direct address takes.
//!
//! Addresses count in units of their own size, as in IEC 61131-3 and CODESYS: `%IW1` is the bytes 2 and 3. So what an address takes
//! begins at a multiple of its own size: of two that overlap one is within the other.

use std::cmp::Reverse;

/// The bits that an address takes. In their order those that hold others come before them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct AddressBits {
    /// I, Q or M.
    area: u8,
    first: u64,
    last: Reverse<u64>,
}

impl AddressBits {
    /// Of an address as it is written. None for addresses of more levels, and for single bits without their byte: systems differ
    /// there.
    pub(crate) fn of(address: &str) -> Option<AddressBits> {
        let mut letters = address.strip_prefix('%')?.bytes();
        let area = letters.next()?.to_ascii_uppercase();
        let size = letters.next()?.to_ascii_uppercase();
        let numbers = address.get(3..)?;
        let first = match (size, numbers.split_once('.')) {
            (b'X', Some((byte, bit))) => {
                let bit: u64 = bit.parse().ok().filter(|bit| *bit < 8)?;
                byte.parse::<u64>().ok()?.checked_mul(8)?.checked_add(bit)?
            }
            (b'X', None) | (_, Some(_)) => return None,
            _ => numbers.parse::<u64>().ok()?.checked_mul(bits(size)?)?,
        };
        Some(AddressBits {
            area,
            first,
            last: Reverse(first.checked_add(bits(size)? - 1)?),
        })
    }

    /// Whether it ends before another one that is after it in their order begins, or lies in another area.
    pub(crate) fn is_above(self, other: AddressBits) -> bool {
        self.area != other.area || self.last.0 < other.first
    }
}

/// The sizes of addresses by their letters, in bits.
const SIZES: [(u8, u64); 5] = [(b'X', 1), (b'B', 8), (b'W', 16), (b'D', 32), (b'L', 64)];

fn bits(size: u8) -> Option<u64> {
    let known = SIZES.iter().find(|(letter, _)| *letter == size)?;
    Some(known.1)
}

#[cfg(test)]
mod tests {
    use super::AddressBits;

    fn of(address: &str) -> AddressBits {
        AddressBits::of(address).expect("an address")
    }

    #[test]
    fn areas() {
        for (outer, inner) in [
            ("%IW0", "%IX0.3"),
            ("%IW0", "%IB1"),
            ("%MD1", "%MX7.7"),
            ("%ql2", "%QW8"),
        ] {
            assert!(!of(outer).is_above(of(inner)), "{outer} {inner}");
        }
        for (above, other) in [("%IW0", "%IB2"), ("%IX1.7", "%IW1"), ("%IW0", "%QX0.3")] {
            assert!(of(above).is_above(of(other)), "{above} {other}");
        }
        for address in ["%IX3", "%IW1.2", "%IX0.8", "%IW", "%IW99999999999999999999"] {
            assert_eq!(AddressBits::of(address), None, "{address}");
        }
    }
}
