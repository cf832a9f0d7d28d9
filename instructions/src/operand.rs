//! What an operand of an instruction is: its name, direction, and what may be in its place.

use crate::profile::Profiles;

/// One operand of an instruction.
#[derive(Debug, Clone, Copy)]
pub struct Operand {
    /// The name used in signatures, and written before `:=` for a named one.
    pub name: &'static str,
    /// Read, written, or both.
    pub direction: Direction,
    /// What may be here.
    pub accepts: Accepts,
    /// Whether and how it must be given.
    pub presence: Presence,
    /// One line for hover and completion.
    pub doc: &'static str,
    /// The profiles that know it (LANGUAGE §5.8).
    pub profiles: Profiles,
}

impl Operand {
    /// A required operand that the block reads.
    pub(crate) const fn input(name: &'static str, accepts: Accepts, doc: &'static str) -> Self {
        Self {
            name,
            direction: Direction::In,
            accepts,
            presence: Presence::Required,
            doc,
            profiles: Profiles::ALL,
        }
    }

    /// A required operand that the block writes.
    pub(crate) const fn output(name: &'static str, accepts: Accepts, doc: &'static str) -> Self {
        Self {
            name,
            direction: Direction::Out,
            accepts,
            presence: Presence::Required,
            doc,
            profiles: Profiles::ALL,
        }
    }

    /// A required operand that the block reads and writes.
    pub(crate) const fn in_out(name: &'static str, accepts: Accepts, doc: &'static str) -> Self {
        Self {
            name,
            direction: Direction::InOut,
            accepts,
            presence: Presence::Required,
            doc,
            profiles: Profiles::ALL,
        }
    }

    /// The same operand, given by name, and optional.
    pub(crate) const fn named(self) -> Self {
        Self {
            presence: Presence::Named,
            ..self
        }
    }

    /// The same operand, by place, and optional.
    pub(crate) const fn trailing(self) -> Self {
        Self {
            presence: Presence::Trailing,
            ..self
        }
    }

    /// The same operand, given once or more.
    pub(crate) const fn repeated(self) -> Self {
        Self {
            presence: Presence::Repeated { group: 1, least: 1 },
            ..self
        }
    }

    /// The same operand, known to some profiles only.
    pub(crate) const fn known_to(self, profiles: Profiles) -> Self {
        Self { profiles, ..self }
    }

    /// One operand of a pair that is given once or more.
    pub(crate) const fn repeated_pair(self) -> Self {
        Self {
            presence: Presence::Repeated { group: 2, least: 1 },
            ..self
        }
    }

    /// The same operand, given any number of times or not at all.
    pub(crate) const fn repeated_or_none(self) -> Self {
        Self {
            presence: Presence::Repeated { group: 1, least: 0 },
            ..self
        }
    }
}

/// Which way the value goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Direction {
    /// The block reads it.
    In,
    /// The block writes it.
    Out,
    /// The block reads and writes it.
    InOut,
}

/// Whether an operand must be given, and how.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Presence {
    /// By place, always.
    Required,
    /// By place, may be left out from the right (`[SCANTIME]`).
    Trailing,
    /// By place, again and again after the required ones (`...` in LANGUAGE §5, which repeats the last).
    /// `group` operands come and go together (`[PWL]` takes pairs); every operand of the group has this
    /// presence.
    Repeated {
        /// How many operands one repetition has.
        group: u8,
        /// How many repetitions must be given: 1 for most, 0 for the values of `[FMT]`.
        least: u8,
    },
    /// By name: `R := reset`; may be left out.
    Named,
}

/// The block type whose state an operand holds (LANGUAGE §4).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[allow(missing_docs)]
pub enum StateType {
    Ton,
    Tof,
    Tp,
    Rto,
    Rtof,
    Ctu,
    Ctd,
    Ctud,
    Ctc,
    Sr,
    Rs,
}

impl StateType {
    /// All of them, in the order of LANGUAGE §4.
    pub const ALL: [StateType; 11] = [
        StateType::Ton,
        StateType::Tof,
        StateType::Tp,
        StateType::Rto,
        StateType::Rtof,
        StateType::Ctu,
        StateType::Ctd,
        StateType::Ctud,
        StateType::Ctc,
        StateType::Sr,
        StateType::Rs,
    ];

    /// The type's name in capitals.
    pub const fn name(self) -> &'static str {
        match self {
            StateType::Ton => "TON",
            StateType::Tof => "TOF",
            StateType::Tp => "TP",
            StateType::Rto => "RTO",
            StateType::Rtof => "RTOF",
            StateType::Ctu => "CTU",
            StateType::Ctd => "CTD",
            StateType::Ctud => "CTUD",
            StateType::Ctc => "CTC",
            StateType::Sr => "SR",
            StateType::Rs => "RS",
        }
    }

    /// The member that is its output, and the power after its block.
    pub const fn output(self) -> &'static str {
        match self {
            StateType::Sr | StateType::Rs => "Q1",
            _ => "Q",
        }
    }

    /// Whether it is a timer (`TON TOF TP RTO RTOF`).
    pub const fn is_timer(self) -> bool {
        matches!(
            self,
            StateType::Ton | StateType::Tof | StateType::Tp | StateType::Rto | StateType::Rtof
        )
    }

    /// Whether both are timers, both counters, or both the same.
    pub fn is_of_one_sort_with(self, other: StateType) -> bool {
        self == other || (self.is_timer() && other.is_timer()) || (self.is_counter() && other.is_counter())
    }

    /// Whether it is a counter (`CTU CTD CTUD CTC`).
    pub const fn is_counter(self) -> bool {
        matches!(
            self,
            StateType::Ctu | StateType::Ctd | StateType::Ctud | StateType::Ctc
        )
    }
}

/// The types that an instruction's result may have (LANGUAGE §5.2, "Without `[TYP]` a value passes").
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum TypeClass {
    /// Integers and reals.
    Number,
    /// Integers, reals and TIME (ADD, SUB, MIN, MAX, LIMIT, MUL, DIV; dates for ADD and SUB).
    NumberOrTime,
    /// REAL and LREAL.
    Real,
    /// Integers, or bit strings of 8 bits and more.
    BitsOrInteger,
    /// BOOL, bit strings and integers.
    BoolBitsOrInteger,
    /// Any integer.
    Integer,
    /// STRING.
    String,
    /// Any elementary type.
    Any,
}

/// What may be in an operand's place.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Accepts {
    /// A BOOL tag, member or bit; for inputs also a BOOL literal.
    Bool,
    /// As `Bool`, or a range of a BOOL array (`a[3..9]`).
    BoolOrRange,
    /// As `BoolOrRange`, or a timer or counter tag (`(R)`).
    BoolRangeOrState,
    /// A tag of this block type.
    State(StateType),
    /// A tag of any timer or counter type (`(RES)`).
    TimerOrCounter,
    /// The result: a tag of a type in this class. It types the operands that say `Value`.
    Result(TypeClass),
    /// A tag or literal that passes to the type of the result, or of the elements of the range (`[FILL]`,
    /// `[SHIFT]`).
    Value,
    /// A tag or literal of a comparison: the operands agree among themselves.
    Compared,
    /// A tag or literal of any elementary type, converted or taken apart (`[TYP]`, `[UNPACK]`).
    Convertible,
    /// An integer or a bit string, kept in its own type and cut to the bits of the result (`[WRAP]`).
    Wrapped,
    /// Any integer: a count, selector or index; it takes no part in the result's type.
    Integer,
    /// A STRING tag or literal, whatever the result's type (the string functions, `[FMT]`).
    String,
    /// Any integer or real, converted to the result's type (`[TRUNC]`: a real into an integer, as in IEC).
    Number,
    /// A TIME, or a plain integer in milliseconds (PT).
    Duration,
    /// A TIME: the time base `B` of profile `iot`, see [`Operand::profiles`].
    Time,
    /// A DINT (PV of a counter).
    Count,
    /// A `[CALC]` expression; it may hold everything of LANGUAGE §5.2's list.
    Expression,
    /// An array range, or an element from which on a range of matching length is meant.
    Range,
    /// A range, or one STRING tag or literal (`[PACK]`, `[UNPACK]`).
    RangeOrValue,
    /// A label's name.
    Label,
    /// A function's name.
    Function,
    /// One of `EQ NE GT GE LT LE`.
    SearchOperator,
    /// Any tag (`[PERSIST]`).
    Tag,
}
