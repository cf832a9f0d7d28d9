//! The memory of a Click controller: its banks as a table.

use super::address::Address;

/// A bank of addresses.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) enum Bank {
    /// Inputs.
    X,
    /// Outputs.
    Y,
    /// Control relays.
    C,
    /// Bits of timers.
    T,
    /// Bits of counters.
    Ct,
    /// System control relays.
    Sc,
    /// Integers.
    Ds,
    /// Double integers.
    Dd,
    /// Words of 16 bits.
    Dh,
    /// Reals.
    Df,
    /// Inputs as words.
    Xd,
    /// Outputs as words.
    Yd,
    /// Current values of timers.
    Td,
    /// Current values of counters.
    Ctd,
    /// System data.
    Sd,
    /// Characters.
    Txt,
}

/// What an address of a bank holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Kind {
    /// One bit.
    Bit,
    /// A signed integer of 16 bits.
    Int,
    /// A signed integer of 32 bits.
    Int2,
    /// 16 bits, shown as a hexadecimal number.
    Hex,
    /// A real of 32 bits.
    Float,
    /// A character of 7 bits.
    Text,
}

impl Kind {
    /// The elementary type of ladder text that holds the same.
    pub(super) const fn iec(self) -> &'static str {
        match self {
            Kind::Bit => "BOOL",
            Kind::Int => "INT",
            Kind::Int2 => "DINT",
            Kind::Hex => "WORD",
            Kind::Float => "REAL",
            Kind::Text => "STRING[1]",
        }
    }

    /// Whether it is a number that is compared and computed as one.
    pub(super) const fn is_decimal(self) -> bool {
        matches!(self, Kind::Int | Kind::Int2 | Kind::Float)
    }
}

/// Who writes the addresses of a bank.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Writer {
    /// The program.
    Program,
    /// The world outside: inputs.
    World,
    /// The timers and counters themselves.
    Blocks,
    /// The controller; the program only these.
    System(&'static [u16]),
}

/// What there is to know about a bank.
#[derive(Debug)]
pub(super) struct Row {
    pub(super) bank: Bank,
    /// As Click writes it: `DS`.
    pub(super) name: &'static str,
    /// As the DSL writes it: `ds`.
    pub(super) dsl: &'static str,
    pub(super) kind: Kind,
    /// The first and the last number of each row of addresses that exists.
    pub(super) numbers: &'static [(u16, u16)],
    /// Whether the values outlast a loss of power, unless a project says otherwise.
    pub(super) retentive: bool,
    pub(super) writer: Writer,
    /// How many digits a number has at least in Click's spelling.
    pub(super) digits: usize,
}

/// The inputs and outputs of the CPU's two slots and of up to eight modules.
const POINTS: &[(u16, u16)] = &[
    (1, 16),
    (21, 36),
    (101, 116),
    (201, 216),
    (301, 316),
    (401, 416),
    (501, 516),
    (601, 616),
    (701, 716),
    (801, 816),
];

const SC_WRITTEN: &[u16] = &[50, 51, 53, 55, 60, 61, 65, 66, 67, 75, 76, 120, 121];
const SD_WRITTEN: &[u16] = &[
    29, 31, 32, 34, 35, 36, 40, 41, 42, 50, 51, 60, 61, 106, 107, 108, 112, 113, 114, 140, 141, 142, 143,
    144, 145, 146, 147, 214, 215,
];

/// All banks. Source: Click's address table, as `ladder`'s book has it on the page on Click.
pub(super) const BANKS: &[Row] = &[
    row(Bank::X, "X", "x", Kind::Bit, POINTS, false, Writer::World, 3),
    row(Bank::Y, "Y", "y", Kind::Bit, POINTS, false, Writer::Program, 3),
    row(
        Bank::C,
        "C",
        "c",
        Kind::Bit,
        &[(1, 2000)],
        false,
        Writer::Program,
        1,
    ),
    row(
        Bank::T,
        "T",
        "t",
        Kind::Bit,
        &[(1, 500)],
        false,
        Writer::Blocks,
        1,
    ),
    row(
        Bank::Ct,
        "CT",
        "ct",
        Kind::Bit,
        &[(1, 250)],
        true,
        Writer::Blocks,
        1,
    ),
    row(
        Bank::Sc,
        "SC",
        "sc",
        Kind::Bit,
        &[(1, 1000)],
        false,
        Writer::System(SC_WRITTEN),
        1,
    ),
    row(
        Bank::Ds,
        "DS",
        "ds",
        Kind::Int,
        &[(1, 4500)],
        true,
        Writer::Program,
        1,
    ),
    row(
        Bank::Dd,
        "DD",
        "dd",
        Kind::Int2,
        &[(1, 1000)],
        true,
        Writer::Program,
        1,
    ),
    row(
        Bank::Dh,
        "DH",
        "dh",
        Kind::Hex,
        &[(1, 500)],
        true,
        Writer::Program,
        1,
    ),
    row(
        Bank::Df,
        "DF",
        "df",
        Kind::Float,
        &[(1, 500)],
        true,
        Writer::Program,
        1,
    ),
    row(
        Bank::Xd,
        "XD",
        "xd",
        Kind::Hex,
        &[(0, 8)],
        false,
        Writer::World,
        1,
    ),
    row(
        Bank::Yd,
        "YD",
        "yd",
        Kind::Hex,
        &[(0, 8)],
        false,
        Writer::Program,
        1,
    ),
    row(
        Bank::Td,
        "TD",
        "td",
        Kind::Int,
        &[(1, 500)],
        false,
        Writer::Program,
        1,
    ),
    row(
        Bank::Ctd,
        "CTD",
        "ctd",
        Kind::Int2,
        &[(1, 250)],
        true,
        Writer::Program,
        1,
    ),
    row(
        Bank::Sd,
        "SD",
        "sd",
        Kind::Int,
        &[(1, 1000)],
        false,
        Writer::System(SD_WRITTEN),
        1,
    ),
    row(
        Bank::Txt,
        "TXT",
        "txt",
        Kind::Text,
        &[(1, 1000)],
        true,
        Writer::Program,
        1,
    ),
];

#[allow(clippy::too_many_arguments, reason = "it is a row of a table")]
const fn row(
    bank: Bank,
    name: &'static str,
    dsl: &'static str,
    kind: Kind,
    numbers: &'static [(u16, u16)],
    retentive: bool,
    writer: Writer,
    digits: usize,
) -> Row {
    Row {
        bank,
        name,
        dsl,
        kind,
        numbers,
        retentive,
        writer,
        digits,
    }
}

impl Bank {
    /// What there is to know about it.
    pub(super) fn row(self) -> &'static Row {
        // The rows are in the order of the variants; a test checks it.
        &BANKS[self as usize]
    }

    /// The bank that Click writes so, whatever the case: `DS`.
    pub(super) fn named(name: &str) -> Option<Bank> {
        let row = BANKS.iter().find(|row| row.name.eq_ignore_ascii_case(name))?;
        Some(row.bank)
    }

    /// What its array is called in ladder text: as Click calls it, where that is not a word of the language.
    pub(super) fn array(self) -> &'static str {
        match self {
            Bank::Ctd => "CTD_values",
            bank => bank.row().name,
        }
    }

    /// The bank whose array has this name, whatever the case.
    pub(super) fn of_array(name: &str) -> Option<Bank> {
        let row = BANKS
            .iter()
            .find(|row| row.bank.array().eq_ignore_ascii_case(name))?;
        Some(row.bank)
    }

    /// The bank that the DSL writes so: `ds`.
    pub(super) fn of_dsl(name: &str) -> Option<Bank> {
        let row = BANKS.iter().find(|row| row.dsl == name)?;
        Some(row.bank)
    }

    pub(super) fn kind(self) -> Kind {
        self.row().kind
    }

    /// Whether there is an address with this number.
    pub(super) fn has(self, number: u16) -> bool {
        let mut rows = self.row().numbers.iter();
        Address { bank: self, number }.is_upper()
            || rows.any(|(first, last)| (*first..=*last).contains(&number))
    }

    /// The largest number.
    pub(super) fn last(self) -> u16 {
        self.row().numbers.last().map_or(0, |(_, last)| *last)
    }

    /// The numbers in words: `1 to 16, 21 to 36 ..`.
    pub(super) fn extent(self) -> String {
        match self.row().numbers {
            [(first, last)] if self == Bank::Xd || self == Bank::Yd => format!("{first} to {last}, and 0u"),
            [(first, last)] => format!("{first} to {last}"),
            _ => "1 to 16, 21 to 36, and 101 to 116 up to 801 to 816".to_owned(),
        }
    }

    /// Whether the program may write the address with this number. The current values of timers and counters it
    /// writes by copying, the bits never.
    pub(super) fn is_writable(self, number: u16) -> bool {
        match self.row().writer {
            Writer::Program => true,
            Writer::World | Writer::Blocks => false,
            Writer::System(written) => written.contains(&number),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_bank_has_its_row() {
        for row in BANKS {
            assert_eq!(row.bank.row().name, row.name);
            assert_eq!(Bank::named(row.name), Some(row.bank));
            assert_eq!(Bank::of_dsl(row.dsl), Some(row.bank));
        }
        assert_eq!(BANKS.len(), Bank::Txt as usize + 1);
    }

    #[test]
    fn inputs_and_outputs_have_gaps() {
        for (number, there) in [
            (0, false),
            (1, true),
            (16, true),
            (17, false),
            (21, true),
            (816, true),
            (817, false),
        ] {
            assert_eq!(Bank::X.has(number), there, "X{number}");
        }
        assert!(Bank::Xd.has(0) && !Bank::Ds.has(0));
        assert!(Bank::Sc.is_writable(50) && !Bank::Sc.is_writable(1));
    }
}
