//! What a Click controller reports of itself in its arrays SC and SD, and the relays of errors.

use super::Scan;
use crate::graph::Lit;
use crate::number::Number;
use ladder_analysis::program::Clock;
use ladder_simulator::compiled::{Bit, Width, Word};

/// A relay that reports an error.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Relay {
    Zero,
    Range,
    Address,
    /// The controller stops.
    Math,
    /// None: it is a fault.
    Other,
}

const MILLISECOND: i64 = 1_000_000;

impl Scan<'_, '_> {
    /// An error of a block, where this holds. Of one that is not known each relay may be it.
    pub(super) fn signal(&mut self, at: u32, relay: Option<Relay>, faults: Lit) {
        let relays = &self.code.relays;
        let all = [
            (Relay::Zero, relays.zero),
            (Relay::Range, relays.range),
            (Relay::Address, relays.address),
            (Relay::Math, relays.math),
        ];
        let stop = relays.stop;
        for (each, bit) in all {
            let is_it = match relay {
                Some(relay) => Lit::constant(relay == each),
                None => self.open_bits("which relay reports an error is not known", at, 1)[0],
            };
            let set = self.world.graph.and(faults, is_it);
            let mut bits: Vec<Bit> = bit.into_iter().collect();
            if each == Relay::Math {
                self.faulted = self.world.graph.or(self.faulted, set);
                self.ended = self.world.graph.or(self.ended, set);
                bits.extend(stop);
            }
            for bit in bits {
                let old = self.bit(bit);
                let value = self.world.graph.or(old, set);
                self.memory.set_bit(bit, value);
            }
        }
        let is_other = match relay {
            Some(relay) => Lit::constant(relay == Relay::Other),
            None => self.open_bits("which relay reports an error is not known", at, 1)[0],
        };
        let faults = self.world.graph.and(faults, is_other);
        self.faulted = self.world.graph.or(self.faulted, faults);
    }

    /// At the start of a scan. Scans count from 1.
    pub(super) fn controller(&mut self, pool: &[u32]) {
        let [
            bits,
            first_bit,
            bit_count,
            words,
            first_word,
            word_count,
            interval,
            ..,
        ] = *pool
        else {
            return;
        };
        let place = |number: u32, first: u32, count: u32| number.checked_sub(first).filter(|n| *n < count);
        let scan = self.word(Word::SCAN);
        let mut high: Vec<(u32, Lit)> = vec![(1, Lit::TRUE)];
        high.push((2, self.bit(Bit::FIRST_SCAN)));
        high.push((3, scan.bit(0)));
        for (number, wave) in (4..).zip(Clock::ALL) {
            high.push((number, self.bit(Bit::CLOCKS.offset(wave as u32))));
        }
        high.extend([(10, Lit::TRUE), (11, Lit::TRUE)]);
        high.extend([40, 43, 44, 46].map(|number| (number, Lit::FALSE)));
        for (number, value) in high {
            if let Some(n) = place(number, first_bit, bit_count) {
                self.write_bit(Bit(bits + n), value);
            }
        }
        let next = self.world.graph.add(&scan, &Number::constant(1));
        let interval = self.word(Word(interval)).known().unwrap_or(0);
        let interval = Number::constant(i64::from((interval / MILLISECOND) as i16));
        let numbers = [
            (9, next.wrapped(Width::I16)),
            (10, interval.clone()),
            (11, interval.clone()),
            (12, interval),
        ];
        for (number, value) in numbers {
            if let Some(n) = place(number, first_word, word_count) {
                self.write_word(Word(words + n), value);
            }
        }
    }
}
