//! Blocks that a program brings along for what no single instruction says: each is an element of the fork, written in
//! ordinary blocks. Export knows them by their name and their text.

mod definition;

use crate::field::Slot;
use crate::model::Dialect;
pub(crate) use definition::definition_in;
use ladder_format::program::{Block, Invalid, Item, Operand};
use ladder_instructions::{Op, Shape};

/// An element of the fork that becomes a block of its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Made {
    /// `COIL y 0 0 0 1`: a coil that changes over.
    Toggle,
    /// `OSL`: low for one scan after a fall.
    OneShotLow,
    /// `ODR`: low for one scan after a rise.
    OneDropRising,
    /// `OSC`
    Oscillator,
    /// `SHR y a n`
    ShiftRight,
    /// `BIN2BCD y a`
    ToBcd,
    /// `BCD2BIN y a`
    FromBcd,
    /// `SWAP y a`
    Swap,
    /// `OPPOSITE y a`
    Opposite,
    /// `TIME2COUNT y delay adjust`, in scans.
    TimeToCount,
    /// `SET_BIT y n`, where `n` is a variable.
    SetBit,
    ClearBit,
    /// `IF_BIT_SET a n`, where `n` is a variable.
    IfBitSet,
    IfBitClear,
    /// `7SEGMENTS y a C`
    Segments(Segments),
    /// `RTL t delay adjust` and the like, counted in scans.
    Timer(MadeTimer),
    /// `CTU c max init kind` and the like.
    Counter(MadeCounter),
}

/// A character for a display of seven segments.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Segments {
    /// A segment is lit by a low bit, else by a high one.
    pub(crate) anode: bool,
    /// The character is a number, or is in no plain variable: LDmicro changes a variable that holds no character.
    pub(crate) fixed: bool,
}

/// A timer that is not among those of LDmicro 2.2, or whose delay is a variable.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum MadeTimer {
    /// `TON` whose delay is a variable.
    On,
    /// `RTL`
    RetentiveLow,
    /// `TCY`
    Cyclic,
    /// `THI`
    High,
    /// `TLO`
    Low,
}

/// A counter of the fork.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct MadeCounter {
    pub(crate) count: Count,
    pub(crate) kind: Kind,
    /// It begins at the value of a variable.
    pub(crate) from_variable: bool,
}

/// Which way a counter counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Count {
    /// `CTU`
    Up,
    /// `CTD`
    Down,
    /// `CTC`
    Round,
    /// `CTR`
    Reverse,
}

/// In which scans a counter counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Kind {
    /// `/`
    Rising,
    /// `\`
    Falling,
    /// `-`
    High,
    /// `o`
    Low,
}

impl Kind {
    const ALL: [Kind; 4] = [Kind::Rising, Kind::Falling, Kind::High, Kind::Low];

    /// As the last field of a counter has it.
    const fn sign(self) -> &'static str {
        match self {
            Kind::Rising => "/",
            Kind::Falling => "\\",
            Kind::High => "-",
            Kind::Low => "o",
        }
    }

    pub(crate) fn of(sign: &str) -> Option<Kind> {
        Kind::ALL.into_iter().find(|kind| kind.sign() == sign)
    }

    const fn suffix(self) -> &'static str {
        match self {
            Kind::Rising => "",
            Kind::Falling => "fall",
            Kind::High => "high",
            Kind::Low => "low",
        }
    }
}

impl Count {
    const ALL: [Count; 4] = [Count::Up, Count::Down, Count::Round, Count::Reverse];

    const fn word(self) -> &'static str {
        match self {
            Count::Up => "CTU",
            Count::Down => "CTD",
            Count::Round => "CTC",
            Count::Reverse => "CTR",
        }
    }

    pub(crate) fn of(word: &str) -> Option<Count> {
        Count::ALL.into_iter().find(|count| count.word() == word)
    }

    /// Whether it begins again at its first value, so that it needs it all the time.
    pub(crate) const fn returns(self) -> bool {
        matches!(self, Count::Round | Count::Reverse)
    }
}

impl MadeTimer {
    const ALL: [MadeTimer; 5] = [
        MadeTimer::On,
        MadeTimer::RetentiveLow,
        MadeTimer::Cyclic,
        MadeTimer::High,
        MadeTimer::Low,
    ];

    const fn word(self) -> &'static str {
        match self {
            MadeTimer::On => "TON",
            MadeTimer::RetentiveLow => "RTL",
            MadeTimer::Cyclic => "TCY",
            MadeTimer::High => "THI",
            MadeTimer::Low => "TLO",
        }
    }
}

impl Made {
    fn all() -> impl Iterator<Item = Made> {
        let plain = [
            Made::Toggle,
            Made::OneShotLow,
            Made::OneDropRising,
            Made::Oscillator,
            Made::ShiftRight,
            Made::ToBcd,
            Made::FromBcd,
            Made::Swap,
            Made::Opposite,
            Made::TimeToCount,
            Made::SetBit,
            Made::ClearBit,
            Made::IfBitSet,
            Made::IfBitClear,
        ];
        let segments = [(false, false), (false, true), (true, false), (true, true)]
            .map(|(anode, fixed)| Made::Segments(Segments { anode, fixed }));
        let counters = Count::ALL.into_iter().flat_map(|count| {
            Kind::ALL.into_iter().flat_map(move |kind| {
                [false, true].map(|from_variable| {
                    Made::Counter(MadeCounter {
                        count,
                        kind,
                        from_variable,
                    })
                })
            })
        });
        let timers = MadeTimer::ALL.into_iter().map(Made::Timer);
        plain.into_iter().chain(segments).chain(timers).chain(counters)
    }

    /// The block that does to a bit which a variable says what an instruction does to a fixed one, and its operands.
    pub(super) const fn of_bit(op: Op) -> Option<(Made, &'static [Slot])> {
        const CHANGES: &[Slot] = &[Slot::Place, Slot::Value];
        const READS: &[Slot] = &[Slot::Value, Slot::Value];
        Some(match op {
            Op::SetCoil => (Made::SetBit, CHANGES),
            Op::ResetCoil => (Made::ClearBit, CHANGES),
            Op::Contact => (Made::IfBitSet, READS),
            Op::NegatedContact => (Made::IfBitClear, READS),
            _ => return None,
        })
    }

    /// The block with this name, which begins with `$`, whatever its case.
    pub(crate) fn named(name: &str) -> Option<Made> {
        let name = name.strip_prefix('$')?;
        Made::all().find(|made| made.name().eq_ignore_ascii_case(name))
    }

    /// `CTUfall`
    fn name(self) -> String {
        let word = match self {
            Made::Toggle => "T",
            Made::OneShotLow => "OSL",
            Made::OneDropRising => "ODR",
            Made::Oscillator => "OSC",
            Made::ShiftRight => "SHR",
            Made::ToBcd => "BIN2BCD",
            Made::FromBcd => "BCD2BIN",
            Made::Swap => "SWAP",
            Made::Opposite => "OPPOSITE",
            Made::TimeToCount => "TIME2COUNT",
            Made::SetBit => "SETBIT",
            Made::ClearBit => "CLEARBIT",
            Made::IfBitSet => "IFBITSET",
            Made::IfBitClear => "IFBITCLEAR",
            Made::Timer(timer) => timer.word(),
            Made::Segments(segments) => {
                let common = if segments.anode { "anode" } else { "" };
                let fixed = if segments.fixed { "of" } else { "" };
                return format!("SEGMENTS7{common}{fixed}");
            }
            Made::Counter(counter) => {
                let from = if counter.from_variable { "from" } else { "" };
                return format!("{}{}{from}", counter.count.word(), counter.kind.suffix());
            }
        };
        word.to_owned()
    }

    const fn shape(self) -> Shape {
        match self {
            Made::Toggle => Shape::Coil,
            _ => Shape::Logical,
        }
    }

    /// As it is on a rung, without its operands.
    pub(crate) fn head(self) -> String {
        let (open, close) = self.shape().brackets();
        format!("{open}${}{close}", self.name())
    }

    /// As it is on a rung.
    pub(crate) fn block(self, operands: Vec<Operand>) -> Result<Block, Invalid> {
        Block::user_in(self.shape(), self.name(), operands)
    }

    /// The definition that the program brings along.
    pub(crate) fn item(self) -> Item {
        Item::Text(self.definition())
    }

    /// The line of the element. `given` are its operands in LDmicro's spelling, `initial` the first value of what it
    /// changes.
    pub(crate) fn line(self, given: &[String], initial: i64, dialect: Dialect) -> String {
        let first = given.first().map_or("", String::as_str);
        match self {
            Made::Toggle => format!("COIL {first} 0 0 0 1"),
            Made::OneShotLow => "OSL".to_owned(),
            Made::OneDropRising => "ODR".to_owned(),
            Made::Oscillator => "OSC".to_owned(),
            Made::ShiftRight => format!("SHR {}", given.join(" ")),
            Made::ToBcd => format!("BIN2BCD {}", given.join(" ")),
            Made::FromBcd => format!("BCD2BIN {}", given.join(" ")),
            Made::Swap => format!("SWAP {}", given.join(" ")),
            Made::Opposite => format!("OPPOSITE {}", given.join(" ")),
            Made::SetBit => format!("SET_BIT {}", given.join(" ")),
            Made::ClearBit => format!("CLEAR_BIT {}", given.join(" ")),
            Made::IfBitSet => format!("IF_BIT_SET {}", given.join(" ")),
            Made::IfBitClear => format!("IF_BIT_CLEAR {}", given.join(" ")),
            Made::Segments(segments) => {
                let common = if segments.anode { "A" } else { "C" };
                format!("7SEGMENTS {} {common}", given.join(" "))
            }
            Made::TimeToCount => {
                let scans = given.get(1).and_then(|scans| scans.parse::<u64>().ok());
                let delay = scans.unwrap_or(0).saturating_mul(dialect.cycle);
                format!("TIME2COUNT {first} {delay} 0")
            }
            Made::Timer(timer) => {
                let period = given.get(1).map_or("0", String::as_str);
                match period.parse::<u64>() {
                    Ok(scans) => {
                        let delay = scans.saturating_mul(dialect.cycle);
                        format!("{} {first} {delay} 0", timer.word())
                    }
                    Err(_) => format!("{} {first} {period} 0", timer.word()),
                }
            }
            Made::Counter(counter) => {
                let max = given.get(1).map_or("0", String::as_str);
                let init = match given.get(2) {
                    Some(init) => init.clone(),
                    None => initial.to_string(),
                };
                let sign = counter.kind.sign();
                format!("{} {first} {max} {init} {sign}", counter.count.word())
            }
        }
    }
}
