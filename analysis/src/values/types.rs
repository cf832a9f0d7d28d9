//! The types of LANGUAGE §4 and how values pass between them (§5.2).

use crate::values::compound::{EnumId, TypeId};
use ladder_instructions::{Semantics, StateType, Width};
use std::fmt;

/// An elementary type.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Scalar {
    /// One bit.
    Bool,
    /// Bit string of 8.
    Byte,
    /// Bit string of 16.
    Word,
    /// Bit string of 32.
    Dword,
    /// Bit string of 64.
    Lword,
    /// Signed, 8 bits.
    Sint,
    /// Signed, 16 bits.
    Int,
    /// Signed, 32 bits.
    Dint,
    /// Signed, 64 bits.
    Lint,
    /// Unsigned, 8 bits.
    Usint,
    /// Unsigned, 16 bits.
    Uint,
    /// Unsigned, 32 bits.
    Udint,
    /// Unsigned, 64 bits.
    Ulint,
    /// Floating point, 32 bits.
    Real,
    /// Floating point, 64 bits.
    Lreal,
    /// A duration in nanoseconds, signed, 64 bits.
    Time,
    /// A day, in nanoseconds since 1970-01-01.
    Date,
    /// A time of day, in nanoseconds since midnight.
    Tod,
    /// A day and time, in nanoseconds since 1970-01-01.
    Dt,
    /// Text of at most this many bytes.
    String(u16),
    /// One of the values of an enumeration: the number of a DINT.
    Enum(EnumId),
}

/// The length of a STRING without `[n]`, as IEC 61131-3 systems commonly have it.
pub const DEFAULT_STRING: u16 = 80;

impl Scalar {
    /// The type that a name in a declaration means; the name is compared without case.
    pub fn from_name(name: &str) -> Option<Scalar> {
        // Each declaration asks: a text of its own for each would take as long as all the rest here.
        let mut longest = *b"DATE_AND_TIME";
        let upper = longest.get_mut(..name.len())?;
        upper.copy_from_slice(name.as_bytes());
        upper.make_ascii_uppercase();
        Some(match &*upper {
            b"BOOL" => Scalar::Bool,
            b"BYTE" => Scalar::Byte,
            b"WORD" => Scalar::Word,
            b"DWORD" => Scalar::Dword,
            b"LWORD" => Scalar::Lword,
            b"SINT" => Scalar::Sint,
            b"INT" => Scalar::Int,
            b"DINT" => Scalar::Dint,
            b"LINT" => Scalar::Lint,
            b"USINT" => Scalar::Usint,
            b"UINT" => Scalar::Uint,
            b"UDINT" => Scalar::Udint,
            b"ULINT" => Scalar::Ulint,
            b"REAL" => Scalar::Real,
            b"LREAL" => Scalar::Lreal,
            b"TIME" => Scalar::Time,
            b"DATE" => Scalar::Date,
            b"TOD" | b"TIME_OF_DAY" => Scalar::Tod,
            b"DT" | b"DATE_AND_TIME" => Scalar::Dt,
            b"STRING" => Scalar::String(DEFAULT_STRING),
            _ => return None,
        })
    }

    /// The type of a counter, and of a tag that nothing else types.
    pub const fn integer_of(semantics: &Semantics) -> Scalar {
        match semantics.integers {
            Width::Bits16 => Scalar::Int,
            Width::Bits32 => Scalar::Dint,
            Width::Bits64 => Scalar::Lint,
        }
    }

    /// The type of a real that nothing else types.
    pub const fn real_of(semantics: &Semantics) -> Scalar {
        match semantics.reals {
            Width::Bits64 => Scalar::Lreal,
            _ => Scalar::Real,
        }
    }

    /// The type's name in capitals; of an enumeration only that it is one.
    pub const fn name(self) -> &'static str {
        match self {
            Scalar::Bool => "BOOL",
            Scalar::Byte => "BYTE",
            Scalar::Word => "WORD",
            Scalar::Dword => "DWORD",
            Scalar::Lword => "LWORD",
            Scalar::Sint => "SINT",
            Scalar::Int => "INT",
            Scalar::Dint => "DINT",
            Scalar::Lint => "LINT",
            Scalar::Usint => "USINT",
            Scalar::Uint => "UINT",
            Scalar::Udint => "UDINT",
            Scalar::Ulint => "ULINT",
            Scalar::Real => "REAL",
            Scalar::Lreal => "LREAL",
            Scalar::Time => "TIME",
            Scalar::Date => "DATE",
            Scalar::Tod => "TOD",
            Scalar::Dt => "DT",
            Scalar::String(_) => "STRING",
            Scalar::Enum(_) => "enumeration",
        }
    }

    /// `SINT` to `ULINT`.
    pub const fn is_integer(self) -> bool {
        self.is_signed() || matches!(self, Scalar::Usint | Scalar::Uint | Scalar::Udint | Scalar::Ulint)
    }

    /// `SINT INT DINT LINT`.
    pub const fn is_signed(self) -> bool {
        matches!(self, Scalar::Sint | Scalar::Int | Scalar::Dint | Scalar::Lint)
    }

    /// `BYTE WORD DWORD LWORD`.
    pub const fn is_bits(self) -> bool {
        matches!(self, Scalar::Byte | Scalar::Word | Scalar::Dword | Scalar::Lword)
    }

    /// `REAL LREAL`.
    pub const fn is_real(self) -> bool {
        matches!(self, Scalar::Real | Scalar::Lreal)
    }

    /// Integers and reals.
    pub const fn is_number(self) -> bool {
        self.is_integer() || self.is_real()
    }

    /// `DATE TOD DT`.
    pub const fn is_date(self) -> bool {
        matches!(self, Scalar::Date | Scalar::Tod | Scalar::Dt)
    }

    /// One of the values of an enumeration.
    pub const fn is_enumeration(self) -> bool {
        matches!(self, Scalar::Enum(_))
    }

    /// `STRING`.
    pub const fn is_string(self) -> bool {
        matches!(self, Scalar::String(_))
    }

    /// Width in bits of integers, bit strings and BOOL; 64 for the rest.
    pub const fn width(self) -> u32 {
        match self {
            Scalar::Bool => 1,
            Scalar::Byte | Scalar::Sint | Scalar::Usint => 8,
            Scalar::Word | Scalar::Int | Scalar::Uint => 16,
            Scalar::Dword | Scalar::Dint | Scalar::Udint | Scalar::Real | Scalar::Enum(_) => 32,
            _ => 64,
        }
    }

    /// The smallest and largest value of an integer or bit string.
    pub const fn bounds(self) -> Option<(i128, i128)> {
        if self.is_signed() {
            let half = 1i128 << (self.width() - 1);
            return Some((-half, half - 1));
        }
        if self.is_integer() || self.is_bits() {
            return Some((0, (1i128 << self.width()) - 1));
        }
        None
    }
}

impl fmt::Display for Scalar {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Scalar::String(length) if *length != DEFAULT_STRING => write!(f, "STRING[{length}]"),
            Scalar::Enum(id) => f.write_str(&id.get().name),
            other => f.write_str(other.name()),
        }
    }
}

/// The type of a tag.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Type {
    /// One value.
    Scalar(Scalar),
    /// The state of a timer, counter or bistable.
    State(StateType),
    /// `ARRAY[first..last] OF element`; `first <= last`.
    Array {
        /// Index of the first element.
        first: i64,
        /// Index of the last element.
        last: i64,
        /// Type of each element.
        element: Scalar,
    },
    /// A structure, any other array, the state of a user-defined block.
    Compound(TypeId),
}

impl Type {
    /// BOOL.
    pub const BOOL: Type = Type::Scalar(Scalar::Bool);

    /// The elementary type that it is, or that its elements are.
    pub const fn element_scalar(self) -> Option<Scalar> {
        match self {
            Type::Scalar(scalar) | Type::Array { element: scalar, .. } => Some(scalar),
            Type::State(_) | Type::Compound(_) => None,
        }
    }

    /// The elementary type, if it is one.
    pub const fn scalar(self) -> Option<Scalar> {
        match self {
            Type::Scalar(scalar) => Some(scalar),
            _ => None,
        }
    }
}

impl fmt::Display for Type {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Type::Scalar(scalar) => scalar.fmt(f),
            Type::State(state) => f.write_str(state.name()),
            Type::Array { first, last, element } => write!(f, "ARRAY[{first}..{last}] OF {element}"),
            Type::Compound(id) => id.fmt(f),
        }
    }
}

/// Whether a value of one type passes to another without `[TYP]` (LANGUAGE §5.2). Each type passes to itself;
/// a string to a string of any length.
pub fn passes(from: Scalar, to: Scalar) -> bool {
    use Scalar::*;
    if from == to || (from.is_string() && to.is_string()) {
        return true;
    }
    if from.is_bits() && to.is_bits() {
        return from.width() <= to.width();
    }
    // Bits kept, only at the same width: at another width zero and sign extension would differ.
    if (from.is_bits() && to.is_integer()) || (from.is_integer() && to.is_bits()) {
        return from.width() == to.width();
    }
    if from.is_integer() && to.is_integer() {
        return match (from.is_signed(), to.is_signed()) {
            (true, true) | (false, false) => from.width() <= to.width(),
            (false, true) => from.width() < to.width(),
            (true, false) => false,
        };
    }
    match to {
        Real => matches!(from, Sint | Int | Usint | Uint),
        Lreal => matches!(from, Sint | Int | Usint | Uint | Dint | Udint | Real),
        _ => false,
    }
}

/// Whether `[TYP]` makes a value of one type into another. Numbers, BOOL and STRING go to and from all types; a
/// duration is not a point in time, and a day no time of day.
pub fn converts(from: Scalar, to: Scalar) -> bool {
    if from.is_enumeration() || to.is_enumeration() {
        let other = if from.is_enumeration() { to } else { from };
        return other.is_integer() || other.is_string();
    }
    let is_clock = |ty: Scalar| ty == Scalar::Time || ty.is_date();
    let both = is_clock(from) && is_clock(to);
    !both
        || from == to
        || matches!(
            (from, to),
            (Scalar::Dt, Scalar::Date | Scalar::Tod) | (Scalar::Date, Scalar::Dt)
        )
}

/// The type in which two operands of a comparison are compared: the smallest of the chains that holds both.
/// None: there is none. Two integers can be compared all the same, by value; others cannot.
pub fn common(a: Scalar, b: Scalar) -> Option<Scalar> {
    use Scalar::*;
    // Each passes to the other, but only the longer holds both.
    if let (String(one), String(other)) = (a, b) {
        return Some(String(one.max(other)));
    }
    if passes(a, b) {
        return Some(b);
    }
    if passes(b, a) {
        return Some(a);
    }
    // Neither holds the other, but a third does: DINT and REAL meet in LREAL, BYTE and INT in WORD. Of two of one
    // width (USINT and WORD: INT or UINT) the integer's own sign decides. INT and UINT meet in DINT: both pass to WORD,
    // which does not hold their values.
    let unsigned = [a, b].iter().any(|ty| ty.is_integer() && !ty.is_signed());
    let integers = a.is_integer() && b.is_integer();
    MEETING
        .into_iter()
        .filter(|&ty| passes(a, ty) && passes(b, ty) && (ty.is_integer() || !integers))
        .min_by_key(|ty| (ty.width(), ty.is_signed() == unsigned))
}

/// Whether values of two types can be compared: integers always, by value.
pub fn are_comparable(a: Scalar, b: Scalar) -> bool {
    (a.is_integer() && b.is_integer()) || common(a, b).is_some()
}

/// Where two types can meet that are not one of them.
const MEETING: [Scalar; 10] = [
    Scalar::Word,
    Scalar::Int,
    Scalar::Uint,
    Scalar::Dword,
    Scalar::Dint,
    Scalar::Udint,
    Scalar::Lword,
    Scalar::Lint,
    Scalar::Ulint,
    Scalar::Lreal,
];

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: [Scalar; 20] = [
        Scalar::Bool,
        Scalar::Byte,
        Scalar::Word,
        Scalar::Dword,
        Scalar::Lword,
        Scalar::Sint,
        Scalar::Int,
        Scalar::Dint,
        Scalar::Lint,
        Scalar::Usint,
        Scalar::Uint,
        Scalar::Udint,
        Scalar::Ulint,
        Scalar::Real,
        Scalar::Lreal,
        Scalar::Time,
        Scalar::Date,
        Scalar::Tod,
        Scalar::Dt,
        Scalar::String(DEFAULT_STRING),
    ];

    /// The whole table of LANGUAGE §5.2, a row for each type that passes to others.
    #[test]
    fn the_chains() {
        let mut table = String::new();
        for from in ALL {
            let to: Vec<&str> = ALL
                .iter()
                .filter(|&&to| to != from && passes(from, to))
                .map(|t| t.name())
                .collect();
            if !to.is_empty() {
                table.push_str(&format!("{from}: {}\n", to.join(" ")));
            }
        }
        expect_test::expect![[r"
            BYTE: WORD DWORD LWORD SINT USINT
            WORD: DWORD LWORD INT UINT
            DWORD: LWORD DINT UDINT
            LWORD: LINT ULINT
            SINT: BYTE INT DINT LINT REAL LREAL
            INT: WORD DINT LINT REAL LREAL
            DINT: DWORD LINT LREAL
            LINT: LWORD
            USINT: BYTE INT DINT LINT UINT UDINT ULINT REAL LREAL
            UINT: WORD DINT LINT UDINT ULINT REAL LREAL
            UDINT: DWORD LINT ULINT LREAL
            ULINT: LWORD
            REAL: LREAL
        "]]
        .assert_eq(&table);
    }

    #[test]
    fn comparisons_meet() {
        assert_eq!(common(Scalar::Dint, Scalar::Real), Some(Scalar::Lreal));
        assert_eq!(common(Scalar::Int, Scalar::Dint), Some(Scalar::Dint));
        assert_eq!(common(Scalar::Usint, Scalar::Sint), Some(Scalar::Int));
        assert_eq!(common(Scalar::Uint, Scalar::Int), Some(Scalar::Dint));
        assert_eq!(common(Scalar::Dint, Scalar::Udint), Some(Scalar::Lint));
        assert_eq!(common(Scalar::Sint, Scalar::Ulint), None);
        assert_eq!(common(Scalar::Lint, Scalar::Real), None);
        assert_eq!(common(Scalar::Time, Scalar::Dint), None);
        assert_eq!(common(Scalar::Byte, Scalar::Dword), Some(Scalar::Dword));
        let (short, long) = (Scalar::String(1), Scalar::String(80));
        assert_eq!(common(short, long), Some(long));
        assert_eq!(common(long, short), Some(long));
    }
}
