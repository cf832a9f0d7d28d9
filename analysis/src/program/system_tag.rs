//! The tags of `SYS` (LANGUAGE §4), in one table: their names, their types and what they hold.

use crate::values::types::Scalar;

/// A system tag: read-only.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum SystemTag {
    FirstScan,
    Scan,
    Time,
    ScanTime,
    Fault,
    On,
    Off,
    Clock(Clock),
}

/// A square wave over `SYS.TIME`, low in the first half of its period.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Clock {
    TenMilliseconds,
    HundredMilliseconds,
    HalfSecond,
    Second,
    Minute,
    Hour,
}

impl Clock {
    /// All of them, the fastest first.
    pub const ALL: [Clock; 6] = [
        Clock::TenMilliseconds,
        Clock::HundredMilliseconds,
        Clock::HalfSecond,
        Clock::Second,
        Clock::Minute,
        Clock::Hour,
    ];

    /// How long it takes from one rise to the next, in nanoseconds.
    pub const fn period(self) -> i64 {
        const MILLISECOND: i64 = 1_000_000;
        match self {
            Clock::TenMilliseconds => 10 * MILLISECOND,
            Clock::HundredMilliseconds => 100 * MILLISECOND,
            Clock::HalfSecond => 500 * MILLISECOND,
            Clock::Second => 1000 * MILLISECOND,
            Clock::Minute => 60_000 * MILLISECOND,
            Clock::Hour => 3_600_000 * MILLISECOND,
        }
    }
}

impl SystemTag {
    /// All of them, in the order in which they are listed.
    pub const ALL: [SystemTag; 13] = [
        SystemTag::FirstScan,
        SystemTag::Scan,
        SystemTag::Time,
        SystemTag::ScanTime,
        SystemTag::Fault,
        SystemTag::On,
        SystemTag::Off,
        SystemTag::Clock(Clock::TenMilliseconds),
        SystemTag::Clock(Clock::HundredMilliseconds),
        SystemTag::Clock(Clock::HalfSecond),
        SystemTag::Clock(Clock::Second),
        SystemTag::Clock(Clock::Minute),
        SystemTag::Clock(Clock::Hour),
    ];

    /// The tag that a word after `SYS.` means.
    pub fn from_name(name: &str) -> Option<SystemTag> {
        let named = |tag: &SystemTag| tag.name().eq_ignore_ascii_case(name);
        SystemTag::ALL.into_iter().find(named)
    }

    /// Its name after `SYS.`.
    pub const fn name(self) -> &'static str {
        match self {
            SystemTag::FirstScan => "FIRST_SCAN",
            SystemTag::Scan => "SCAN",
            SystemTag::Time => "TIME",
            SystemTag::ScanTime => "SCAN_TIME",
            SystemTag::Fault => "FAULT",
            SystemTag::On => "ON",
            SystemTag::Off => "OFF",
            SystemTag::Clock(Clock::TenMilliseconds) => "CLOCK_10MS",
            SystemTag::Clock(Clock::HundredMilliseconds) => "CLOCK_100MS",
            SystemTag::Clock(Clock::HalfSecond) => "CLOCK_500MS",
            SystemTag::Clock(Clock::Second) => "CLOCK_1S",
            SystemTag::Clock(Clock::Minute) => "CLOCK_1M",
            SystemTag::Clock(Clock::Hour) => "CLOCK_1H",
        }
    }

    /// Its type.
    pub const fn ty(self) -> Scalar {
        match self {
            SystemTag::Scan => Scalar::Dint,
            SystemTag::Time | SystemTag::ScanTime => Scalar::Time,
            _ => Scalar::Bool,
        }
    }

    /// What it holds, as a sentence.
    pub const fn about(self) -> &'static str {
        match self {
            SystemTag::FirstScan => "High in the first scan.",
            SystemTag::Scan => "The number of this scan, from 0.",
            SystemTag::Time => "The time since the start.",
            SystemTag::ScanTime => "The interval before this scan; 0 in the first.",
            SystemTag::Fault => "A fault was recorded in the previous scan.",
            SystemTag::On => "Always high.",
            SystemTag::Off => "Always low.",
            SystemTag::Clock(Clock::TenMilliseconds) => "A clock: 5 ms low, 5 ms high, and so on.",
            SystemTag::Clock(Clock::HundredMilliseconds) => "A clock: 50 ms low, 50 ms high, and so on.",
            SystemTag::Clock(Clock::HalfSecond) => "A clock: 250 ms low, 250 ms high, and so on.",
            SystemTag::Clock(Clock::Second) => "A clock: half a second low, half a second high, and so on.",
            SystemTag::Clock(Clock::Minute) => "A clock: 30 s low, 30 s high, and so on.",
            SystemTag::Clock(Clock::Hour) => "A clock: 30 minutes low, 30 minutes high, and so on.",
        }
    }

    /// All names with `SYS.` before them, for messages.
    pub fn list() -> String {
        let names: Vec<String> = SystemTag::ALL
            .iter()
            .map(|tag| format!("SYS.{}", tag.name()))
            .collect();
        names.join(" ")
    }
}
