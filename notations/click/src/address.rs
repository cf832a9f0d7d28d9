//! Addresses, names of addresses, and ranges of them, as Click writes them (`X001`, `C1..C8`) and as the DSL does
//! (`x[1]`, `c[1:9]`, `c.Start`).

use super::bank::Bank;
use std::fmt;

/// An address by its number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct Address {
    pub(super) bank: Bank,
    /// It need not exist: see [`Bank::has`].
    pub(super) number: u16,
}

/// As Click writes it: `X001`, `DS1`.
impl fmt::Display for Address {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let row = self.bank.row();
        if self.is_upper() {
            return write!(f, "{}0u", row.name);
        }
        write!(f, "{}{:0width$}", row.name, self.number, width = row.digits)
    }
}

/// The number that stands for `0u`: the upper byte of the CPU's own word, `XD0u` and `YD0u`.
const UPPER: u16 = u16::MAX;

impl Address {
    /// Whether it is the upper byte of the CPU's own inputs or outputs.
    pub(super) const fn is_upper(self) -> bool {
        matches!(self.bank, Bank::Xd | Bank::Yd) && self.number == UPPER
    }

    /// An address as Click writes it, leading zeros or not: `X001`, `x1`. Whether it exists is not asked.
    pub(super) fn parse(text: &str) -> Option<Address> {
        let digits = text.find(|c: char| c.is_ascii_digit())?;
        let (bank, number) = text.split_at(digits);
        if let Some(bank @ (Bank::Xd | Bank::Yd)) = Bank::named(bank)
            && number == "0u"
        {
            return Some(Address { bank, number: UPPER });
        }
        if number.len() > 5 || !number.bytes().all(|byte| byte.is_ascii_digit()) {
            return None;
        }
        Some(Address {
            bank: Bank::named(bank)?,
            number: number.parse().ok().filter(|number| *number != UPPER)?,
        })
    }
}

/// An address, by its number or by its nickname.
#[derive(Debug, Clone, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct Tag {
    pub(super) bank: Bank,
    pub(super) which: Which,
}

/// How an address is named.
#[derive(Debug, Clone, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) enum Which {
    /// Its number.
    Number(u16),
    /// Its nickname.
    Nickname(String),
}

impl Tag {
    pub(super) const fn number(bank: Bank, number: u16) -> Tag {
        Tag {
            bank,
            which: Which::Number(number),
        }
    }

    pub(super) fn nickname(bank: Bank, name: impl Into<String>) -> Tag {
        Tag {
            bank,
            which: Which::Nickname(name.into()),
        }
    }

    /// The address, if it is named by its number.
    pub(super) const fn address(&self) -> Option<Address> {
        match self.which {
            Which::Number(number) => Some(Address {
                bank: self.bank,
                number,
            }),
            Which::Nickname(_) => None,
        }
    }

    /// As the DSL writes it: `ds[1]`, `ds.Level`.
    pub(super) fn dsl(&self) -> String {
        let bank = self.bank.row().dsl;
        if let Some(address) = self.address().filter(|address| address.is_upper()) {
            return format!("{bank}.{address}");
        }
        match &self.which {
            Which::Number(number) => format!("{bank}[{number}]"),
            Which::Nickname(name) => format!("{bank}.{name}"),
        }
    }
}

impl From<Address> for Tag {
    fn from(address: Address) -> Tag {
        Tag::number(address.bank, address.number)
    }
}

/// Consecutive addresses of one bank, both ends included. Only a shift register may run downwards.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) struct Span {
    pub(super) bank: Bank,
    pub(super) first: u16,
    pub(super) last: u16,
}

impl Span {
    /// How many addresses it has.
    pub(super) const fn len(&self) -> usize {
        self.first.abs_diff(self.last) as usize + 1
    }

    /// Whether every address in it exists.
    pub(super) fn exists(&self) -> bool {
        let (low, high) = self.bounds();
        let mut rows = self.bank.row().numbers.iter();
        rows.any(|(first, last)| *first <= low && high <= *last)
    }

    /// The smallest and the largest number.
    pub(super) fn bounds(&self) -> (u16, u16) {
        (self.first.min(self.last), self.first.max(self.last))
    }

    /// Whether it holds an address.
    pub(super) fn holds(&self, address: Address) -> bool {
        let (low, high) = self.bounds();
        self.bank == address.bank && (low..=high).contains(&address.number)
    }

    /// As the DSL writes it: `ds[1:5]` for `DS1..DS4`. A slice that runs downwards has its step: `c[8:0:-1]`.
    pub(super) fn dsl(&self) -> String {
        let bank = self.bank.row().dsl;
        let first = self.first;
        match self.last {
            last if first <= last => format!("{bank}[{first}:{}]", u32::from(last) + 1),
            // After 0 there is nothing a slice could name.
            0 => format!("{bank}[{first}::-1]"),
            last => format!("{bank}[{first}:{}:-1]", last - 1),
        }
    }

    /// A range as ladder text writes it: `C[1..8]`.
    pub(super) fn in_text(text: &str) -> Option<Span> {
        let (bank, inside) = text.strip_suffix(']')?.split_once('[')?;
        let (first, last) = inside.split_once("..")?;
        Some(Span {
            bank: Bank::named(bank)?,
            first: first.parse().ok()?,
            last: last.parse().ok()?,
        })
    }

    /// A range as Click's grid writes it: `C1..C8`.
    pub(super) fn parse(text: &str) -> Option<Span> {
        let (first, last) = text.split_once("..")?;
        let (first, last) = (Address::parse(first.trim())?, Address::parse(last.trim())?);
        (first.bank == last.bank).then_some(Span {
            bank: first.bank,
            first: first.number,
            last: last.number,
        })
    }
}

/// As Click's grid writes it: `C1..C8`.
impl fmt::Display for Span {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let end = |number| Address {
            bank: self.bank,
            number,
        };
        write!(f, "{}..{}", end(self.first), end(self.last))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_are_read_and_written() {
        for (text, shown) in [
            ("X1", "X001"),
            ("x001", "X001"),
            ("DS4500", "DS4500"),
            ("CTD7", "CTD7"),
            ("XD0", "XD0"),
            ("yd0u", "YD0u"),
        ] {
            assert_eq!(Address::parse(text).unwrap().to_string(), shown);
        }
        for text in [
            "", "X", "1", "Q1", "X1a", "DS99999", "DS 1", "XD1u", "XD65535", "X0u",
        ] {
            assert_eq!(Address::parse(text), None, "{text}");
        }
    }

    #[test]
    fn slices_leave_out_their_end() {
        let span = Span::parse("DS1..DS4").unwrap();
        assert_eq!((span.len(), span.dsl().as_str()), (4, "ds[1:5]"));
        let down = Span::parse("C8..C1").unwrap();
        assert_eq!(
            (down.len(), down.dsl().as_str(), down.to_string().as_str()),
            (8, "c[8:0:-1]", "C8..C1")
        );
        assert!(!Span::parse("X16..X21").unwrap().exists());
        assert!(Span::parse("X21..X36").unwrap().exists());
        assert_eq!(Span::parse("C1..DS4"), None);
    }
}
