//! Errors of numbers and addresses in programs whose controller has relays for them
//! ([`Controller::Banks`](ladder_instructions::Controller)).

use crate::fault::Trouble;
use crate::memory::{Bit, Memory};

/// A relay that reports an error in a scan.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Relay {
    /// A division by zero.
    Zero,
    /// A number that does not fit.
    Range,
    /// An address that is not there.
    Address,
    /// A function outside its domain: the controller stops.
    Math,
}

impl Relay {
    /// Its number among the controller's relays.
    pub const fn number(self) -> u32 {
        match self {
            Relay::Zero => 40,
            Relay::Range => 43,
            Relay::Address => 44,
            Relay::Math => 46,
        }
    }

    /// The relay that reports a trouble.
    pub(crate) const fn of(trouble: Trouble) -> Option<Relay> {
        Some(match trouble {
            Trouble::DivisionByZero => Relay::Zero,
            Trouble::OutOfRange | Trouble::Unparsable => Relay::Range,
            Trouble::Index { .. } | Trouble::EmptyRange { .. } | Trouble::Lengths { .. } => Relay::Address,
            Trouble::Domain(_) | Trouble::NotFinite => Relay::Math,
            _ => return None,
        })
    }
}

/// The relay that stops the controller after a scan that leaves it on; the program may set it.
pub(crate) const STOP: u32 = 50;

/// Where the relays of a program are, as far as it has them.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Relays {
    pub zero: Option<Bit>,
    pub range: Option<Bit>,
    pub address: Option<Bit>,
    pub math: Option<Bit>,
    /// That of [`STOP`].
    pub stop: Option<Bit>,
}

impl Relays {
    /// Where one of them is.
    pub const fn slot(&self, relay: Relay) -> Option<Bit> {
        match relay {
            Relay::Zero => self.zero,
            Relay::Range => self.range,
            Relay::Address => self.address,
            Relay::Math => self.math,
        }
    }

    /// Whether the controller stops after the scan that has just run.
    pub fn stops(&self, memory: &Memory) -> bool {
        self.stop.is_some_and(|stop| memory.bit(stop))
    }
}
