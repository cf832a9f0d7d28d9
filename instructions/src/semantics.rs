//! What programs of a profile do otherwise (LANGUAGE §5.8): one value for each difference.
//!
//! Code that must tell profiles apart asks for the one difference that it is about, never for the profile: a new profile
//! is a new [`Semantics`], and nothing else where its differences are among these.

use crate::profile::Profile;

/// The differences of a profile. [`Semantics::IEC`] is what the language says where nothing else is reported.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Semantics {
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
    /// The sign of a remainder.
    pub remainder: Remainder,
    /// What becomes of a number that does not fit where `[TYP]` puts it.
    pub conversion: Conversion,
    /// Where the controller reports its own state.
    pub controller: Controller,
    /// What a contact, or anything else that asks for a BOOL, takes.
    pub truth: Truth,
    /// Where the memory of an edge is kept.
    pub edges: Edges,
    /// What an edge is at the first evaluation.
    pub first_edges: FirstEdges,
    /// The power after `(S)`.
    pub set_power: SetPower,
    /// The power after a timer or counter.
    pub state_power: StatePower,
    /// What `<MCR>` does.
    pub relay: Relay,
    /// What `[LUT]` and `[PWL]` give outside their table.
    pub tables: Tables,
    /// How the serial port sends.
    pub serial: Serial,
    /// Who writes tags.
    pub writers: Writers,
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
    /// Time in a unit `B`, from the scan in which it starts, and on beyond PT: PT and ET are integers of 16 bits.
    Units,
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
    /// To the limits of DINT; the output compares, from PV on up, at PV and below down, and is low while R is high.
    Comparing,
}

/// Who may use the tag of a timer or counter.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum States {
    /// One block, and what clears it.
    OneBlock,
    /// One block, and instructions that write the count.
    Writable,
    /// Any: several blocks of one sort, and instructions that write the count.
    Shared,
}

impl States {
    /// Whether instructions may write what a timer or counter counts.
    pub const fn are_written(self) -> bool {
        !matches!(self, States::OneBlock)
    }
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
    /// A formula in the widest type of its parts and its result; the value is then cut to the result's type.
    OfFormula,
    /// The same, in 32 bits at least.
    OfWideFormula,
}

/// What an integer divided by zero gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Division {
    /// A fault, and no result.
    Fault,
    /// 0; the scan is the last one.
    ZeroAndEnd,
    /// The whole result is 0, of reals too.
    Zero,
    /// The dividend. That of a remainder is 0, and of reals it is a fault.
    Dividend,
}

/// The sign of a remainder.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Remainder {
    /// That of the dividend.
    OfDividend,
    /// That of the divisor.
    OfDivisor,
}

/// What becomes of a number that does not fit where `[TYP]` puts it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Conversion {
    /// A fault; reals are rounded.
    Fault,
    /// It is held at the limit, in bit strings it loses its upper bits; reals lose their fraction.
    Clamped,
    /// It loses its upper bits; reals are rounded.
    Wrapped,
}

/// Where the controller reports its own state, and errors.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Controller {
    /// In `SYS`; what goes wrong is a fault.
    System,
    /// In the arrays SC and SD too, where a program has them: errors of numbers and addresses are relays there, and no
    /// faults.
    Banks,
}

/// What is accepted where a BOOL is required.
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

/// What an edge is at the first evaluation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum FirstEdges {
    /// What is high counts as having risen.
    Rise,
    /// What is high was high before: there is none.
    None,
}

/// The power after a timer or counter.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum StatePower {
    /// Its output.
    Output,
    /// EN.
    En,
}

/// The power after `(S)`.
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
    /// Passes its EN to the rails; its own network is always live.
    Power,
    /// The same while the rails are live; while they are dead it makes them live. Its own network is like any other.
    Toggle,
}

/// What `[LUT]` and `[PWL]` give outside their table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Tables {
    /// `[LUT]` a fault, `[PWL]` the value at its end.
    Bounded,
    /// Nothing is written and nothing is reported; below its first point `[PWL]` goes on with its first line. It
    /// computes in 16 bits.
    Open,
}

/// Who writes tags.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Writers {
    /// The program, and from outside those that are declared as inputs.
    Program,
    /// Other devices, too: a tag that is read, that the program never writes and that begins with no value of its own is an
    /// input.
    Devices,
}

/// How the serial port sends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Serial {
    /// All at once.
    AtOnce,
    /// A byte each second scan: blocks wait until it is free, and their power shows that they are not done.
    EverySecondScan,
}

impl Semantics {
    /// The language as it is.
    pub const IEC: Semantics = Semantics {
        timing: Timing::Clock,
        counting: Counting::Saturating,
        states: States::OneBlock,
        integers: Width::Bits32,
        reals: Width::Bits64,
        arithmetic: Arithmetic::OfResult,
        division: Division::Fault,
        remainder: Remainder::OfDividend,
        conversion: Conversion::Fault,
        controller: Controller::System,
        truth: Truth::Bool,
        edges: Edges::OfPlace,
        first_edges: FirstEdges::Rise,
        set_power: SetPower::Tag,
        state_power: StatePower::Output,
        relay: Relay::Power,
        tables: Tables::Bounded,
        serial: Serial::AtOnce,
        writers: Writers::Program,
    };

    /// LDmicro 2.2, as its simulator does it.
    pub const LDMICRO: Semantics = Semantics {
        timing: Timing::Scans,
        counting: Counting::Wrapping,
        states: States::Shared,
        integers: Width::Bits16,
        division: Division::ZeroAndEnd,
        set_power: SetPower::En,
        relay: Relay::Toggle,
        tables: Tables::Open,
        serial: Serial::EverySecondScan,
        ..Semantics::IEC
    };

    /// Click controllers, as their maker describes them.
    pub const CLICK: Semantics = Semantics {
        timing: Timing::Units,
        counting: Counting::Comparing,
        states: States::Writable,
        arithmetic: Arithmetic::OfFormula,
        division: Division::Zero,
        remainder: Remainder::OfDivisor,
        conversion: Conversion::Clamped,
        controller: Controller::Banks,
        reals: Width::Bits32,
        ..Semantics::IEC
    };

    /// iot-ladder-editor, as the code that it generates does it.
    pub const IOT: Semantics = Semantics {
        timing: Timing::Ticks,
        counting: Counting::Latching,
        states: States::Shared,
        reals: Width::Bits32,
        arithmetic: Arithmetic::OfOperands,
        truth: Truth::NotZero,
        edges: Edges::OfTag,
        set_power: SetPower::En,
        ..Semantics::IEC
    };

    /// Logix 5000 controllers, as their maker describes them. Their timers and counters are structures, and blocks of an
    /// imported program; those of the table differ in their power alone.
    pub const LOGIX: Semantics = Semantics {
        reals: Width::Bits32,
        arithmetic: Arithmetic::OfWideFormula,
        division: Division::Dividend,
        conversion: Conversion::Wrapped,
        first_edges: FirstEdges::None,
        set_power: SetPower::En,
        state_power: StatePower::En,
        writers: Writers::Devices,
        ..Semantics::IEC
    };
}

impl Profile {
    /// What its programs do otherwise.
    pub const fn semantics(self) -> &'static Semantics {
        match self {
            Profile::Iec => &Semantics::IEC,
            Profile::Ldmicro => &Semantics::LDMICRO,
            Profile::Click => &Semantics::CLICK,
            Profile::Iot => &Semantics::IOT,
            Profile::Logix => &Semantics::LOGIX,
        }
    }
}
