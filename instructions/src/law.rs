//! What programs of a profile do otherwise (LANGUAGE §5.8): one value for each difference.
//!
//! Whoever must tell profiles apart asks for the one difference that it is about, never for the profile: a new profile
//! is a new [`Law`], and nothing else where its differences are among these.

use crate::Profile;

/// The differences of a profile. [`Law::IEC`] is what the language says where nothing else is said.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Law {
    /// What timers count.
    pub timing: Timing,
    /// How counters count.
    pub counting: Counting,
    /// Who may use the tag of a timer or counter.
    pub states: States,
    /// The width of counters, and of integers whose type nothing else gives.
    pub integers: Width,
    /// The width of reals whose type nothing else gives.
    pub reals: Width,
    /// In which type arithmetic is done.
    pub arithmetic: Arithmetic,
    /// What an integer divided by zero gives.
    pub division: Division,
    /// What a contact, or anything else that asks for a BOOL, takes.
    pub truth: Truth,
    /// Where the memory of an edge is kept.
    pub edges: Edges,
    /// The power behind `(S)`.
    pub set_power: SetPower,
    /// What `<MCR>` does.
    pub relay: Relay,
    /// What `[LUT]` and `[PWL]` give outside their table.
    pub tables: Tables,
    /// How the serial port sends.
    pub serial: Serial,
}

/// What timers count.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Timing {
    /// Time by the clock: PT and ET are TIME.
    Clock,
    /// Scans: ET is an integer, and PT as many as the scan interval goes into the delay, less one.
    Scans,
    /// Steps of a time base `B`, at most one in each scan: PT and ET are integers.
    Ticks,
}

/// How counters count.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Counting {
    /// To the limits of DINT, where they stay.
    Saturating,
    /// In 16 bits that wrap; the output is high from PV on, whichever way is counted.
    Wrapping,
    /// In 32 bits that wrap; that PV was reached is kept until a reset, and shows only while EN is high.
    Latching,
}

/// Who may use the tag of a timer or counter.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum States {
    /// One block, and what clears it.
    OneBlock,
    /// Any: several blocks of one sort, and instructions that write the count.
    Shared,
}

/// How wide numbers are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Width {
    Bits16,
    Bits32,
    Bits64,
}

/// In which type arithmetic is done.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Arithmetic {
    /// In that of the result.
    OfResult,
    /// As in C: in that of the operands, 32 bits at least; the value is then cut to the result's type.
    OfOperands,
}

/// What an integer divided by zero gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Division {
    /// A fault, and no result.
    Fault,
    /// 0; the scan is the last one.
    ZeroAndEnd,
}

/// What may stand where a BOOL is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Truth {
    /// A BOOL.
    Bool,
    /// Any number: it is true unless it is 0.
    NotZero,
}

/// Where the memory of an edge is kept.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Edges {
    /// With the place in the text.
    OfPlace,
    /// With the tag: all edges of one tag share it.
    OfTag,
}

/// The power behind `(S)`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum SetPower {
    /// The tag.
    Tag,
    /// EN.
    En,
}

/// What `<MCR>` does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Relay {
    /// Gives its EN to the rails; its own network is always live.
    Power,
    /// The same while the rails are live; while they are dead it makes them live. Its own network is like any other.
    Toggle,
}

/// What `[LUT]` and `[PWL]` give outside their table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Tables {
    /// `[LUT]` a fault, `[PWL]` the value at its end.
    Bounded,
    /// Nothing is written and nothing is said; below its first point `[PWL]` goes on with its first line. It
    /// computes in 16 bits.
    Open,
}

/// How the serial port sends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Serial {
    /// All at once.
    AtOnce,
    /// A byte each second scan: blocks wait until it is free, and their power tells that they are not done.
    EverySecondScan,
}

impl Law {
    /// The language as it is.
    pub const IEC: Law = Law {
        timing: Timing::Clock,
        counting: Counting::Saturating,
        states: States::OneBlock,
        integers: Width::Bits32,
        reals: Width::Bits64,
        arithmetic: Arithmetic::OfResult,
        division: Division::Fault,
        truth: Truth::Bool,
        edges: Edges::OfPlace,
        set_power: SetPower::Tag,
        relay: Relay::Power,
        tables: Tables::Bounded,
        serial: Serial::AtOnce,
    };

    /// LDmicro 2.2, as its simulator does it.
    pub const LDMICRO: Law = Law {
        timing: Timing::Scans,
        counting: Counting::Wrapping,
        states: States::Shared,
        integers: Width::Bits16,
        division: Division::ZeroAndEnd,
        set_power: SetPower::En,
        relay: Relay::Toggle,
        tables: Tables::Open,
        serial: Serial::EverySecondScan,
        ..Law::IEC
    };

    /// iot-ladder-editor, as the code that it generates does it.
    pub const IOT: Law = Law {
        timing: Timing::Ticks,
        counting: Counting::Latching,
        states: States::Shared,
        reals: Width::Bits32,
        arithmetic: Arithmetic::OfOperands,
        truth: Truth::NotZero,
        edges: Edges::OfTag,
        set_power: SetPower::En,
        ..Law::IEC
    };
}

impl Profile {
    /// What its programs do otherwise.
    pub const fn law(self) -> &'static Law {
        match self {
            Profile::Iec | Profile::Click => &Law::IEC,
            Profile::Ldmicro => &Law::LDMICRO,
            Profile::Iot => &Law::IOT,
        }
    }

    /// Whether programs of this profile can run.
    pub const fn runs(self) -> bool {
        !matches!(self, Profile::Click)
    }
}
