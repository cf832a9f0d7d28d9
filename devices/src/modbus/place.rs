//! Where something is: a table and a number in it.

use std::fmt;

/// The four tables of the protocol.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Table {
    /// Bits that clients read and write: functions 1, 5 and 15.
    Coil,
    /// Bits that clients read: function 2.
    Discrete,
    /// Words that clients read: function 4.
    Input,
    /// Words that clients read and write: functions 3, 6 and 16.
    Holding,
}

impl Table {
    /// All, in the order of the numbers that people know them by: 0, 1, 3, 4.
    pub const ALL: [Table; 4] = [Table::Coil, Table::Discrete, Table::Input, Table::Holding];

    /// What it is called where places are written.
    pub fn name(self) -> &'static str {
        match self {
            Table::Coil => "coil",
            Table::Discrete => "discrete",
            Table::Input => "input",
            Table::Holding => "holding",
        }
    }

    /// Whether it holds bits; the others hold words of 16 bits.
    pub fn is_of_bits(self) -> bool {
        matches!(self, Table::Coil | Table::Discrete)
    }

    /// So many bits, or words, are read with one request.
    pub(super) fn most_read(self) -> usize {
        if self.is_of_bits() { 2000 } else { 125 }
    }

    /// So many are written with one.
    pub(super) fn most_written(self) -> usize {
        if self.is_of_bits() { 1968 } else { 123 }
    }

    /// Whether clients may write to it at all.
    pub fn is_written(self) -> bool {
        matches!(self, Table::Coil | Table::Holding)
    }
}

/// A table and a number in it, from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Place {
    /// The table.
    pub table: Table,
    /// The number that the protocol sends.
    pub number: u16,
}

impl Place {
    /// Reads `holding 100`.
    ///
    /// # Errors
    /// It is not a place, with what to write.
    pub fn parse(text: &str) -> Result<Place, String> {
        const FORM: &str = "a place is a table and a number from 0, for example `holding 100`; the tables are coil, discrete, input and holding";
        let (table, number) = text.trim().split_once(' ').ok_or(FORM)?;
        let named = |own: &Table| own.name().eq_ignore_ascii_case(table);
        let table = Table::ALL.into_iter().find(named).ok_or(FORM)?;
        let number = number.trim();
        let parsed = number.parse();
        let number =
            parsed.map_err(|_| format!("{number} is not a number of a place: they are from 0 to 65535"))?;
        Ok(Place { table, number })
    }

    /// Reads `holding 100`, or a run of places: `discrete 0..7`, the last of which comes second.
    ///
    /// # Errors
    /// It is neither, with what to write.
    pub(super) fn parse_run(text: &str) -> Result<(Place, Option<u16>), String> {
        let Some((first, last)) = text.split_once("..") else {
            return Ok((Place::parse(text)?, None));
        };
        let first = Place::parse(first)?;
        let last = Place::parse(&format!("{} {}", first.table.name(), last.trim()))?.number;
        if last < first.number {
            return Err(format!("{text} has no places: write the smaller number first"));
        }
        Ok((first, Some(last)))
    }

    /// Where a direct address is, as `OpenPLC` has it: `%QX1.2` is coil 10. None: it has no place there.
    pub(super) fn of_address(address: &str) -> Option<Place> {
        let address = address.trim().to_ascii_uppercase();
        let rest = address.strip_prefix('%')?;
        let (area, rest) = rest.split_at_checked(1)?;
        let is_bit = rest.starts_with('X') || rest.starts_with(|c: char| c.is_ascii_digit());
        let (width, numbers) = if is_bit {
            ("X", rest.trim_start_matches('X'))
        } else {
            rest.split_at_checked(1)?
        };
        let (first, second) = match numbers.split_once('.') {
            Some((byte, bit)) => (byte.parse::<u32>().ok()?, Some(bit.parse::<u32>().ok()?)),
            None => (numbers.parse().ok()?, None),
        };
        let bit = || {
            second
                .filter(|bit| *bit < 8)
                .map(|bit| first.checked_mul(8)?.checked_add(bit))
        };
        // The areas of holding registers follow one another.
        let (table, number) = match (area, width) {
            ("Q", "X") => (Table::Coil, bit()??),
            ("I", "X") => (Table::Discrete, bit()??),
            ("I", "W") => (Table::Input, first),
            ("Q", "W") => (Table::Holding, first),
            ("M", "W") => (Table::Holding, first.checked_add(1024)?),
            ("M", "D") => (Table::Holding, first.checked_mul(2)?.checked_add(2048)?),
            ("M", "L") => (Table::Holding, first.checked_mul(4)?.checked_add(4096)?),
            _ => return None,
        };
        let number = u16::try_from(number).ok()?;
        Some(Place { table, number })
    }

    /// The same place seen from the other side: what the program reads is written by clients, and the reverse.
    pub(super) fn mirrored(self) -> Place {
        let table = match self.table {
            Table::Coil => Table::Discrete,
            Table::Discrete => Table::Coil,
            Table::Input => Table::Holding,
            Table::Holding => Table::Input,
        };
        Place { table, ..self }
    }

    /// The number in the manuals that count from 1 and begin with the table's own: 40101 for holding 100.
    pub fn counted_from_one(self) -> u32 {
        let table = match self.table {
            Table::Coil => 0,
            Table::Discrete => 1,
            Table::Input => 3,
            Table::Holding => 4,
        };
        let number = u32::from(self.number) + 1;
        // With five digits up to 9999, with six above.
        table * if number < 10_000 { 10_000 } else { 100_000 } + number
    }
}

/// The direct address after one: `%IX11.0` after `%IX10.7`. None: it is not an address, or the last one.
pub(super) fn address_after(address: &str) -> Option<String> {
    let digits = address.rfind(|letter: char| !letter.is_ascii_digit())? + 1;
    let (before, last) = address.split_at(digits);
    let last: u32 = last.parse().ok()?;
    match before.strip_suffix('.') {
        Some(byte) if last == 7 => Some(format!("{}.0", address_after(byte)?)),
        _ => Some(format!("{before}{}", last.checked_add(1)?)),
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.table.name(), self.number)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_written_as_words() {
        let read =
            |text: &str| Place::parse(text).map(|place| format!("{place} = {}", place.counted_from_one()));
        assert_eq!(read("holding 100").as_deref(), Ok("holding 100 = 40101"));
        assert_eq!(read("  Coil   0").as_deref(), Ok("coil 0 = 1"));
        assert_eq!(read("input 65535").as_deref(), Ok("input 65535 = 365536"));
        assert_eq!(read("discrete 9").as_deref(), Ok("discrete 9 = 10010"));
        for wrong in [
            "",
            "holding",
            "register 4",
            "holding 65536",
            "holding -1",
            "holding 4x",
        ] {
            assert!(read(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn places_are_written_as_runs() {
        let read = |text: &str| Place::parse_run(text).map(|(place, last)| (place.to_string(), last));
        assert_eq!(read("discrete 0..7"), Ok(("discrete 0".to_owned(), Some(7))));
        assert_eq!(read("holding 5 .. 5"), Ok(("holding 5".to_owned(), Some(5))));
        assert_eq!(read("holding 5"), Ok(("holding 5".to_owned(), None)));
        for wrong in ["holding 7..5", "holding ..5", "holding 5..", "holding 0..65536"] {
            assert!(read(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn addresses_follow_one_another() {
        let after = |address: &str| address_after(address);
        assert_eq!(after("%IX10.6").as_deref(), Some("%IX10.7"));
        assert_eq!(after("%IX10.7").as_deref(), Some("%IX11.0"));
        assert_eq!(after("%QW9").as_deref(), Some("%QW10"));
        for none in ["%QW4294967295", "%QW", "level", ""] {
            assert_eq!(after(none), None, "{none}");
        }
    }

    #[test]
    fn addresses_are_where_openplc_has_them() {
        let at = |address: &str| Place::of_address(address).map(|place| place.to_string());
        for (address, place) in [
            ("%QX0.0", "coil 0"),
            ("%qx1.2", "coil 10"),
            ("%Q1.2", "coil 10"),
            ("%IX100.0", "discrete 800"),
            ("%IW3", "input 3"),
            ("%QW3", "holding 3"),
            ("%MW3", "holding 1027"),
            ("%MD3", "holding 2054"),
            ("%ML3", "holding 4108"),
        ] {
            assert_eq!(at(address).as_deref(), Some(place), "{address}");
        }
        for none in [
            "%MX0.0",
            "%QB1",
            "%QX1.8",
            "%QX1",
            "%ML65535",
            "%",
            "x",
            "%QW",
            "%Q",
            "%IX99999999999.0",
        ] {
            assert_eq!(at(none), None, "{none}");
        }
    }
}
